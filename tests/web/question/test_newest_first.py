"""Writes of one key while a reader types: how many are under way, and which one is kept."""

from __future__ import annotations

from typing import Any

import pytest

from tests.web.scene.given.widget_site import in_node

STORE = """
const { newestFirst } = await import(source + "/store/newest-first.js");
const began = [], open = [], said = [];
let kept = null;
const put = newestFirst((key, value) => {
  began.push(value);
  return new Promise((resolve, reject) => open.push(() => {
    if (value === data.refused) return reject(new Error("full"));
    kept = value;
    resolve();
  }));
});
const turn = () => new Promise((resolve) => setTimeout(resolve));
const type = (value) => put("why", value).then(() => said.push(value), () => said.push(-value));
for (const value of data.typed) type(value);
const at_once = [...began];
while (open.length) {
  open.shift()();
  if (data.between.length) type(data.between.shift());  // before the promise has told anybody
  await turn();
}
give({ at_once, began, kept, said });
"""

FORGETTING = """
const { GONE, newestFirst } = await import(source + "/store/newest-first.js");
let kept = [];
const open = [];
const put = newestFirst((key, value, alone) => new Promise((resolve) => open.push(() => {
  kept = value === GONE ? [] : alone ? [value] : [...kept, value];
  resolve();
})));
for (const value of data) put("why", value || GONE);
while (open.length) {
  open.shift()();
  await new Promise((resolve) => setTimeout(resolve));
}
give(kept);
"""


def typed(*values: int, between: tuple[int, ...] = (), refused: int = 0) -> Any:
    """What a store does with values 1, 2, … of a key, its writes ending one after the other."""
    return in_node(STORE, {"typed": values, "between": between, "refused": refused})


def test_of_many_keys_one_is_being_written_and_only_the_newest_waits() -> None:
    """With three under way a killed WebKit lost more: there each waits for the one before."""
    done = typed(*range(1, 101))
    assert done["at_once"] == [1]
    assert done["began"] == [1, 100]
    assert done["kept"] == 100
    assert sorted(done["said"]) == list(range(1, 101))


@pytest.mark.parametrize("count", [1, 3, 4, 7])
def test_the_newest_is_kept_whenever_it_is_typed(count: int) -> None:
    done = typed(*range(1, count + 1), between=(50, 51, 52, 53))
    assert done["kept"] == 53
    assert done["began"] == sorted(done["began"])


def test_a_write_that_is_refused_holds_up_none_after_it() -> None:
    done = typed(1, 2, 3, 4, refused=1)
    assert done["kept"] == 4
    assert -1 in done["said"]


@pytest.mark.parametrize(
    ("done", "kept"),
    [([1, 0], []), ([1, 2, 0], []), ([0, 1], [1]), ([1, 0, 2], [2]), ([1, 2, 0, 3, 4], [4])],
)
def test_what_is_forgotten_stays_so_and_what_is_typed_after_it_is_kept(
    done: list[int], kept: list[int]
) -> None:
    """0 forgets, other values are typed: all while the first is still being written."""
    assert in_node(FORGETTING, done) == kept
