"""The next generator: ProperDocs, a fork of MkDocs, makes the same site of the same files."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.cli.site.build import build_site
from tests.hosting.conftest import CACHE

NAMES_ITSELF = re.compile(r'<meta name="generator" content="[^"]*">')


def test_properdocs_makes_the_same_site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("CARTS_CACHE", str(CACHE))
    assert CliRunner().invoke(main, ["new", "mine"]).exit_code == 0
    ours = build_site(tmp_path / "mine", hosted=False, strict=True)
    assert ours is not None
    theirs = tmp_path / "theirs"
    done = subprocess.run(
        [sys.executable, "-m", "properdocs", "build", "--strict", "-f", "mkdocs.yml",
         "-d", str(theirs)],
        cwd=tmp_path / "mine", env={**os.environ, "DISABLE_MKDOCS_2_WARNING": "true"},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert contents(theirs) == contents(ours)


def contents(site: Path) -> dict[str, bytes | str]:
    """Every file by its path; in a page all but the line in which the generator names itself."""
    return {
        path.relative_to(site).as_posix(): NAMES_ITSELF.sub("", path.read_text(encoding="utf-8"))
        if path.suffix == ".html"
        else path.read_bytes()
        for path in site.rglob("*")
        if path.is_file()
    }
