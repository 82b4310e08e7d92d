"""A school in a folder, and the table of it: made once, and a copy for every test."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.country.class_command import carts, table
from tests.country.school import KEY, lay, school_files


@pytest.fixture(scope="session")
def _made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("country") / "school"
    for k, (name, gain) in enumerate((("a1", 0.3), ("a2", 0.3), ("b1", 0.1), ("b2", 0.0))):
        lay(place / name, school_files(k, 14, prefix=name, gain=gain))
    (place / "key.json").write_bytes(KEY.content)
    return place


@pytest.fixture(scope="session")
def _written(_made: Path) -> Path:
    return table(_made)


@pytest.fixture
def school(_made: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(_made, tmp_path / "school"))


@pytest.fixture
def school_table(_written: Path, tmp_path: Path) -> Path:
    """What `carts class --parquet` wrote of the school."""
    return Path(shutil.copytree(_written, tmp_path / "table"))


@pytest.fixture(scope="session")
def _told(_written: Path) -> str:
    return carts("--table", _written, "--json").stdout


@pytest.fixture
def school_report(_told: str) -> dict[str, Any]:
    """What `carts class --table` says of it: most of a test's time where each asks anew."""
    report: dict[str, Any] = json.loads(_told)
    return report
