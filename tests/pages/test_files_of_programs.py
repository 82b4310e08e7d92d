"""A folder also holds what programs put there: a Mac's files on a stick, packages, drafts."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.cli.site.serve import Previewer, look
from sim.pages.checks.lessons import check_paths
from sim.pages.text.lesson_list import lessons_in

OF_A_MAC = b"\x00\x05\x16\x07\x00\x02\x00\x00Mac OS X        "
SETTINGS = "site_name: Ours\ndocs_dir: pages\nplugins: [carts]\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "worksheets"
    (made / "ms").mkdir(parents=True)
    (made / "first.md").write_text("# First\n\nText.\n", encoding="utf-8")
    (made / "._first.md").write_bytes(OF_A_MAC)
    (made / "ms" / "._first.md").write_bytes(OF_A_MAC)
    return made


def test_what_a_mac_leaves_on_a_stick_is_no_lesson(folder: Path) -> None:
    assert lessons_in(folder) == [folder / "first.md"]
    assert check_paths([folder], folder.parent) == []


@pytest.mark.parametrize("place", [".venv/lib", "node_modules/some", ".git"])
def test_a_folder_is_checked_without_what_programs_put_there(folder: Path, place: str) -> None:
    (folder.parent / place).mkdir(parents=True)
    (folder.parent / place / "README.md").write_text("```scene\n```\n", encoding="utf-8")
    assert check_paths([folder.parent], folder.parent) == []


def test_a_hidden_file_that_is_named_is_checked(folder: Path) -> None:
    (found,) = check_paths([folder / "._first.md"], folder.parent)
    assert found.code == "not-text"


def test_a_file_that_is_gone_before_it_is_looked_at_was_none(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    there = Path.stat

    def gone(path: Path, **how: bool) -> object:
        if path.name == "first.md":
            raise FileNotFoundError(path)
        return there(path, **how)

    monkeypatch.setattr(Path, "stat", gone)
    assert set(look(folder)) == {folder / "._first.md", folder / "ms" / "._first.md"}


def test_a_preview_looks_where_the_site_says_that_its_pages_are(folder: Path) -> None:
    root = folder.parent
    (root / "mkdocs.yml").write_text(SETTINGS, encoding="utf-8")
    assert list(Previewer(root, root / "site").folders) == [folder, root / "pages"]


def test_what_is_saved_while_the_first_build_runs_is_built_too(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = folder.parent
    (root / "mkdocs.yml").write_text(SETTINGS, encoding="utf-8")
    preview, built = Previewer(root, root / "site"), []

    def build(changed: set[Path], *, partial: bool) -> None:
        built.append(changed)
        if len(built) == 1:
            (folder / "first.md").write_text("# First\n\nAnother text.\n", encoding="utf-8")

    monkeypatch.setattr(preview, "_build", build)
    preview.begin()
    assert len(built) == 2
    assert built[1] == {folder / "first.md"}
