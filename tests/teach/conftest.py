"""A small site of the shipped lessons, built once for double click and once for a server, for all
workers of a run."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest

from sim.cli.site.build import build_site
from tests.conftest import made_once
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


@pytest.fixture(scope="session")
def project(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A teacher's folder: mkdocs.yml and the lessons."""
    folder = tmp_path_factory.mktemp("project")
    (folder / "mkdocs.yml").write_text(SETTINGS, encoding="utf-8")
    shutil.copytree(ROOT / "worksheets", folder / "worksheets")
    before = os.environ.get("CARTS_CACHE")
    os.environ["CARTS_CACHE"] = before or str(ROOT / ".cache")
    yield folder
    if before is None:
        del os.environ["CARTS_CACHE"]


@pytest.fixture(scope="session")
def lessons(project: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Its site, for double click."""
    return made_once(tmp_path_factory, "lessons", partial(build, project, hosted=False))


@pytest.fixture(scope="session")
def hosted_lessons(project: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Its site for a server, in a folder of the server as with GitHub's pages."""

    def make(server: Path) -> None:
        build(project, server / "school" / "p", hosted=True)

    return made_once(tmp_path_factory, "server", make) / "school" / "p"


def build(project: Path, site: Path, *, hosted: bool) -> None:
    built = build_site(project, hosted=hosted, strict=False, site_dir=site)
    assert built is not None, "the lessons cannot be built: see the messages above"
