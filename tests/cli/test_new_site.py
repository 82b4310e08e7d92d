"""A new site: where it goes, what it is called, and what is never overwritten."""

from __future__ import annotations

import html
import re
from pathlib import Path

import markdown
import pytest
import yaml
from click.testing import CliRunner

from sim.cli import main
from sim.cli.starter_files import quoted, site_id_of
from sim.pages.checks.lessons import USUAL_PLACES, check_paths
from sim.pages.site import lessons_only, usual_settings

ROOT = Path(__file__).parents[2]


@pytest.fixture(autouse=True)
def empty(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def new(*arguments: str) -> str:
    result = CliRunner().invoke(main, ["new", *arguments])
    assert result.exit_code == 0, result.output
    return result.output


def refused(*arguments: str) -> str:
    result = CliRunner().invoke(main, ["new", *arguments])
    assert result.exit_code in (1, 2), result.output
    return result.output


@pytest.mark.parametrize(
    ("name", "site_id"),
    [
        ("my-lessons", "my-lessons"),
        ("Physik Übungen 100%", "physik-ubungen-100"),
        ("力学", "my-lessons"),
        ("a" * 200, "a" * 33),
        ("#1", "my-lessons"),
    ],
)
def test_in_an_empty_place_a_site_is_made_that_has_no_mistakes(name: str, site_id: str) -> None:
    output = new(name)
    root = Path(name).resolve()
    assert str(root) in output
    settings = yaml.safe_load((root / "mkdocs.yml").read_text(encoding="utf-8"))
    assert re.fullmatch(rf"{site_id}-[0-9a-f]{{6}}", settings["extra"]["carts"]["site_id"])
    found = check_paths([root / place for place in USUAL_PLACES], root)
    assert {one.code for one in found} == {"placeholder"}


def test_its_own_part_is_the_settings_and_the_worksheets(empty: Path) -> None:
    new("mine")
    made = {path.relative_to("mine").as_posix() for path in Path("mine").rglob("*.*")}
    around = {".github", ".github/workflows/lessons.yml", ".gitignore", "README.md"}
    editor = {".vscode", ".vscode/scene.schema.json", ".vscode/settings.json"}
    assert made - around - editor == {"mkdocs.yml", "worksheets/first-lesson.md"}


def test_in_a_site_the_same_word_makes_a_lesson(
    empty: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    new("mine")
    monkeypatch.chdir(empty / "mine")
    assert "worksheets/second.md is written" in new("second")
    assert "order: 2" in Path("worksheets/second.md").read_text(encoding="utf-8")
    assert "worksheets/banks/forces.yml is written" in new("forces", "--bank")
    bank = Path("worksheets/banks/forces.yml").read_text(encoding="utf-8")
    block = "\n".join(line.removeprefix("#   ") for line in bank.splitlines()[2:11])
    lesson = Path("worksheets/second.md")
    lesson.write_text(f"{lesson.read_text(encoding='utf-8')}\n{block}\n", encoding="utf-8")
    assert "```quiz" in block
    found = check_paths([Path("worksheets").resolve()], Path.cwd())
    assert {one.code for one in found} == {"placeholder"}


def test_what_is_there_is_never_overwritten(empty: Path) -> None:
    Path("full").mkdir()
    Path("full/mine.txt").write_text("mine", encoding="utf-8")
    assert "not empty. Nothing was changed" in refused("full")
    assert [path.name for path in Path("full").iterdir()] == ["mine.txt"]


def test_a_folder_that_is_not_to_be_written_into_is_named(
    empty: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def no(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "mkdir", no)
    output = refused("mine")
    assert f"Nothing can be written into {empty / 'mine'}: Permission denied" in output
    assert "Go to a folder that is yours" in output


def test_a_lesson_of_ours_that_is_none_is_answered_with_those_there_are() -> None:
    assert "newtons-third-law" in refused("mine", "--like", "newtons-fourth-law")
    assert "There are: " in refused("mine", "--like", "../banks/x")
    assert not Path("mine").exists()


def test_a_lesson_is_not_taken_over_twice_with_the_same_ids(
    empty: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each of its ids was then “already used”: 28 findings, and no way out of them."""
    new("mine", "--like", "newtons-third-law")
    monkeypatch.chdir(empty / "mine")
    told = refused("other", "--like", "newtons-third-law")
    assert "worksheets/newtons-third-law.md is that lesson" in told
    assert not Path("worksheets/other.md").exists()
    new("other", "--like", "newtons-second-law")


@pytest.mark.parametrize("text", ["A lesson", "No", "a: b", 'say "so"', "C:\\carts", "#1", "1.5"])
def test_a_title_is_read_back_as_it_was_typed(text: str) -> None:
    assert yaml.safe_load(f"title: {quoted(text)} # x") == {"title": text}


@pytest.mark.parametrize("name", ["", "a", "ä", "x" * 99, "-- --", "A b C"])
def test_an_identifier_always_has_the_form_that_the_build_asks_for(name: str) -> None:
    from sim.pages.site.site_id import _SITE_ID

    assert _SITE_ID.fullmatch(site_id_of(name))


class _AnyTag(yaml.SafeLoader):
    pass


_AnyTag.add_multi_constructor("", lambda *_: None)


def test_a_site_of_lessons_alone_gets_the_markdown_and_the_look_of_this_one() -> None:
    ours = yaml.load((ROOT / "mkdocs.yml").read_text(encoding="utf-8"), _AnyTag)
    extensions = {}
    for item in ours["markdown_extensions"]:
        extensions |= item if isinstance(item, dict) else {item: {}}
    assert extensions == dict(usual_settings.EXTENSIONS)
    assert ours["theme"]["palette"] == usual_settings.PALETTE
    assert set(usual_settings.FEATURES) <= set(ours["theme"]["features"])


def test_no_heading_says_in_english_what_its_link_is() -> None:
    """The headings of lessons in other languages had title="Permanent link"."""
    configs = {"toc": usual_settings.EXTENSIONS["toc"]}
    made = markdown.markdown("# Isaac", extensions=["toc"], extension_configs=configs)
    assert 'class="headerlink"' in made
    assert "title=" not in made


LESSONS = sorted(path.stem for path in (ROOT / "worksheets").glob("*.md"))


@pytest.mark.parametrize("name", LESSONS)
def test_every_lesson_of_ours_can_be_taken_over_whole(
    name: str, empty: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    new("mine", "--like", name)
    monkeypatch.chdir(empty / "mine")
    lesson = Path("worksheets") / f"{name}.md"
    assert check_paths([Path("worksheets").resolve()], Path.cwd()) == []
    ours = (ROOT / "worksheets" / lesson.name).read_text(encoding="utf-8")
    assert lesson.read_text(encoding="utf-8").count("\n") == ours.count("\n")


@pytest.mark.parametrize(
    "title",
    [
        "Two trains: meet & greet",
        "1 < 2 > 0",
        "&amp; <b>",
        r"C:\carts",
        "*a* _b_ `c` [d] #e $f$ |g|",
    ],
)
def test_the_home_page_shows_a_title_as_it_was_typed(title: str, empty: Path) -> None:
    lesson = empty / "a.md"
    lesson.write_text(f"---\ntitle: {quoted(title)}\n---\n", encoding="utf-8")
    text = lessons_only.ready_page("index.md", title, title, {"a/": lesson}) or ""
    page = markdown.markdown(
        text.split("---\n")[-1],
        extensions=list(usual_settings.EXTENSIONS),
        extension_configs={**usual_settings.EXTENSIONS, "toc": {}},
    )
    assert html.unescape(re.sub(r"<[^>]*>", "", page)).split("\n") == [title] * 3
