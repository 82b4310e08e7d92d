"""An unchanged lesson stays as it is, to the last byte; a change changes only itself."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.pages.teach.edit import CannotWriteError, with_value
from sim.pages.teach.fields import fields
from sim.pages.teach.pieces import blocks, pieces
from sim.pages.teach.spans import values
from sim.pages.teach.withheld import WORDS, restore, withheld_findings, withhold
from sim.pages.text.yaml.source import load

ROOT = Path(__file__).parents[2]
SHIPPED = sorted([*(ROOT / "worksheets").rglob("*.md"), *(ROOT / "docs").rglob("*.md")])
LESSONS = sorted((ROOT / "worksheets").rglob("*.md"))
NAMES = [path.relative_to(ROOT).as_posix() for path in LESSONS]


def text_of(path: Path) -> str:
    return path.read_bytes().decode("utf-8")


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_the_pieces_of_a_lesson_are_the_lesson(path: Path) -> None:
    text = text_of(path)
    assert "".join(text[p.start : p.end] for p in pieces(text)) == text


@given(st.text(alphabet="`~> \t\r\n-ab:scene", max_size=120))
def test_no_text_loses_a_character_in_pieces(text: str) -> None:
    parts = pieces(text)
    assert "".join(text[p.start : p.end] for p in parts) == text
    assert all(p.start < p.end for p in parts)


@pytest.mark.parametrize("path", LESSONS, ids=NAMES)
def test_what_is_withheld_comes_back_from_the_teachers_own_file(path: Path) -> None:
    text = text_of(path)
    shipped = withhold(text)
    assert restore(shipped, text) == (text, 0)
    for block in blocks(shipped):
        for value in values(shipped, block):
            if block.name == "question" and value.path[0] in ("rubric", "note"):
                assert value.value == WORDS


def test_a_question_of_bare_words_has_nothing_to_withhold() -> None:
    """It is a mistake, shown in the page by `carts serve`."""
    text = "# A lesson\n\n```question\nWhat is this?\n```\n"
    assert withhold(text) == text
    assert restore(text, text) == (text, 0)


def test_some_lessons_do_withhold_something() -> None:
    assert sum(withhold(text_of(path)) != text_of(path) for path in LESSONS) >= 3


def test_a_lesson_saved_without_its_teachers_texts_is_refused_by_the_build() -> None:
    text = withhold(text_of(ROOT / "worksheets" / "newtons-third-law.md"))
    (found,) = withheld_findings(text, "a.md")  # once: they have one remedy
    more = text.count(WORDS) - 1
    assert more > 1
    assert f"here and in {more} more places" in found.message
    before, _, _ = text.partition(WORDS)
    assert (found.line, found.col) == (before.count("\n") + 1, len(before.splitlines()[-1]) + 1)


@pytest.mark.parametrize("path", LESSONS, ids=NAMES)
def test_a_changed_mass_is_the_only_thing_that_changes(path: Path) -> None:
    text = text_of(path)
    for index, block in enumerate(blocks(text)):
        for field in fields(text, block):
            if field.path[-1] != "mass":
                continue
            made = with_value(text, index, field.path, "0.7312 kg")
            line, col = field.place
            rows = text.splitlines(keepends=True)
            old = rows[line - 1]
            assert old[col - 1 :].startswith(field.value)
            rows[line - 1] = old[: col - 1] + "0.7312 kg" + old[col - 1 + len(field.value) :]
            assert made == "".join(rows)


def test_what_stands_at_an_end_of_the_track_is_chosen_from_a_list() -> None:
    text = text_of(ROOT / "worksheets" / "newtons-third-law.md")
    found = [field for block in blocks(text) for field in fields(text, block)]
    (field,) = [field for field in found if field.path == ("track", "right_is")]
    assert (field.group, field.label, field.kind) == ("Track", "right end is", "choice")
    assert (field.value, field.options) == ("foam", ("wall", "foam", "spring", "board"))


NASTY = ["yes", "01", "1:30", "a: b", "{x}", "# no", "a\nb", "", " ends ", '"', "'", "- x", "é≥🚂"]


@pytest.mark.parametrize("wanted", NASTY)
def test_any_text_that_is_written_is_read_again(wanted: str) -> None:
    text = text_of(ROOT / "worksheets" / "newtons-third-law.md")
    index, block = next((k, b) for k, b in enumerate(blocks(text)) if b.name == "question")
    for field in fields(text, block):
        if field.label not in ("Question", "text", "Explanation"):
            continue
        made = with_value(text, index, field.path, wanted)
        plain = load(blocks(made)[index].body).plain
        for step in field.path:
            plain = plain[step]  # type: ignore[index,assignment]
        assert str(plain).rstrip("\n") == wanted.rstrip("\n")


LAYOUT = """\
- in a list:

  ```scene
  id: kept   # a name
  # heavy
  carts:
    A: {mass: 0.5 kg,  position: 0.2 m}   # two spaces
    B: {mass: 1 kg, position: 1 m}
  title: >
    A long
    title

  until: 3 s
  ```\r
"""


@pytest.mark.parametrize(
    ("path", "wanted", "old", "new"),
    [
        (("carts", "A", "mass"), "2 kg", "mass: 0.5 kg,", "mass: 2 kg,"),
        (("until",), "4", "until: 3 s", "until: 4"),
        (("title",), "Short", "title: >\n    A long\n    title\n", "title: >\n    Short\n"),
        (("carts", "B", "position"), "x, y", "position: 1 m}", 'position: "x, y"}'),
    ],
)
def test_comments_and_layout_stay(path: tuple[str, ...], wanted: str, old: str, new: str) -> None:
    made = with_value(LAYOUT, 0, path, wanted)
    assert made == LAYOUT.replace(old, new)


def test_line_ends_of_another_system_stay() -> None:
    text = LAYOUT.replace("\r", "").replace("\n", "\r\n")
    made = with_value(text, 0, ("title",), "One\nTwo")
    assert not re.search(r"(?<!\r)\n", made)
    assert load(blocks(made)[0].body).plain["title"] == "One\nTwo\n"


def test_a_value_that_is_gone_cannot_be_written() -> None:
    with pytest.raises(CannotWriteError):
        with_value(LAYOUT, 0, ("carts", "C", "mass"), "1 kg")
    with pytest.raises(CannotWriteError):
        with_value(LAYOUT, 3, ("until",), "1 s")


def test_the_page_knows_what_stands_in_the_place_of_a_teachers_text() -> None:
    """By it the page sees after every step, Undo too, whether notes are missing."""
    source = (ROOT / "sim" / "web" / "src" / "teach" / "source.js").read_text("utf-8")
    assert f'KEPT_OUT = "{WORDS}"' in source


@pytest.mark.parametrize(
    "wanted",
    ["one\nu two", "one\ne due", "a\tb\n\tc", r"$\frac12 \nu$", 'so "it" is $\\vec F$', "cart #1"],
)
@pytest.mark.parametrize("old", ['"a"', "'a'", "a", "|\n  a"])
def test_lines_that_look_like_formulas_and_formulas_themselves_can_be_typed(
    wanted: str, old: str
) -> None:
    text = f"```question\nid: q\ntype: long\nask: {old}\n```\n"
    made = with_value(text, 0, ("ask",), wanted)
    (block,) = blocks(made)
    assert load(block.body).plain["ask"].rstrip("\n") == wanted
