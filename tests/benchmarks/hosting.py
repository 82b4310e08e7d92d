"""What a teacher waits for: a cold build, the page after an edit; and what a zip weighs.

Each build is a process of its own, as `carts build` is one; the runtime has been packed before.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from sim.cli.starter_files import lesson_text, site_files

ROOT = Path(__file__).parents[2]
EDITS = 7
FEW, MANY = 50, 200
CARTS = [sys.executable, "-m", "sim"]
SITE = ("docs", "worksheets", "tests/scenes", "sim/effects", "mkdocs.yml")


def rows() -> list[dict[str, Any]]:
    """One row per goal."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        ours = folder / "ours"
        for part in SITE:
            source = ROOT / part
            (ours / part).parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if source.is_dir() else shutil.copy)(source, ours / part)
        _carts(ours, "build")  # the runtime is packed
        cold = _seconds(ours, "build")
        edit = _edit(ours, "worksheets/newtons-third-law")
        few, many = (_seconds(_site(folder / str(n), n), "build") for n in (FEW, MANY))
        small = _site(folder / "small", 4)
        _carts(small, "pack")
        zipped = (small / "build" / "site.zip").stat().st_size / 1e6
        return [
            _row("cold build of this site, runtime packed before", cold, "s", 15),
            _row("from save to page, this site, median", edit, "s", 1),
            _row(f"build of {MANY} lessons", many, "s", None),
            _row(f"a lesson of {MANY} against one of {FEW}", many / few * FEW / MANY, "×", 1.2),
            _row("zip of four lessons without numpy", zipped, "MB", 13),
        ]


def _site(root: Path, lessons: int) -> Path:
    """A new site with so many lessons of two blocks each."""
    for path, text in site_files("Many", "many-lessons").items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text, encoding="utf-8")
    (root / "worksheets").mkdir()
    for number in range(lessons):
        text = lesson_text(f"lesson-{number}", f"Lesson {number}", number + 1)
        mass = f"mass: {1 + number / 100:.2f} kg"  # no two runs are the same
        text = text.replace("mass: 1.0 kg", mass, 1)
        (root / "worksheets" / f"lesson-{number}.md").write_text(text, encoding="utf-8")
    return root


def _environment() -> dict[str, str]:
    cache = os.environ.get("CARTS_CACHE") or str(ROOT / ".cache")
    return {**os.environ, "PYTHONPATH": str(ROOT), "CARTS_CACHE": cache}


def _carts(root: Path, *arguments: str) -> None:
    done = subprocess.run(
        [*CARTS, *arguments], cwd=root, env=_environment(), text=True, capture_output=True,
        check=False,
    )  # fmt: skip
    if done.returncode:
        raise RuntimeError(done.stdout + done.stderr)


def _seconds(root: Path, *arguments: str) -> float:
    began = time.perf_counter()
    _carts(root, *arguments)
    return time.perf_counter() - began


@contextmanager
def _served(root: Path, port: int) -> Iterator[str]:
    server = subprocess.Popen(
        [*CARTS, "serve", "--port", str(port)], cwd=root, env=_environment(),
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    try:
        yield f"http://127.0.0.1:{port}/"
    finally:
        server.terminate()
        server.wait()


def _edit(root: Path, lesson: str) -> float:
    """Median s from writing a lesson to the browser's hearing of the new page, and reading it."""
    source, times = root / f"{lesson}.md", []
    with _served(root, 8765) as address:
        page = f"{address}{lesson}.html"
        _get(page, patience=120)
        for number in range(EDITS):
            epoch = re.findall(r"livereload\((\d+), ", _get(page))[0]
            time.sleep(0.5)
            began = time.perf_counter()
            with source.open("a", encoding="utf-8") as file:
                file.write(f"\n\nEdit {number}.\n")
            while int(_get(f"{address}livereload/{epoch}/1")) <= int(epoch):
                pass
            assert f"Edit {number}." in _get(page)
            times.append(time.perf_counter() - began)
    return sorted(times)[EDITS // 2]


def _get(address: str, patience: float = 0) -> str:
    until = time.monotonic() + patience
    while True:
        try:
            with urllib.request.urlopen(address, timeout=120) as answer:
                return str(answer.read(), "utf-8")
        except OSError:
            if time.monotonic() > until:
                raise
            time.sleep(0.2)


def _row(name: str, value: float, unit: str, goal: float | None) -> dict[str, Any]:
    reference = "carts in a process of its own"
    return {"name": name, "value": value, "unit": unit, "goal": goal, "reference": reference}
