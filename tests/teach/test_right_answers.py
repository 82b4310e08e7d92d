"""Which answer is right is moved by fields; everything else of the question stays as it is."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from sim.lesson.read import read_question
from sim.pages.teach.answer import teach_answer
from sim.pages.teach.fields import Field, fields
from sim.pages.teach.pieces import blocks
from sim.pages.text.yaml.source import load

ROOT = Path(__file__).parents[2]
HEAD = "id: q\ntype: {kind}\nask: Which?\noptions:\n"
LAID_OUT = """\
  # the wrong one first
  - text: A pushes, harder
    # often thought
    belief: bigger-pushes-more
  - {text: "They are: equal", correct: true}
  - neither, of course
  - 'It''s B'
  - {feedback: No., text: both}
"""


def question(kind: str = "single", options: str = LAID_OUT, indent: str = "") -> str:
    body = f"```question\n{HEAD.format(kind=kind)}{options}```\n"
    return "# A\n\n" + "".join(f"{indent}{line}\n" for line in body.splitlines())


def moved(text: str, answer: int, value: str = "true") -> dict[str, Any]:
    path = ["options", answer, "correct"]
    return teach_answer(
        {"do": "set", "text": text, "block": 0, "path": path, "value": value}
    )[0]  # fmt: skip


def options_of(text: str) -> list[tuple[str, bool]]:
    found = load(blocks(text)[0].body).plain["options"]
    both = [one if isinstance(one, dict) else {"text": one} for one in found]
    return [(one["text"], bool(one.get("correct"))) for one in both]


def rightness(text: str) -> list[Field]:
    return [field for field in fields(text, blocks(text)[0]) if field.label == "is right"]


@pytest.mark.parametrize("ends", ["\n", "\r\n"])
@pytest.mark.parametrize("indent", ["", "    "])
@pytest.mark.parametrize("answer", range(5))
def test_of_a_single_choice_the_right_answer_is_moved(answer: int, indent: str, ends: str) -> None:
    text = question(indent=indent).replace("\n", ends)
    made = moved(text, answer)["text"]
    told = [words for words, _ in options_of(text)]
    assert options_of(made) == [(words, k == answer) for k, words in enumerate(told)]
    assert "# the wrong one first" in made and "# often thought" in made
    assert made.count("\r\n") == (made.count("\n") if ends == "\r\n" else 0)
    assert [field.value for field in rightness(made)] == [
        "true" if k == answer else "false" for k in range(5)
    ]


@pytest.mark.parametrize("ends", ["\n", "\r\n"])
@pytest.mark.parametrize("indent", ["", "    "])
@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("- {text: none, belief: speed-follows-force}", "- {text: none, correct: true}"),
        (
            "- {belief: speed-follows-force, text: none, feedback: Not so.}",
            "- {text: none, correct: true, feedback: Not so.}",
        ),
        (
            "- {text: none, correct: false,\n     belief: speed-follows-force}",
            "- {text: none, correct: true}",
        ),
        ("- text: none\n    belief: speed-follows-force", "- text: none\n    correct: true"),
        (
            "- belief: speed-follows-force  # often\n    text: none\n    feedback: Not so.",
            "- text: none\n    correct: true\n    feedback: Not so.",
        ),
    ],
)
def test_an_answer_that_becomes_right_loses_the_belief_behind_it(
    before: str, after: str, indent: str, ends: str
) -> None:
    """It has none, so the build would stop at it, and no field is there to take it out."""
    other = "  - {text: yes it is, correct: %s}\n"
    text = question(options=f"  {before}\n{other % 'true'}", indent=indent)
    wanted = question(options=f"  {after}\n{other % 'false'}", indent=indent)
    made = moved(text.replace("\n", ends), 0)
    assert made == {"text": wanted.replace("\n", ends)}


def test_of_a_multiple_choice_the_others_stay_right() -> None:
    made = moved(question("multiple"), 2)["text"]
    assert [right for _, right in options_of(made)] == [False, True, True, False, False]
    back = moved(made, 1, "false")["text"]
    assert [right for _, right in options_of(back)] == [False, False, True, False, False]


def test_saying_what_stands_there_changes_nothing() -> None:
    assert moved(question(), 1)["text"] == question()
    assert moved(question(), 0, "false")["text"] == question()


def test_an_answer_of_several_lines_becomes_one_line() -> None:
    text = question(options="  - |\n    long\n  - {text: b, correct: true}\n")
    assert moved(text, 0) == {"text": text.replace("correct: true", "correct: false").replace(
        "- |\n    long", '- {text: "long\\n", correct: true}')}  # fmt: skip


def test_an_answer_that_is_not_there_is_refused() -> None:
    assert moved(question(), 5)["refused"] == "this value is no longer there"
    assert moved(question("number"), 0)["refused"]


@pytest.mark.parametrize("kind", ["idea", "matching"])
def test_where_no_answer_is_right_there_is_no_field_for_it(kind: str) -> None:
    text = question(kind, "  - one\n  - two\n")
    assert rightness(text) == []


def test_every_choice_of_our_lessons_can_have_each_answer_right() -> None:
    """Made right, and not a mistake: the question is read as the build reads it."""
    seen = 0
    for path in sorted((ROOT / "worksheets").glob("*.md")):
        text = path.read_text(encoding="utf-8")
        for index, block in enumerate(blocks(text)):
            for field in fields(text, block):
                if field.label != "is right":
                    continue
                request = {"text": text, "block": index, "path": list(field.path)}
                made = teach_answer({"do": "set", "value": "true", **request})[0]["text"]
                again = {f.path: f.value for f in fields(made, blocks(made)[index])}
                assert again[field.path] == "true"
                read_question(load(blocks(made)[index].body).plain)
                seen += 1
    assert seen > 20


def test_letters_of_every_language_stay_letters() -> None:
    text = question(options="  - Größer, நன்றி 一样\n  - {text: smaller, correct: true}\n")
    assert '  - {text: "Größer, நன்றி 一样", correct: true}\n' in moved(text, 0)["text"]


def test_what_is_said_where_a_link_of_a_diagram_is_missing_has_a_field() -> None:
    text = (
        "```question\nid: book\ntype: interactions\nask: Draw.\nobjects: [book, table]\n"
        "contact: [[book, table]]\nmissing:\n"
        "  - {between: [book, table], feedback: They do touch.}\n```\n"
    )
    found = [field for field in fields(text, blocks(text)[0]) if field.label == "feedback"]
    assert [(field.group, field.value) for field in found] == [("Missing link 1", "They do touch.")]
    path = list(found[0].path)
    changed = {"do": "set", "text": text, "block": 0, "path": path, "value": "Look."}
    assert "feedback: Look." in teach_answer(changed)[0]["text"]
