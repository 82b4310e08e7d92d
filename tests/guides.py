"""Guides of the docs, done in a copy of the project: the files they show, and commands there."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
FILE = re.compile(r"^(`{3,})\w+ title=\"([^\"]+)\"\n(.*?)^\1$", re.M | re.S)
COPIED = ("sim", "docs", "worksheets", "tests", "mkdocs.yml", "pyproject.toml", "README.md")


def shown_in(guide: str) -> dict[str, str]:
    """The text of every file that a guide shows, by its title."""
    text = (ROOT / "docs" / "developers" / guide).read_text(encoding="utf-8")
    return {place: shown for _, place, shown in FILE.findall(text)}


def copy_project(copy: Path, *folders: str) -> Path:
    """The project's folders, or some of them, and nothing that is made of them."""
    for name in folders or COPIED:
        if (ROOT / name).is_dir():
            away = shutil.ignore_patterns("__pycache__", "node_modules")
            shutil.copytree(ROOT / name, copy / name, ignore=away)
        else:
            shutil.copy(ROOT / name, copy / name)
    return copy


def python(project: Path, *words: str) -> str:
    """Run a command of the copy; what it prints."""
    done = subprocess.run(
        [sys.executable, *words],
        cwd=project,
        env=os.environ | {"PYTHONPATH": str(project)},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    return done.stdout
