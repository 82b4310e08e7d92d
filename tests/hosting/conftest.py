"""The built wheel, installed into an empty environment without Node.js and without a network."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import venv
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

import pytest

from tests.conftest import made_once
from tests.web.conftest import browser, browser_name, driver, open_page, site_server

__all__ = ["browser", "browser_name", "driver", "open_page", "site_server"]

ROOT = Path(__file__).parents[2]
CACHE = Path(os.environ.get("CARTS_CACHE") or ROOT / ".cache")

# Loaded by every Python of the environment: what asks for anything but this computer fails.
NO_NETWORK = """\
import socket

def _refuse(self, address, *rest, _connect=socket.socket.connect):
    if isinstance(address, tuple) and address[0] not in ("127.0.0.1", "::1", "localhost"):
        raise OSError(f"a test without a network asks for {address}")
    return _connect(self, address, *rest)

socket.socket.connect = _refuse
"""


@dataclass(frozen=True)
class Installed:
    """An environment with the wheel and what its metadata asks for, and nothing else."""

    folder: Path

    @property
    def python(self) -> Path:
        return self.folder / "bin" / "python"

    def environment(self, **more: str) -> dict[str, str]:
        """What a process there sees: no PATH to anything else, no cache of ours."""
        return {"PATH": str(self.folder / "bin"), "HOME": str(self.folder / "home"), **more}

    def run(self, *command: str, cwd: Path, **more: str) -> subprocess.CompletedProcess[str]:
        """Run a program of the environment."""
        return subprocess.run(
            [str(self.folder / "bin" / command[0]), *command[1:]], cwd=cwd, text=True,
            env=self.environment(**more), capture_output=True, check=False, encoding="utf-8",
        )  # fmt: skip

    def carts(self, *arguments: str, cwd: Path, **more: str) -> str:
        """Run `carts`, which must end well; what it printed."""
        done = self.run("carts", *arguments, cwd=cwd, **more)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout


@pytest.fixture(scope="session")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built as `make wheel` does."""

    def make(folder: Path) -> None:
        subprocess.run(
            [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)],
            cwd=ROOT, check=True, env={**os.environ, "CARTS_CACHE": str(CACHE)},
        )  # fmt: skip

    (made,) = made_once(tmp_path_factory, "wheel", make).glob("*.whl")
    return made


@pytest.fixture(scope="session")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Installed:
    """The wheel in an environment of its own."""
    made = Installed(tmp_path_factory.mktemp("installed") / "environment")
    venv.create(made.folder, symlinks=True, with_pip=False)
    (made.folder / "home").mkdir()
    (packages,) = made.folder.glob("lib/python*/site-packages")
    pip = [sys.executable, "-m", "pip", "--python", str(made.python), "install", "--quiet"]
    subprocess.run([*pip, "--no-index", "--no-deps", str(wheel)], check=True)
    (packages / "no_network.py").write_text(NO_NETWORK, encoding="utf-8")
    (packages / "no_network.pth").write_text("import no_network\n", encoding="utf-8")
    own = next(iter(metadata.distributions(path=[str(packages)])))
    for name in wanted(own.requires or [], set()):
        for entry in top_level(name):
            target = packages / entry.name
            if not target.exists():
                target.symlink_to(entry)
    return made


def wanted(requires: list[str], seen: set[str]) -> set[str]:
    """The names of all distributions that `requires` asks for here, without extras."""
    from packaging.requirements import Requirement

    for line in requires:
        requirement = Requirement(line)
        name = re.sub(r"[-_.]+", "-", requirement.name).lower()
        applies = requirement.marker is None or requirement.marker.evaluate({"extra": ""})
        if applies and name not in seen:
            seen.add(name)
            wanted(metadata.requires(name) or [], seen)
    return seen


def top_level(name: str) -> set[Path]:
    """The files and folders of a distribution, directly below site-packages."""
    found = metadata.distribution(name)
    folder = Path(str(found.locate_file(""))).resolve()
    parts = {file.parts[0] for file in found.files or [] if file.parts[0] not in ("..", ".")}
    return {folder / part for part in parts if (folder / part).exists()}
