"""What goes wrong at a school: each time a sentence that says what happened and what to do."""

from __future__ import annotations

import io
import re
import sys
from importlib import metadata
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from sim.cli import doctor, main
from sim.cli.site import site_folder
from sim.cli.site.build import build_site
from sim.pages import runtime
from sim.pages.site import files as site_files
from tests.cli.called import carts
from tests.hosting.saving import edit


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A new site, the current folder; its pages carry no runtime."""
    monkeypatch.setattr(runtime, "pack", lambda *_, **__: None)
    monkeypatch.setattr(site_files, "scene_script", lambda: b"")
    monkeypatch.chdir(tmp_path)
    assert carts("new", "mine").exit_code == 0
    monkeypatch.chdir(tmp_path / "mine")
    return tmp_path / "mine"


@pytest.mark.parametrize("name", ["Zwei Züge #2 50%", "a b", "100% sure?", "力学", "x" * 80])
def test_a_lesson_may_have_any_name(root: Path, name: str) -> None:
    lesson = root / "worksheets" / "first-lesson.md"
    lesson.rename(lesson.with_stem(name))
    result = carts("build")
    assert result.exit_code == 0, result.output
    assert (root / "site" / "worksheets" / f"{name}.html").is_file()


def test_no_site_here_names_the_way_to_one(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(root / "worksheets")
    for command in ("build", "pack", "serve"):
        result = carts(command)
        assert result.exit_code == 2
        assert f"There is no mkdocs.yml here. Go to {root} first." in result.output
    monkeypatch.chdir(root.parent)
    assert "carts new my-lessons" in carts("build").output


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("plugins:", "plugins: [", "mkdocs.yml:"),
        ("site_name: Mine", "- a list", "mkdocs.yml: error: this is no list of settings"),
        (
            "site_id: mine",
            "site_id: M",
            "mkdocs.yml:8:14: error: extra.carts.site_id is not allowed",
        ),
        ("  - carts\n", "", "the plugin “carts” is not listed"),
        (
            "  - carts\n",
            "  - carts:\n      hostd: true\n",
            "mkdocs.yml:25:7: error: “hostd” is no setting of carts",
        ),
        ("docs_dir: worksheets", "docs_dir: nowhere", "nowhere' isn't an existing directory"),
    ],
)
def test_settings_that_are_wrong_are_named(root: Path, old: str, new: str, said: str) -> None:
    if new == "- a list":
        (root / "mkdocs.yml").write_text("- a list\n", encoding="utf-8")
    else:
        edit(root / "mkdocs.yml", old, new)
    result = carts("build")
    assert result.exit_code == 1
    assert said in result.output
    assert "Traceback" not in result.output


def test_a_place_that_cannot_be_written_to_is_named(root: Path) -> None:
    (root / "site").write_text("a file in the place of the folder", encoding="utf-8")
    result = carts("build")
    assert result.exit_code == 1
    assert f"{root / 'site'}: Not a directory. The site needs a folder that is yours" in (
        result.output
    )


@pytest.mark.parametrize("place", ["worksheets/cart.png", "worksheets/pictures"])
def test_a_link_that_leads_out_of_the_site_joins_no_zip(
    root: Path, tmp_path: Path, place: str
) -> None:
    secret = tmp_path / "secret"
    secret.mkdir()
    (secret / "marks.png").write_bytes(b"of the teacher")
    (root / place).parent.mkdir(exist_ok=True)
    (root / place).symlink_to(secret if place.endswith("s") else secret / "marks.png")
    result = carts("build")
    assert result.exit_code == 1
    assert f"{place} is a link that leads out of this site" in result.output
    (root / place).unlink()
    (root / place).symlink_to(root / "nothing.png")
    assert f"{place} is a link" in carts("pack").output


@pytest.mark.parametrize(
    ("written", "code", "said"),
    [
        ("0.1.0", 0, "made with this version"),
        ("0.0.8", 0, "made with version 0.0.8, and 0.1.0 is installed"),
        ("0.3.0", 1, "pip install --upgrade newtons-carts"),
    ],
)
def test_a_site_of_another_version_is_told(
    root: Path, written: str, code: int, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in (site_folder, doctor):
        monkeypatch.setattr(module, "__version__", "0.1.0")
    edit(root / "mkdocs.yml", f'made_with: "{metadata.version("newtons-carts")}"',
         f'made_with: "{written}"')  # fmt: skip
    looked, built = carts("doctor"), carts("build")
    assert looked.exit_code == built.exit_code == code
    assert said in looked.output
    if code:
        assert "made with newtons-carts 0.3.0, and 0.1.0 is installed" in built.output


def test_the_doctor_names_an_old_python_and_what_is_missing(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert carts("doctor").output.endswith("Everything is here.\n")
    monkeypatch.setattr(sys, "version_info", (3, 10, 2))
    monkeypatch.setattr(doctor, "find_spec", lambda _: None)
    (root / "worksheets" / "first-lesson.md").unlink()
    edit(root / "mkdocs.yml", "site_id: mine", "other: mine")
    result = carts("doctor")
    assert result.exit_code == 1
    for said in ("3.11.5 or later is needed", "Node.js is missing", "with 0 lessons",
                 "the site has no site_id", "To be mended: 4"):  # fmt: skip
        assert said in result.output, said


def test_the_doctor_needs_no_site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    result = carts("doctor")
    assert result.exit_code == 0
    assert "no site here" in result.output


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_shell_is_told_how_to_finish_words(shell: str) -> None:
    result = carts("completion", shell)
    assert result.exit_code == 0
    assert "_CARTS_COMPLETE" in result.output
    completed = CliRunner().invoke(
        main, [], prog_name="carts", complete_var="_CARTS_COMPLETE",
        env={"_CARTS_COMPLETE": "bash_complete", "COMP_WORDS": "carts do", "COMP_CWORD": "1"},
    )  # fmt: skip
    assert completed.output == "plain,doctor\n"


def test_versions_are_compared_by_their_numbers() -> None:
    assert site_folder.newer("0.10.0", "0.9.9")
    assert not site_folder.newer("", "0.1.0")
    assert not site_folder.newer("0.1.0", "0.1.0")
    assert isinstance(main, click.Group)


def test_a_wheel_has_a_runtime_for_everything_that_a_page_may_ask_for() -> None:
    from sim.pages.runtime import pins, ready

    extras = {runtime.CLASSROOM, runtime.TEACHER, runtime.MEASURED, runtime.PROOF}
    assert ready.SETS[-1] == {*pins.PACKAGES, *extras, runtime.OWN_LAW, runtime.WORLDS}
    assert [len(one) for one in ready.SETS] == sorted(len(one) for one in ready.SETS)


def test_long_work_has_a_bar_on_a_terminal_and_none_elsewhere(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from sim.cli import progress

    shown: list[str] = []

    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

        def write(self, text: str) -> int:
            shown.append(text)
            return len(text)

    monkeypatch.setattr(progress, "QUIET", 0.0)
    monkeypatch.setattr(progress, "AGAIN", 0.0)
    assert "[" not in carts("build").output
    monkeypatch.setattr(sys, "stderr", Terminal())
    assert build_site(root, hosted=False, strict=True) is not None
    bars = [text for text in shown if re.fullmatch(r"\r\[#*\.*\] \d+ %\s*", text)]
    percents = [int(bar.split("]")[1].strip(" %")) for bar in bars]
    assert percents == sorted(percents) and percents[-1] == 100
    assert shown[-1].strip() == ""  # the line is gone at the end
