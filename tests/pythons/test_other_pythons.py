"""What the project promises for Python 3.11 and later holds for those that this machine has."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests import registry
from tests.pythons.found import SAME_SUMS, other_pythons

ROOT = Path(__file__).parents[2]
OTHERS = other_pythons()

IMPORT_ALL = """
import importlib, sys
for name in sys.stdin.read().split():
    try:
        importlib.import_module(name)
    except ModuleNotFoundError as missing:  # a package that this Python has not
        assert not missing.name.startswith("sim"), missing
"""
RUN_ALL = """
import hashlib, json, sys
from sim.bridge.protocol import answer
for name, plain in json.load(sys.stdin).items():
    header, points = answer({"id": 1, "kind": "run", "scene": plain, "samples": 20})
    told = json.dumps({key: header[key] for key in ("events", "final")}).encode() + bytes(points)
    print(name, hashlib.sha256(told).hexdigest())
"""
pytestmark = [
    pytest.mark.skipif(not OTHERS, reason="there is no other Python on this machine"),
    pytest.mark.parametrize("version", sorted(OTHERS)),
]


def asked(python: str, program: str, told: str) -> str:
    """What a Python says that has the project and nothing else."""
    run = subprocess.run(
        [python, "-c", program],
        input=told, cwd=ROOT, env={"PYTHONPATH": str(ROOT), "PATH": os.environ["PATH"],
                                   "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip
    assert run.returncode == 0, run.stderr[-3000:]
    return run.stdout


def test_every_module_can_be_read_in(version: str) -> None:
    """Those that need packages are read in up to there."""
    paths = sorted((ROOT / "sim").rglob("*.py"))
    names = [
        ".".join(path.relative_to(ROOT).with_suffix("").parts)
        for path in paths
        if path.name not in {"__init__.py", "__main__.py"}
    ]
    asked(OTHERS[version], IMPORT_ALL, "\n".join(names))


def test_every_scene_runs_and_to_the_last_bit_as_here(version: str) -> None:
    told = json.dumps({name: registry.plain(name) for name in registry.NAMES}, default=str)
    there = asked(OTHERS[version], RUN_ALL, told)
    if tuple(map(int, version.split("."))) >= SAME_SUMS <= sys.version_info:
        assert there == asked(sys.executable, RUN_ALL, told)
    assert len(there.splitlines()) == len(registry.NAMES)
