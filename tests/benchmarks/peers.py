"""Other engines on the same scenes in one run: what they deliver, and what that takes.

    pip install "newtons-carts[peers]"
    make bench AREA=peers

writes `peers.json` and the table of docs/accuracy/peers.md anew. The engines are development
dependencies: nothing of them is in the site. A test holds the table to the file.
"""

from __future__ import annotations

import datetime
import json
import math
import platform
import subprocess
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.pages.runtime.node import node_program, node_version
from sim.scene import Scene
from tests.benchmarks._peers_scenes import DT, SCENES, Carts

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
FILE = HERE / "peers.json"
PAGE = ROOT / "docs" / "accuracy" / "peers.md"
BEGIN, END = "<!-- peers: begin -->", "<!-- peers: end -->"
NPM = ("matter-js", "planck", "@dimforge/rapier2d-compat", "p2-es")
LONG_ENOUGH = 0.2
NEAR = 1e-9
"""Errors below are rounding, in the table."""

Ends = list[list[list[float]]]
"""x [m] and v [m/s] of each cart at the end, per phase."""


def rows() -> list[dict[str, Any]]:
    """Measure, write file and page, and give the rows of the benchmark."""
    from tests.benchmarks import _peers_mujoco, _peers_pymunk

    scenes = [
        {"name": s.name, "phases": [s.phase(k).plain() for k in range(s.phases)]} for s in SCENES
    ]
    done = subprocess.run(
        [str(node_program()), str(HERE / "_peers.mjs")],
        input=json.dumps(scenes), capture_output=True, text=True, check=True, cwd=ROOT,
    )  # fmt: skip
    versions = {name.rpartition("/")[2].removesuffix("-compat"): _npm_version(name) for name in NPM}
    found = [one | {"version": versions[one["engine"]]} for one in json.loads(done.stdout)]
    found += [_peers_pymunk.results(SCENES, DT), _peers_mujoco.results(SCENES)]
    document = measured(found)
    FILE.write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    PAGE.write_text(with_table(PAGE.read_text(encoding="utf-8"), document), encoding="utf-8")
    return [_bench_row(row, document["engines"][0]) for row in document["engines"][1:]]


def _bench_row(row: dict[str, Any], ours: dict[str, Any]) -> dict[str, Any]:
    return {
        "name": f"{row['engine']} {row['version']}: time per simulated second, two carts",
        "value": row["two"]["us_per_second"] / ours["two"]["us_per_second"],
        "unit": "times ours",
        "goal": None,
        "reference": "exact, plain Python, with 60 states per second",
    }


def _npm_version(name: str) -> str:
    package = ROOT / "node_modules" / name / "package.json"
    return str(json.loads(package.read_text(encoding="utf-8"))["version"])


def measured(found: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """The document: ours first, then the others."""
    truth = {scene.name: ends(scene) for scene in SCENES}
    ours = {
        "engine": "this site",
        "version": "",
        "ends": truth,
        "seconds": {scene.name: _seconds(scene.scene()) for scene in SCENES},
    }
    machine = (
        f"{platform.system()} {platform.machine()}, "
        f"CPython {platform.python_version()}, Node.js {node_version()}"
    )
    return {
        "format": 1,
        "date": datetime.date.today().isoformat(),
        "machine": machine,
        "step": DT,
        "engines": [_engine(one, truth) for one in (ours, *found)],
    }


def ends(scene: Carts) -> Ends:
    """Exactly."""
    found = []
    for k in range(scene.phases):
        done = run(scene.phase(k).scene(), keep_events=False, keep_motion=False)
        found.append([[x, v] for x, v in zip(done.x, done.v, strict=True)])
    return found


def _seconds(scene: Scene) -> float:
    """Of one run with 60 states per second, the best of several."""
    best, spent = math.inf, 0.0
    while spent < LONG_ENOUGH:
        start = time.perf_counter()
        done = run(scene, keep_events=False)
        for k in range(round(scene.until / DT) + 1):
            sample(done, min(scene.until, k * DT))
        took = time.perf_counter() - start
        best, spent = min(best, took), spent + took
    return best


def _engine(one: dict[str, Any], truth: dict[str, Ends]) -> dict[str, Any]:
    """What one engine made of every scene."""
    found: dict[str, Any] = {"engine": one["engine"], "version": one["version"]}
    for scene in SCENES:
        got, true = one["ends"][scene.name], truth[scene.name]
        found[scene.name] = {
            "delivered_e": _range([_delivered(scene, run) for run in got]),
            "last_v": _range([run[-1][1] for run in got]),
            "energy": _range([_energy(scene, run) / _energy(scene, true[0]) - 1 for run in got]),
            "position_error": max(
                abs(a[0] - b[0])
                for run, exact in zip(got, true, strict=True)
                for a, b in zip(run, exact, strict=True)
            ),
            "us_per_second": 1e6 * one["seconds"][scene.name] / scene.until,
        }
    return found


def _delivered(scene: Carts, run: list[list[float]]) -> float:
    return (run[1][1] - run[0][1]) / (scene.v[0] - scene.v[1])


def _energy(scene: Carts, run: list[list[float]]) -> float:
    return math.fsum(0.5 * m * v * v for m, (_, v) in zip(scene.mass, run, strict=True))


def _range(values: list[float]) -> list[float]:
    return [min(values), max(values)]


HEAD = (
    "engine",
    "e delivered, asked for 0.8",
    "place wrong by",
    "the same, slowly: e",
    "row of ten: last cart",
    "two walls, 60 s: energy",
    "place wrong by",
    "time per second",
)


def table(document: dict[str, Any]) -> str:
    """The Markdown table of the page."""
    lines = [f"| {' | '.join(HEAD)} |", "|---" * len(HEAD) + "|"]
    for one in document["engines"]:
        cells = [
            f"{one['engine']} {one['version']}".strip(),
            _between(one["two"]["delivered_e"]),
            _metres(one["two"]["position_error"]),
            _between(one["slow"]["delivered_e"]),
            f"{_between(one['row']['last_v'])} m/s",
            _change(one["walls"]["energy"][1]),
            _metres(one["walls"]["position_error"]),
            f"{_two_figures(one['two']['us_per_second'])} µs",
        ]
        lines.append(f"| {' | '.join(cells)} |")
    day = datetime.date.fromisoformat(document["date"])
    lines += ["", f"Measured on {day.day} {day:%B %Y}: {document['machine']}, all in one run."]
    return "\n".join(lines)


def with_table(page: str, document: dict[str, Any]) -> str:
    """The page with the table between its two marks."""
    before, _, rest = page.partition(BEGIN)
    after = rest.partition(END)[2]
    return f"{before}{BEGIN}\n\n{table(document)}\n\n{END}{after}"


def _between(values: Sequence[float]) -> str:
    """One number, or two where the touch falls differently within a step."""
    low, high = (f"{value:.3f}".replace("-", "−") for value in values)
    return low if low == high else f"{low} to {high}"


def _metres(value: float) -> str:
    return "0" if value < NEAR else f"{_two_figures(1000 * value)} mm"


def _change(part: float) -> str:
    return "kept" if abs(part) < NEAR else f"{_two_figures(100 * part)} %".replace("-", "−")


def _two_figures(value: float) -> str:
    """And all whole ones: 1500, 136, 0.034."""
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.2g}"
