"""Settings and files around a teacher's own lessons: each does what its sentence says."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

from sim.cli import doctor, starter_files
from sim.cli.site import pack
from sim.pages.offline.files import listed
from tests.cli.called import carts
from tests.pages.given.small_site import CONFIG, MakeSite, lesson, make_site

__all__ = ["make_site"]  # a fixture

FOR_SERVERS = ("_headers", "_redirects", "_config.yml", "robots.txt", "CNAME")
HIDDEN = (".DS_Store", "worksheets/.DS_Store", ".git/config", ".well-known/a/b.txt", ".nojekyll")


@pytest.mark.parametrize("name", [*FOR_SERVERS, *HIDDEN])
def test_what_a_server_may_refuse_is_not_to_be_kept_by_browsers(tmp_path: Path, name: str) -> None:
    for place in ("index.html", "a.b/_headers.html", name):
        (tmp_path / place).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / place).write_text(place, encoding="utf-8")
    assert set(listed(tmp_path)) == {"index.html", "a.b/_headers.html"}


def test_another_folder_of_lessons_is_refused_in_a_sentence(make_site: MakeSite) -> None:
    make_site(CONFIG.replace("carts]", "carts: {lessons: kursus}]"), first=lesson())
    for command in (["build"], ["pack", "--single"]):
        result = carts(*command)
        assert result.exit_code == 1
        assert "carts: lessons: kursus: lessons are read from worksheets/ alone" in result.output
    make_site(CONFIG.replace("carts]", "carts: {lessons: worksheets}]"))
    assert carts("build").exit_code == 0


def test_no_lesson_makes_no_zip_of_lessons(make_site: MakeSite) -> None:
    root = make_site()
    result = carts("pack", "--single")
    assert result.exit_code == 1
    assert "There is no lesson in worksheets/, so there is no zip." in result.output
    assert not (root / "build").exists()


@pytest.mark.parametrize(
    ("asked", "word"),
    [(["--teacher"], ""), (["--teacher-word", "CAT"], "CAT"), ([], None)],
)
def test_a_zip_asks_for_the_word_that_was_typed_and_for_no_other(
    make_site: MakeSite, monkeypatch: pytest.MonkeyPatch, asked: list[str], word: str | None
) -> None:
    make_site(CONFIG.replace("carts]", "carts: {teacher_word: OWL}]"), first=lesson())
    told: list[dict[str, object]] = []

    def build(*_: object, settings: dict[str, object], **__: object) -> None:
        told.append(settings)

    monkeypatch.setattr(pack, "build_site", build)
    carts("pack", *asked)
    assert [one.get("teacher_word") for one in told] == [word]
    assert told[0]["teacher_mode"] == bool(asked)


CLASS_TOO = CONFIG.replace(
    "{Lessons: worksheets/}]",
    "{Lessons: worksheets/}, {For teachers: [{Class results: class-results.md}]}]\n"
    "docs_dir: worksheets",
)


@pytest.mark.parametrize(
    ("asked", "there"), [([], False), (["--hosted"], True), (["--teacher"], True)]
)
def test_the_zip_for_students_has_no_page_for_the_results_of_a_class(
    make_site: MakeSite, asked: list[str], there: bool
) -> None:
    """It came with numpy and a line in their menu, for who took the # off as the texts say."""
    root = make_site(CLASS_TOO, first=lesson())
    result = carts("pack", "--out", "site.zip", *asked)
    assert result.exit_code == 0, result.output
    assert ("“Class results” is not in it" in result.output) is not there
    with zipfile.ZipFile(root / "site.zip") as archive:
        assert ("class-results.html" in archive.namelist()) is there
        menu = archive.read("worksheets/first.html").decode()
    assert ("class-results.html" in menu) is there
    assert ("For teachers" in menu) is there


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("mine", "Now: cd mine\n"),
        ("a/b/mine", "Now: cd a/b/mine\n"),
        ("../mine", "Now: cd ../mine\n"),
        ("my school/my lessons", 'Now: cd "my school/my lessons"\n'),
        ("#1", 'Now: cd "#1"\n'),
    ],
)
def test_the_way_into_a_new_site_is_the_one_that_was_typed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, typed: str, said: str
) -> None:
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    assert said in carts("new", typed).output
    assert Path(typed, "mkdocs.yml").is_file()


@pytest.fixture
def made_with_0_1(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The workflow of a site that was made with 0.1.3; the site is the current folder."""
    monkeypatch.setattr(starter_files, "__version__", "0.1.3")
    monkeypatch.chdir(tmp_path)
    assert carts("new", "mine").exit_code == 0
    monkeypatch.chdir(tmp_path / "mine")
    return tmp_path / "mine" / ".github" / "workflows" / "lessons.yml"


@pytest.mark.parametrize(
    ("pin", "installed", "told"),
    [
        ("0.1.*", "0.1.9", ""),
        ("0.1.*", "0.10.0", 'write "newtons-carts==0.10.*" there'),
        ("0.1.3", "0.1.3", ""),
        ("0.1.3", "0.1.4", 'write "newtons-carts==0.1.*" there'),
        ("0.2.*", "0.1.3", "pip install --upgrade newtons-carts"),
    ],
)
def test_the_doctor_names_the_line_that_sets_up_another_version_on_github(
    made_with_0_1: Path, monkeypatch: pytest.MonkeyPatch, pin: str, installed: str, told: str
) -> None:
    text = made_with_0_1.read_text(encoding="utf-8")
    line = 1 + text[: text.index("newtons-carts==")].count("\n")
    made_with_0_1.write_text(text.replace("==0.1.*", f"=={pin}"), encoding="utf-8")
    for module in (doctor, starter_files):
        monkeypatch.setattr(module, "__version__", installed)
    shown = carts("doctor").output
    number = pin.removesuffix(".*")
    said = f"lessons.yml:{line} sets up version {number}, and {installed} is installed"
    assert (said in shown) == bool(told), shown
    assert told in shown.partition(said)[2]


def test_the_doctor_needs_no_workflow(made_with_0_1: Path) -> None:
    made_with_0_1.unlink()
    assert "sets up version" not in carts("doctor").output
