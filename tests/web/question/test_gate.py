"""A question, or text below a scene, opens when its run was seen, and closes at a new start."""

from __future__ import annotations

from typing import Any

import pytest

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
const scene = { id: "one", dataset: {} };
globalThis.document = Object.assign(new EventTarget(), { getElementById: () => scene });
globalThis.HTMLElement = class {};
const { openAll, wait } = await import(`${source}/question/gate.js`);
const element = { dataset: { after: "one" }, answered: data.answered };
wait(element, new AbortController().signal);
const told = [];
for (const [kind, name] of data.steps) {
  if (kind === "carts-unwatched") scene.dataset = {};
  else if (name) scene.dataset[name] = "";
  const event = new Event(kind);
  Object.defineProperty(event, "target", { value: scene });
  if (kind === "key") openAll();
  else document.dispatchEvent(event);
  await null;
  told.push("opened" in element.dataset);
}
give(told);
"""
FAILS, SEEN = ["carts-error", "reason"], ["carts-watched", "watched"]
NOTHING_LEFT, AGAIN = ["carts-error", "unshown"], ["carts-unwatched", ""]


@pytest.mark.parametrize(
    ("answered", "steps", "opened"),
    [
        (False, [FAILS, SEEN], [False, True]),
        (False, [NOTHING_LEFT], [True]),
        (False, [SEEN, AGAIN, FAILS, SEEN], [True, False, False, True]),
        (True, [FAILS, AGAIN], [True, True]),
        (False, [["key", ""], SEEN, AGAIN], [True, True, True]),
    ],
    ids=["python fails", "no run is left", "begun again", "answered", "the teacher's key"],
)
def test_what_waits_opens_when_its_run_was_seen_or_none_is_left_and_waits_again_after_a_new_start(
    answered: bool, steps: list[Any], opened: list[bool]
) -> None:
    assert in_node(SCRIPT, {"answered": answered, "steps": steps}) == opened
