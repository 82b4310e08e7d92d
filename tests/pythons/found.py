"""Pythons on this machine that the project can be used with, besides the one that runs here."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

OLDEST = (3, 11, 5)
SAME_SUMS = (3, 12)
"""Since this version `sum` of floats carries its rounding errors along (Neumaier): before, the last
digits of a run may be others."""
SAYS = "import sys; print(*sys.version_info[:3])"


def version_of(python: str) -> tuple[int, ...]:
    """(3, 12, 1); nothing for a name that stands for no Python (version managers do that)."""
    try:
        told = subprocess.run(
            [python, "-I", "-S", "-c", SAYS], capture_output=True, text=True, check=True
        )
    except (OSError, subprocess.CalledProcessError):
        return ()
    return tuple(map(int, told.stdout.split()))


def other_pythons() -> dict[str, str]:
    """The newest of each minor version, by its name such as 3.12: its path."""
    root = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"))
    named = [shutil.which(f"python3.{minor}") for minor in range(11, 20)]
    paths = [*filter(None, named), *map(str, root.glob("versions/3.*/bin/python3"))]
    versions = sorted((version_of(path), path) for path in paths)
    return {
        f"{version[0]}.{version[1]}": path
        for version, path in versions
        if version >= OLDEST and version[:2] != sys.version_info[:2]
    }
