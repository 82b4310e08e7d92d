"""A school in a folder."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.country.school import KEY, lay, school_files


@pytest.fixture
def school(tmp_path: Path) -> Path:
    place = tmp_path / "school"
    for k, (name, gain) in enumerate((("a1", 0.3), ("a2", 0.3), ("b1", 0.1), ("b2", 0.0))):
        lay(place / name, school_files(k, 14, prefix=name, gain=gain))
    (place / "key.json").write_bytes(KEY.content)
    return place
