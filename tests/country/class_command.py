"""`carts class` on the files of a school, and the table that it writes of them."""

from __future__ import annotations

from pathlib import Path

from tests.cli.called import carts_class as carts


def table(school: Path, *words: object) -> Path:
    target = school.parent / f"table-{len(list(school.parent.iterdir()))}"
    assert carts(school, "--parquet", target, *words).exit_code == 0
    return target
