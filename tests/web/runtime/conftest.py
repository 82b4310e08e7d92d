"""Sites whose Python starts, is damaged, or does what it is told."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.web.runtime.boot_site import build_site, write_stand_in


@pytest.fixture(scope="session")
def boot_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build_site(tmp_path_factory.mktemp("boot") / "site with space, ü & 100 %")


@pytest.fixture(scope="session")
def free_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A site whose Python does what it is told, with numpy and scipy at hand."""
    folder = tmp_path_factory.mktemp("free")
    source = write_stand_in(folder / "source")
    return build_site(folder / "site", packages=frozenset({"numpy", "scipy"}), source=source)


@pytest.fixture
def broken_site(boot_site: Path, tmp_path: Path) -> Path:
    """A copy of the site to damage."""
    return shutil.copytree(boot_site, tmp_path / "site")
