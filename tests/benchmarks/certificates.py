"""What a certificate costs beside the exact run, how wide it is, and what the ladder costs.

    python -m tests.benchmarks certificates

All in this process and in turn, the best of a few times by processor time. Certificates natively:
with python-flint where it is installed.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from sim.bridge.protocol import answer
from sim.certify.certificate import certify, document
from sim.dynamics.loop.run import run
from sim.pages.hard_cases import ALL
from sim.scene import Scene, SceneError, read_scene
from tests import registry
from tests.certify.held import widths
from tests.certify.random_scenes import letting_go, plain, swinging, touching

ONLY_ASKED = True  # two minutes of a processor

MOST = 50.0
"""Times the exact run."""

LADDER = 20.0
"""Times the answer that a page gets for a run, with its curves."""

ULPS = 8.0
"""Doubles between the bounds of a pair, at the median."""

RANDOM = 60
"""Scenes of each kind."""

TRIES, LONG = 5, 0.3
"""Times that each is done, the best counts; none more after so many seconds."""

KINDS = {"plain": plain, "rows": touching, "springs": swinging, "releases": letting_go}
AGAINST = "run() of the same scene, same process, processor time"


def rows() -> list[dict[str, Any]]:
    """One row per goal."""
    found = _cost("scenes of the gallery", map(registry.scene, registry.NAMES))
    found += _cost("hard cases", (read_scene(case.plain) for case in ALL))
    for name in KINDS:
        found += _cost(f"random {name}", _random(name))
    return [*found, _width(), *_ladder()]


def _random(kind: str) -> Iterator[Scene]:
    for seed in range(RANDOM):
        try:
            yield read_scene(KINDS[kind](seed))
        except SceneError:
            continue


def _best(work: Callable[[], Any]) -> float:
    """s."""
    took, begun = [], time.process_time()
    while len(took) < TRIES and (not took or time.process_time() - begun < LONG):
        before = time.process_time()
        work()
        took.append(time.process_time() - before)
    return min(took)


def _cost(what: str, scenes: Iterator[Scene]) -> list[dict[str, Any]]:
    """Of scenes that have a certificate."""
    ratios = []
    for scene in scenes:
        if certify(scene).x:
            exact = _best(lambda scene=scene: run(scene))
            ratios.append(_best(lambda scene=scene: certify(scene)) / exact)
    return _told(f"certificate, {len(ratios)} {what}", ratios, MOST, AGAINST)


def _told(name: str, ratios: Sequence[float], goal: float, against: str) -> list[dict[str, Any]]:
    within = 100 * sum(one <= goal for one in ratios) / len(ratios)
    row = {"unit": "times the cost", "reference": against}
    return [
        {"name": f"{name}: median", "value": statistics.median(ratios), "goal": goal, **row},
        {"name": f"{name}: worst", "value": max(ratios), "goal": goal, **row},
        {
            "name": f"{name}: at most {goal:g} times",
            "value": within,
            "goal": None,
            "unit": "%",
            "reference": against,
        },
    ]


def _width() -> dict[str, Any]:
    pairs = [scene for scene in _random("plain") if len(scene.carts) == 2]
    wide = [width for scene in pairs for width in widths(document(certify(scene)))]
    return {
        "name": f"width of {len(wide)} numbers at the end of a random pair, median",
        "value": statistics.median(wide),
        "unit": "doubles",
        "goal": ULPS,
        "reference": "unit of the last place",
    }


def _ladder() -> list[dict[str, Any]]:
    ratios = []
    for name in registry.NAMES:
        asked = {"id": 1, "scene": registry.plain(name)}
        own = _best(lambda asked=asked: answer({**asked, "kind": "run"}))
        ratios.append(_best(lambda asked=asked: answer({**asked, "kind": "relevance"})) / own)
    against = "the answer that a page gets for the run, with its curves"
    return _told("what effects would change, scenes of the gallery", ratios, LADDER, against)
