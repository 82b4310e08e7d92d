"""Every mistake of an author is answered with a place, a message and a hint, word for word.

The lessons in tests/golden/author-errors are full of mistakes; beside each lies what the author
reads. After a change of wording: look at the new text, and if it is better, write it there.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.pages.blocks.makers import MAKERS
from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.blocks import CHECKS
from sim.pages.checks.lessons import check_lesson, check_paths
from sim.pages.findings import Finding

GOLDEN = Path(__file__).parents[1] / "golden" / "author-errors"
CASES = sorted(path.stem for path in GOLDEN.glob("*.md"))


def findings(name: str) -> list[Finding]:
    text = (GOLDEN / f"{name}.md").read_text(encoding="utf-8")
    lesson = Lesson(f"{name}.md", (Path("scenes"),), (Path("banks"),))
    return check_lesson(text, lesson, SiteIds())


@pytest.mark.parametrize("name", CASES)
def test_the_author_reads_exactly_this(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(GOLDEN)
    read = "".join(f"{finding}\n" for finding in findings(name))
    assert read == (GOLDEN / f"{name}.txt").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", CASES)
def test_every_finding_has_the_form_that_editors_can_follow(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(GOLDEN)
    found = findings(name)
    assert found
    for finding in found:
        assert re.match(r"\S+:[1-9]\d*:[1-9]\d*: error: \S", str(finding))
        assert finding.hint
        lines = (GOLDEN / finding.file).read_text(encoding="utf-8").splitlines()
        assert finding.line <= len(lines) + 1
        assert (
            finding.col <= len(lines[finding.line - 1]) + 1 if finding.line <= len(lines) else True
        )


def test_carts_check_prints_findings_and_exits_with_1(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(GOLDEN)
    result = CliRunner().invoke(main, ["check", "negative-mass.md"])
    assert result.exit_code == 1
    assert result.stdout.startswith("negative-mass.md:8:13: error: carts.A.mass")
    assert "  hint: " in result.stdout
    assert result.stderr == ""


def test_carts_check_json_is_a_list_of_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(GOLDEN)
    result = CliRunner().invoke(main, ["check", "--json", "scenes/bad.yml"])
    (row,) = json.loads(result.stdout)
    assert list(row) == ["file", "line", "col", "severity", "code", "message", "hint"]
    assert (row["file"], row["line"], row["severity"]) == ("scenes/bad.yml", 4, "error")
    assert result.exit_code == 1


def test_carts_check_without_findings_exits_with_0(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(GOLDEN)
    result = CliRunner().invoke(main, ["check", "scenes/two-carts.yml"])
    assert (result.exit_code, result.stdout) == (0, "no findings\n")


def test_a_path_that_does_not_exist_is_a_usage_error() -> None:
    assert CliRunner().invoke(main, ["check", "no-such-folder"]).exit_code == 2


def test_the_same_id_in_two_lessons_is_found(tmp_path: Path) -> None:
    scene = "```scene\nid: same\ncarts: {A: {mass: 1, position: 0}}\n```\n"
    for name in ("a.md", "b.md"):
        (tmp_path / name).write_text(scene, encoding="utf-8")
    (finding,) = check_paths([tmp_path], tmp_path)
    assert (finding.file, finding.code) == ("b.md", "id-taken")
    assert "a.md:2" in finding.message


def test_a_lesson_that_is_no_text_is_a_finding(tmp_path: Path) -> None:
    (tmp_path / "a.md").write_bytes(b"# Title\n\xff\xfe")
    (finding,) = check_paths([tmp_path], tmp_path)
    assert (finding.line, finding.code) == (2, "not-text")


def test_a_lesson_whose_ending_the_computer_hides_is_named(tmp_path: Path) -> None:
    (tmp_path / "forces.md.txt").write_text("# Forces\n", encoding="utf-8")
    (finding,) = check_paths([tmp_path], tmp_path)
    assert str(finding).startswith("forces.md.txt:1:1: error: this is no lesson")
    assert finding.hint == "rename it to forces.md"


@pytest.mark.parametrize("name", ["a.MD", "a.Md", "a.markdown", "a.mkd", "a.MD.TXT"])
def test_a_lesson_with_another_ending_of_markdown_is_named(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text("# Forces\n", encoding="utf-8")
    for asked in (tmp_path, tmp_path / name):
        (finding,) = check_paths([asked], tmp_path)
        assert str(finding).startswith(f"{name}:1:1: error: this is no lesson")
        assert finding.hint == "rename it to a.md"


def test_our_own_lessons_and_scenes_have_no_findings() -> None:
    root = Path(__file__).parents[2]
    assert not check_paths([root / "worksheets", root / "docs", root / "tests" / "scenes"], root)


HIDDEN = """```scene
id: a
carts:
  A: {mass: 0.5 kg, position: 0.4 m, velocity: 0.6 m/s}
  B: {mass: 2 kg, position: 1.2 m}
contact: {restitution: 0.8, stiffness: 100 N/m}
%suntil: 3 s
forces: hidden
show: [v]
```
"""


@pytest.mark.parametrize(
    ("effects", "warned"),
    [
        ("", False),
        ("effects: [{friction: {coefficient: 0.03}}]\n", True),
        ("effects: [{push: {cart: A, force: 0.2 N, until: 0.5 s}}]\n", False),
    ],
)
def test_hidden_forces_that_nobody_can_find_are_a_warning(effects: str, warned: bool) -> None:
    found = check_lesson(HIDDEN % effects, Lesson("a.md", (), ()), SiteIds())
    assert [(f.line, f.code, f.severity) for f in found] == (
        [(9, "no-force-to-find", "warning")] if warned else []
    )


def test_a_folder_of_banks_is_named_once(tmp_path: Path) -> None:
    lesson = tmp_path / "worksheets" / "a.md"
    lesson.parent.mkdir()
    lesson.write_text("```quiz\nid: q\nform: pre\nbank: force.yml\n```\n", encoding="utf-8")
    hints = [f.hint for f in check_paths([lesson], tmp_path) if "no bank" in f.message]
    assert hints == ["looked in: worksheets/banks"]


NOTE = "```scene\nid: a\ncarts: {A: {mass: 1 kg, position: 1 m}}\n```\n\n%s\n    All is open.\n"


@pytest.mark.parametrize(
    "word", ["afer", "aftr", "atfer", "After", "aftwr", "check afer", "afer a"]
)
@pytest.mark.parametrize("title", ["", ' "What was it?"'])
def test_a_misspelt_after_is_told(word: str, title: str) -> None:
    lesson = Lesson("a.md", (), ())
    found = check_lesson(NOTE % f"!!! {word}{title}", lesson, SiteIds())
    assert [(f.line, f.hint[:18]) for f in found] == [(6, "did you mean after")]


@pytest.mark.parametrize("word", ["after", "check after", "after a", "later", "water", "danger"])
def test_a_note_of_another_kind_is_no_mistake(word: str) -> None:
    assert check_lesson(NOTE % f'!!! {word} "Title"', Lesson("a.md", (), ()), SiteIds()) == []


QUIZ = """# A

```quiz
id: before
form: pre
title: Before
mode: exam
bank: small.yml
close: {date: 2021-03-01}
items: [net-force]
```
"""


def test_a_form_whose_last_day_is_over_is_a_hint() -> None:
    lesson = Lesson("a.md", (), (GOLDEN / "banks",))
    (found,) = check_lesson(QUIZ, lesson, SiteIds(), hints=True)
    assert (found.line, found.severity) == (9, "hint")
    assert "closed on 2021-03-01" in found.message
    assert not check_lesson(QUIZ, lesson, SiteIds())
    open_still = QUIZ.replace("2021", "2121")
    assert not check_lesson(open_still, lesson, SiteIds(), hints=True)


OPTIONS = "# A\n\n```question\nid: why\ntype: single\nask: Why?\noptions:\n{}```\n"


@pytest.mark.parametrize(
    ("options", "line"),
    [
        ("  {text: a, correct: true}\n  - {text: b}\n  - c\n", 8),
        ("  They are equal.\n  - A pushes harder.\n  - {text: c, correct: true}\n", 8),
        ('  "They are equal."\n\n  # the wrong one\n  - A pushes harder.\n', 8),
        ("  text: They are equal.\n  - text: A pushes harder.\n", 8),
        ("  - {text: a}\n  {text: b, correct: true}\n  - c\n", 9),
        ("  - text: a\n    correct: true\n  text: b\n  - c\n", 10),
    ],
)
def test_the_line_of_a_list_without_its_dash_is_named_and_not_the_next(
    options: str, line: int
) -> None:
    (found,) = check_lesson(OPTIONS.format(options), Lesson("a.md"), SiteIds())
    assert (found.line, found.col) == (line, 3)
    assert found.message.startswith("“- ” is missing in front of this line")


@pytest.mark.parametrize(
    "options", ["  - {text: a,\n  correct: true\n  - c\n", '  - "They are\n  equal.\n  - c\n']
)
def test_a_line_that_goes_on_needs_no_dash(options: str) -> None:
    (found,) = check_lesson(OPTIONS.format(options), Lesson("a.md"), SiteIds())
    assert "“- ”" not in found.message


def test_every_kind_of_block_that_is_made_is_checked_without_a_build() -> None:
    assert set(MAKERS) == {*CHECKS, "scene", "question", "quiz", "challenge"}
