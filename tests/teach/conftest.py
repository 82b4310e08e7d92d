"""A small site of the shipped lessons, built once for double click and once for a server."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from sim.cli.site.build import build_site
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
def lessons(project: Path) -> Path:
    """Its site, for double click."""
    built = build_site(project, hosted=False, strict=False, site_dir=project / "site")
    assert built is not None, "the lessons cannot be built: see the messages above"
    return built


@pytest.fixture(scope="session")
def hosted_lessons(project: Path) -> Path:
    """Its site for a server, in a folder of the server as with GitHub's pages."""
    built = build_site(
        project, hosted=True, strict=False, site_dir=project / "www" / "school" / "p"
    )
    assert built is not None, "the lessons cannot be built: see the messages above"
    return built
