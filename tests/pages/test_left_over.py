"""What a word processor leaves in a lesson is told, and sums of minutes wait for what is wrong."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.cli.starter_files import STARTER
from sim.pages.blocks.scene_block import Lesson
from sim.pages.checks.left_over import PLACEHOLDERS, left_over
from sim.pages.checks.lessons import check_paths
from sim.pages.findings import AUTHOR_ERROR, error_box
from sim.pages.site.last_build import text_box

QUESTION = """\
```question
id: why
type: long
ask: {ask}
rubric: {{1: a, 0: b}}
```
"""


@pytest.mark.parametrize("quotes", ["“”", "„“", "‘’", "«»"])
def test_quotes_of_a_word_processor_around_a_whole_question_are_told(
    tmp_path: Path, quotes: str
) -> None:
    """Students read them as a part of the question, and `carts check` said nothing."""
    path = tmp_path / "a.md"
    asked = f"{quotes[0]}Which is faster?{quotes[1]}"
    path.write_text("# A\n\n" + QUESTION.format(ask=asked), encoding="utf-8")
    (found,) = check_paths([path], tmp_path)
    assert (found.line, found.col, found.severity) == (6, 6, "warning")
    assert found.hint == "write it without them: Which is faster?"


@pytest.mark.parametrize(
    "ask",
    [
        "“A” or “B”?",
        "Who is right, “A” or B?",
        '"“Which?”"',
        "Which is “faster”",
    ],
)
def test_quotes_inside_a_question_or_held_by_straight_ones_are_meant(ask: str) -> None:
    assert left_over(QUESTION.format(ask=ask), "a.md", ()) == []
    assert left_over("options:\n  - {text: “I push.”, correct: true}\n", "a.md", ()) == []


OPTIONS = """\
```question
id: which
type: single
ask: Which is faster?
options:
  - {text: ONE, correct: true}
  - {text: TWO}
```

```scene
id: look
carts: {A: {mass: 1 kg, position: 0}}
predict: {ask: Look, choice: [ONE, TWO]}
```
"""


@pytest.mark.parametrize("quotes", ["“”", "„“", "‘’", "«»"])
def test_quotes_of_a_word_processor_around_every_answer_are_told(
    tmp_path: Path, quotes: str
) -> None:
    path = tmp_path / "a.md"
    one, two = (f"{quotes[0]}{words}{quotes[1]}" for words in ("the heavy one", "neither"))
    path.write_text("# A\n\n" + OPTIONS.replace("ONE", one).replace("TWO", two), encoding="utf-8")
    found = check_paths([path], tmp_path)
    assert [(f.line, f.col, f.severity) for f in found] == [(8, 12, "warning"), (15, 31, "warning")]
    assert all("around every answer" in f.message for f in found)


@pytest.mark.parametrize(
    ("one", "two"),
    [
        ("“the heavy one”", "neither"),
        ("“A pushes more.”", "“Both push alike!”"),
        ("'“heavy”'", "'“light”'"),
        ("heavy “A”", "light “B”"),
    ],
)
def test_answers_that_are_sayings_or_hold_a_quoted_word_are_meant(
    tmp_path: Path, one: str, two: str
) -> None:
    path = tmp_path / "a.md"
    path.write_text("# A\n\n" + OPTIONS.replace("ONE", one).replace("TWO", two), encoding="utf-8")
    assert check_paths([path], tmp_path) == []


def test_a_line_with_a_mistake_is_told_once(tmp_path: Path) -> None:
    path = tmp_path / "a.md"
    path.write_text("# A\n\n" + QUESTION.format(ask="“Say: which?”"), encoding="utf-8")
    assert [one.code for one in check_paths([path], tmp_path)] == ["yaml"]


def test_the_starter_has_every_placeholder_that_is_looked_for() -> None:
    text = (STARTER / "lesson.md").read_text(encoding="utf-8")
    assert all(words in text for words in PLACEHOLDERS)


def test_a_preview_adds_up_no_minutes_while_a_block_is_broken() -> None:
    """The sum stood above the mistake that the author was looking for."""
    text = "---\nminutes: 15\n---\n# A {: data-minutes=10 }\n"
    told: list[object] = []
    assert "not 15" in text_box(text, "<p>", Lesson("a.md"), told.append)
    broken = error_box(())
    assert AUTHOR_ERROR in broken
    assert text_box(text, broken, Lesson("a.md"), told.append) == ""
    assert len(told) == 1
