"""Files as editors and word processors save them: a mark before the text, signs nobody sees."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson, check_paths
from sim.pages.question.of_lesson import lesson_asks
from sim.pages.site.lessons_only import ready_page
from sim.pages.teach.frame import Site
from sim.pages.teach.pieces import blocks, pieces
from sim.pages.teach.preview import Desk
from sim.pages.teach.withheld import restore, withhold
from sim.pages.text.front_matter import lesson_order
from sim.pages.text.plain_lines import lines_of

BOM = b"\xef\xbb\xbf"
ASKS = (
    "```question\nid: why\ntype: long\nask: Why?\nrubric: {1: a reason, 0: none}\n"
    "note: secret\n```\n"
)
PREDICTS = """\
```scene
id: one
carts: {A: {mass: 1 kg, position: 0.4 m, velocity: 0.5 m/s}}
until: 2 s
predict: {text: What}
```
"""
ODD = ["\u2028", "\u2029", "\x85", "\v", "\f", "\x1c"]


def test_a_mark_before_a_lesson_hides_none_of_its_facts(tmp_path: Path) -> None:
    path = tmp_path / "worksheets" / "a.md"
    path.parent.mkdir()
    text = "---\ntitle: Mit BOM\norder: 0\ndescripton: x\n---\n\n# Other\n"
    path.write_bytes(BOM + text.encode())
    (found,) = check_paths([path], tmp_path)
    assert (found.line, found.col, found.code) == (4, 1, "unknown-key")
    assert lesson_order(path) == (0, "a.md")
    home = ready_page("index.md", "S", "", {"worksheets/a.md": path}) or ""
    assert "## [Mit BOM]" in home


def test_a_mark_before_a_bank_or_a_scene_file_is_no_mistake(tmp_path: Path) -> None:
    folder = tmp_path / "worksheets"
    (folder / "banks").mkdir(parents=True)
    bank_text = 'title: V\nitems:\n  - {id: a, type: long, ask: "Why?", rubric: {1: x, 0: y}}\n'
    (folder / "banks" / "b.yml").write_bytes(BOM + bank_text.encode())
    (folder / "two.yml").write_bytes(BOM + b"carts: {A: {mass: 1, position: 0}}\n")
    quiz = "```quiz\nid: q\nform: pre\nmode: practice\nbank: b.yml\nitems: [a]\n```\n"
    lesson = f"```scene\nid: one\nfile: two.yml\n```\n\n{quiz}"
    (folder / "a.md").write_text(lesson, encoding="utf-8")
    assert check_paths([folder], tmp_path) == []
    (folder / "two.yml").write_bytes(BOM + b"carts: {A: {mass: -1, position: 0}}\n")
    (found,) = check_paths([folder / "a.md"], tmp_path)
    assert (found.line, found.col) == (1, 19)


def test_teacher_mode_keeps_the_mark_and_reads_over_it() -> None:
    text = "\ufeff---\ntitle: A\ndescripton: B\n---\n# Head\n"
    assert "".join(text[p.start : p.end] for p in pieces(text)) == text
    assert [p.kind for p in pieces(text)] == ["top", "text"]
    look = Desk().look(text, Lesson("a.md"), Site())
    assert look.frame == "<h1>Head</h1>"
    assert [(f.line, f.col, f.code) for f in look.findings] == [(3, 1, "unknown-key")]
    bare = "\ufeff# Head\n"
    assert Desk().look(bare, Lesson("a.md"), Site()).frame == "<h1>Head</h1>"
    assert "".join(bare[p.start : p.end] for p in pieces(bare)) == bare


@pytest.mark.parametrize("sign", ODD, ids=lambda sign: f"U+{ord(sign):04X}")
def test_a_sign_that_nobody_sees_ends_no_line(sign: str) -> None:
    bad = PREDICTS.replace("mass: 1 kg", "mass: -1 kg")
    text = f"Pasted{sign}text\n\n{bad}"
    (found,) = check_lesson(text, Lesson("a.md"), SiteIds())
    assert (found.line, found.col) == (5, 19)
    (found,) = Desk().look(text, Lesson("a.md"), Site()).findings
    assert (found.line, found.col) == (5, 19)
    assert blocks(text)[0].start == 2


@pytest.mark.parametrize("sign", ["\u2028", "\u2029", "\x85"], ids=lambda s: f"U+{ord(s):04X}")
def test_nothing_for_teachers_leaks_behind_such_a_sign(sign: str) -> None:
    """YAML counts a line there: what stands behind it must still be found."""
    quoted = f'"Why{sign}then?"'
    text = f"Text\n\n{ASKS.replace('Why?', quoted)}"
    kept = withhold(text)
    assert "secret" not in kept and "a reason" not in kept
    assert restore(kept, text) == (text, 0)
    wrong = text.replace("note: secret", "nte: secret")
    (found,) = check_lesson(wrong, Lesson("a.md"), SiteIds())
    assert (found.line, found.col) == (8, 1)
    front = f'---\ntitle: "a{sign}b"\ndescripton: c\n---\n'
    (found,) = check_lesson(front, Lesson("a.md"), SiteIds())
    assert (found.line, found.col) == (3, 1)


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_lines_end_as_in_every_editor(end: str) -> None:
    text = end.join(["one", "", "two"])
    assert lines_of(text) == lines_of(text + end) == ["one", "", "two"]
    assert lines_of(text + end, keepends=True) == [f"one{end}", end, f"two{end}"]
    assert lines_of("") == []


PROGRAM = "```python\n# a comment\nx = 1\n```\n"


def test_a_comment_in_a_program_opens_no_question() -> None:
    text = f"{PROGRAM}\n{PREDICTS}\n{PROGRAM}\n{ASKS}"
    told = check_lesson(text, Lesson("a.md"), SiteIds(), hints=True)
    assert [f for f in told if "opens when “one” was watched" in f.message]
    asks = lesson_asks(f"---\n# no title\ntitle: x\n---\n{text}", Lesson("a.md"))
    assert asks.about == {"why": "one"}
    assert asks.title == ""
    titled = f"{PROGRAM}\n# The `real` one\n"
    assert lesson_asks(titled, Lesson("a.md")).title == "The `real` one"


@pytest.mark.parametrize("text", ["", "---\ntitle: x\n---\n"])
def test_a_lesson_without_a_line_asks_nothing(text: str) -> None:
    asks = lesson_asks(text, Lesson("a.md"))
    assert (asks.title, list(asks.about)) == ("", [])


def test_a_link_that_is_never_closed_is_looked_through_in_its_line() -> None:
    """Above a long program, whose signs are blanks here: the search went through all their ways."""
    text = "See [the program](\n" + (" " * 80 + "\n") * 500
    assert check_lesson(text, Lesson("a.md"), SiteIds()) == []


@pytest.mark.parametrize(
    "link",
    [
        "![a b](bild%20(1).png)",
        "![a b](bild (1).png)",
        '![a b](bild%20(1).png "one (1)")',
        "![c d](<mein bild.png>)",
        "![c d](<mein bild.png> 'a title')",
        "[c d](mein%20bild.png)",
        "![c d](mein bild.png)",
        "[x](l'eau.md#part)",
        "[x](l'eau.md 'it's')",
        '[x](l\'eau.md "He said "no"")',
    ],
)
def test_a_link_that_works_is_no_mistake(tmp_path: Path, link: str) -> None:
    for name in ("bild (1).png", "mein bild.png", "l'eau.md"):
        (tmp_path / name).touch()
    lesson = Lesson("a.md", (tmp_path,))
    assert check_lesson(f"{link} and ({link})\n", lesson, SiteIds()) == []
    broken = link.replace("il", "ii").replace("eau", "aeu")
    assert {f.code for f in check_lesson(broken, lesson, SiteIds())} == {"broken-link"}
