"""`carts class` on the files of a school, and the table that it writes of them."""

from __future__ import annotations

from pathlib import Path

from click.testing import CliRunner, Result

from sim.cli import main


def carts(*words: object) -> Result:
    return CliRunner().invoke(main, ["class", *map(str, words)])


def table(school: Path, *words: object) -> Path:
    target = school.parent / f"table-{len(list(school.parent.iterdir()))}"
    assert carts(school, "--parquet", target, *words).exit_code == 0
    return target
