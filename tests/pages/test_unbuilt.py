"""What somebody meant as a lesson, and no page is made of it, is told; and what is told is so."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson, check_paths
from sim.pages.findings import Finding
from tests.pages.given.small_site import MakeSite, lesson, make_site
from tests.pages.given.translated_site import SAID, three, write_words

__all__ = ["make_site"]  # a fixture


def codes(found: list[Finding]) -> list[tuple[str, str]]:
    return [(one.file, one.code) for one in found]


def test_a_lesson_in_a_folder_that_is_not_built_is_named(make_site: MakeSite) -> None:
    root = make_site(first=lesson())
    for name in ("nested/deep.md", "ms/first.md", "ms/old/first.md", "banks/README.md"):
        path = root / "worksheets" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("# Deep\n", encoding="utf-8")
    found = check_paths([root / "worksheets"], root)
    assert codes(found) == [
        ("worksheets/ms/old/first.md", "not-built"),
        ("worksheets/nested/deep.md", "not-built"),
    ]
    built = CliRunner().invoke(main, ["build"])
    assert built.exit_code == 0, built.output
    assert "worksheets/nested/deep.md:1:1: warning: no page is made" in built.output
    assert not (root / "site" / "worksheets" / "nested").exists()
    assert "with 2 lessons" in CliRunner().invoke(main, ["doctor"]).output


@pytest.mark.parametrize("at", ["worksheets", "."])
def test_a_catalogue_without_its_lesson_is_named(make_site: MakeSite, at: str) -> None:
    root = three(make_site)
    words = write_words(root, "first.md", SAID)
    (root / "worksheets" / "banks").mkdir()
    orphan = words.parent / "banks" / "gone.po"
    orphan.parent.mkdir()
    orphan.write_bytes(words.read_bytes())
    assert codes(check_paths([root / at], root)) == [
        ("worksheets/words/ms/banks/gone.po", "no-original")
    ]
    (root / "worksheets" / "banks" / "gone.yaml").write_text(
        "title: B\nitems:\n  - {id: a, type: long, ask: Why, rubric: {1: x, 0: y}}\n",
        encoding="utf-8",
    )
    (root / "worksheets" / "first.md").rename(root / "worksheets" / "renamed.md")
    (found,) = check_paths([root / at], root)
    assert str(found) == (
        "worksheets/words/ms/first.po:1:1: warning: there is no lesson “first” that this is a "
        "translation of\n  hint: rename it as the lesson is called now, or delete it"
    )


BANK = "title: V\nitems:\n  - {id: a, type: number, ask: How, answer: x, tolerance: 0.1}\n"
QUIZ = "```quiz\nid: q\nform: pre\nmode: practice\nbank: b.yml\nitems: [a]\n```\n"


def test_a_mistake_in_a_bank_is_told_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    banks = tmp_path / "worksheets" / "banks"
    banks.mkdir(parents=True)
    (banks / "b.yml").write_text(BANK, encoding="utf-8")
    (tmp_path / "worksheets" / "a.md").write_text(QUIZ, encoding="utf-8")
    found = check_paths([tmp_path / "worksheets"], tmp_path)
    assert {one.file for one in found} == {"worksheets/banks/b.yml"}
    assert len(found) == len({(one.line, one.col) for one in found})


IDEA = "```question\nid: first\ntype: idea\nask: What?\n```\n\n"
LATER = "```question\nid: why\ntype: long\nask: Why?\nrubric: {1: a, 0: b}\nidea: %s\n```\n"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (IDEA + LATER % "first", []),
        (IDEA + LATER % "frist", [(12, "first ideas of this page: first")]),
        (LATER % "first", [(6, "first ideas of this page: none")]),
        (LATER % "why", [(6, "first ideas of this page: none")]),
    ],
)
def test_a_first_idea_that_is_not_there_is_told(text: str, told: list[tuple[int, str]]) -> None:
    found = check_lesson(text, Lesson("a.md"), SiteIds())
    assert [(one.line, one.hint) for one in found] == told


def test_of_a_first_idea_with_mistakes_these_alone_are_told() -> None:
    bad = IDEA.replace("ask: What?", "asks: What?") + LATER % "first"
    assert {one.line for one in check_lesson(bad, Lesson("a.md"), SiteIds())} == {4}


@pytest.mark.parametrize(
    "name", ["table.csv", "data/table.csv", "scene.yml", "notes.txt", "data/deep.md"]
)
def test_a_link_to_what_stays_in_the_folder_of_lessons_has_its_line(
    make_site: MakeSite, name: str
) -> None:
    root = make_site(first=f"# A\n\nSee [this]({name}).\n")
    (root / "worksheets" / "data").mkdir()
    (root / "worksheets" / name).write_text("a: 1\n", encoding="utf-8")
    result = CliRunner().invoke(main, ["build"])
    assert result.exit_code == 1
    assert f"worksheets/first.md:3:5: error: “{name}” does not join the site" in result.output


@pytest.mark.parametrize(
    ("name", "link"),
    [
        ("worksheets/plan.PDF", "plan.PDF"),
        ("worksheets/bump.MP4", "bump.MP4"),
        ("docs/t.csv", "../docs/t.csv"),
    ],
)
def test_a_link_to_what_joins_the_site_is_no_mistake(
    make_site: MakeSite, name: str, link: str
) -> None:
    root = make_site(first=f"# A\n\nSee [this]({link}).\n")
    (root / name).write_text("x", encoding="utf-8")
    assert check_paths([root / "worksheets"], root) == []


def test_a_readme_among_the_lessons_is_the_first_page_of_their_folder(
    make_site: MakeSite, monkeypatch: pytest.MonkeyPatch
) -> None:
    from sim.pages.single import all_inside, to_download

    root = make_site(README=lesson(), first=lesson(identity="two"))
    (root / "worksheets" / "ms").mkdir()
    (root / "worksheets" / "ms" / "README.md").write_text(lesson(), encoding="utf-8")
    monkeypatch.setattr(all_inside, "runtime_scripts", lambda *_: [])
    monkeypatch.setattr(to_download, "runtime_files", lambda *_: {})
    packed = CliRunner().invoke(main, ["pack", "--single"])
    assert packed.exit_code == 0, packed.output
    assert "  index.html: " in packed.output and "  ms/index.html: " in packed.output
    hosted = CliRunner().invoke(main, ["build", "--hosted"])
    assert hosted.exit_code == 0, hosted.output
    page = (root / "site" / "worksheets" / "index.html").read_text(encoding="utf-8")
    assert '<a href="ms/index.html" hreflang="ms">' in page
    assert (root / "site/assets/carts/download/worksheets-README.txt").is_file()


def test_a_film_that_not_every_browser_plays_is_told_with_what_to_save_it_as(
    make_site: MakeSite,
) -> None:
    root = make_site(first="# A\n\n![two carts](bump.mov)\n\n![](bump.mp4)\n")
    for name in ("bump.mov", "bump.mp4"):
        (root / "worksheets" / name).write_bytes(b"x")
    found = [(one.line, one.message, one.hint) for one in check_paths([root / "worksheets"], root)]
    assert [line for line, _, _ in found] == [3, 5]
    assert "save the film as .mp4 or .webm" in str(found[0][2])
    assert found[1][1] == "this film has no words beside it"


@pytest.mark.parametrize("text", ["", "\n \n", "---\ntitle: Soon\n---\n"])
def test_a_lesson_without_a_word_is_told_and_stops_nothing(make_site: MakeSite, text: str) -> None:
    root = make_site(first=lesson())
    (root / "worksheets" / "soon.md").write_text(text, encoding="utf-8")
    (found,) = check_paths([root / "worksheets"], root)
    assert (found.file, found.code, found.severity) == ("worksheets/soon.md", "empty", "warning")


def test_carts_check_in_the_folder_of_lessons_looks_at_the_site_around_it(
    make_site: MakeSite, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = make_site(first=lesson())
    (root / "worksheets" / "soon.md").write_text("", encoding="utf-8")
    at_home = CliRunner().invoke(main, ["check"])
    monkeypatch.chdir(root / "worksheets")
    inside = CliRunner().invoke(main, ["check"])
    assert (inside.exit_code, inside.output) == (0, at_home.output)
    assert "worksheets/soon.md:1:1: warning: " in inside.output
