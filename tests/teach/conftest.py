"""A small site of some shipped lessons, built once for all workers of a run."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from sim.cli.site.build import build_site
from tests.conftest import made_once
from tests.teach.at_work import LESSON
from tests.web.conftest import browser, browser_name, driver, open_page, site_server

__all__ = ["browser", "browser_name", "driver", "open_page", "site_server"]

ROOT = Path(__file__).parents[2]
SETTINGS = """\
site_name: Our school
docs_dir: worksheets
theme: {name: material}
extra: {carts: {site_id: our-school}}
plugins: [search, carts]
"""
# The lessons that these tests open; the one that most of them open in a second language too.
OPENED = (LESSON, "momentum-and-restitution", "newtons-first-law", "return-week-1",
          "test-forces-and-motion")  # fmt: skip
TRANSLATED = f"words/zh-Hans/{LESSON}.po"


@pytest.fixture(scope="session")
def project(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A teacher's folder: mkdocs.yml and lessons."""
    folder = tmp_path_factory.mktemp("project")
    (folder / "mkdocs.yml").write_text(SETTINGS, encoding="utf-8")
    for name in ("banks", "data"):
        shutil.copytree(ROOT / "worksheets" / name, folder / "worksheets" / name)
    (folder / "worksheets" / TRANSLATED).parent.mkdir(parents=True)
    for name in (*(f"{lesson}.md" for lesson in OPENED), TRANSLATED):
        shutil.copyfile(ROOT / "worksheets" / name, folder / "worksheets" / name)
    before = os.environ.get("CARTS_CACHE")
    os.environ["CARTS_CACHE"] = before or str(ROOT / ".cache")
    yield folder
    if before is None:
        del os.environ["CARTS_CACHE"]


@pytest.fixture(scope="session")
def lessons(project: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Its site, for double click."""

    def make(folder: Path) -> None:
        built = build_site(project, hosted=False, strict=False, site_dir=folder)
        assert built is not None, "the lessons cannot be built: see the messages above"

    return made_once(tmp_path_factory, "lessons", make)
