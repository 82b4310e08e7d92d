"""What every folder of tests may use: the real site, built once."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of this repository's own site, built for double click as `make site` does."""
    from sim.cli.build import build_site

    built = build_site(ROOT, hosted=False, strict=True, site_dir=tmp_path_factory.mktemp("site"))
    assert built is not None, "the site cannot be built: see the messages above"
    return built


@pytest.fixture(scope="session")
def hosted_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same for a web server, as `carts build --hosted` does."""
    from sim.cli.build import build_site

    built = build_site(ROOT, hosted=True, strict=True, site_dir=tmp_path_factory.mktemp("hosted"))
    assert built is not None, "the site cannot be built: see the messages above"
    return built
