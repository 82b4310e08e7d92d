"""A large zip on “Class results”: read slice by slice, each file of it once, and sent once."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator
from typing import Any

import pytest

from sim.bridge import class_answer
from sim.bridge.protocol import answer
from sim.classroom.files import reading
from sim.classroom.files.reading import Outcome
from tests.classroom.given.makers import bank, random_class, sources, zipped
from tests.web.scene.given.widget_site import in_node

FILES = sources(random_class(bank(3), 20))
SENT = [
    {"name": name, "base64": b64encode(content).decode()}
    for name, content in (("class.zip", zipped(FILES)), ("bad.json", b"{"))
]
READ = {"kind": "class", "do": "read"}


@pytest.fixture
def looked_at(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """The names of files that were looked into; no slice is longer than two files."""
    names: list[str] = []
    one = reading.of_file

    def of_file(name: str, content: bytes) -> Outcome:
        names.append(name)
        return one(name, content)

    monkeypatch.setattr(reading, "of_file", of_file)
    monkeypatch.setattr(class_answer, "SLICE", -1)
    yield names
    restart()


def restart() -> None:
    """As another Python in the place of this one."""
    class_answer._intake = class_answer._Intake()


def asked(**request: Any) -> dict[str, Any]:
    return answer({**READ, **request})[0]


def test_each_file_of_a_zip_is_looked_into_once_in_however_many_slices(
    looked_at: list[str],
) -> None:
    slices = [asked(files=SENT, **{"from": 0})]
    while (following := slices[-1]["next"]) is not None:
        slices.append(asked(**{"from": following}))
    assert len(slices) >= len(FILES)
    assert looked_at == [f"class.zip/{file.name}" for file in FILES] + ["bad.json"]
    assert [row[0] for one in slices for row in one["records"]] == looked_at[:-1]
    assert [name for one in slices for name, _ in one["refused"]] == ["bad.json"]


def test_another_python_goes_on_where_the_first_one_ended_and_looks_at_nothing_twice(
    looked_at: list[str],
) -> None:
    first = asked(files=SENT, **{"from": 0})
    restart()
    assert asked(**{"from": first["next"]})["lost"]
    following = asked(files=SENT, **{"from": first["next"]})
    assert following["records"][0][0] == f"class.zip/{FILES[first['next']].name}"
    assert len(looked_at) == following["next"]


PAGE = """
  globalThis.FileReader = class {
    readAsDataURL() { this.result = "data:,abc"; this.onload(); }
  };
  const { readAll } = await import(source + "/class/intake.js");
  const asked = [];
  const answers = data.answers.map((one) => ({ records: [], ...one }));
  const ask = async (message) => (asked.push(message), answers.shift());
  const found = async ({ next }) => { if (next === data.ends) throw new Error("cleared"); };
  const file = { name: "class.zip", size: 9 };
  await readAll([file], ask, found).catch(() => {});
  give(asked.map(({ from, files }) => [from ?? null, files ? files.length : null]));
"""


@pytest.mark.parametrize(
    ("answers", "ends", "sent"),
    [
        ([{"next": 5}, {"next": 9}, {"next": None}], 0, [[0, 1], [5, None], [9, None]]),
        ([{"next": 5}, {"lost": True}, {"next": 9}, {"next": None}], 0,
         [[0, 1], [5, None], [5, 1], [9, None]]),
        ([{"next": 5}, {"next": 9}, {}], 9, [[0, 1], [5, None], [None, 0]]),
    ],
    ids=["as usual", "another Python", "everything is deleted meanwhile"],
)  # fmt: skip
def test_the_page_sends_files_once_and_again_only_where_python_has_lost_them(
    answers: list[dict[str, Any]], ends: int, sent: list[list[int | None]]
) -> None:
    assert in_node(PAGE, {"answers": answers, "ends": ends}) == sent
