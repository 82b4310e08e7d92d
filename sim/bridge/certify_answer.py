"""Digits that are proved, of one scene, asked for by a reader.

    {"id": 9, "kind": "certify", "scene": {...}, "set": {...}}

is answered by `certificate` (see `sim.certify.certificate.document`; its reason as a template),
`seconds` of the proof and of the exact run on this computer, and `band`: null, or where inputs have
a tolerance `t`, and by cart `x` and `v` as [least, most] at each of those times.
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping
from time import monotonic, perf_counter
from typing import Any

from sim.bridge.alive import alive
from sim.bridge.protocol import plain_of
from sim.certify.certificate import Certificate, certify, document
from sim.certify.numbers.balls import bounds
from sim.certify.run import Limit
from sim.dynamics.loop.run import run
from sim.scene import Scene, read_scene
from sim.scene.said import wire

LONG_ENOUGH = 0.02
"""s. A browser's clock steps by up to a thousandth."""

INSTANTS = 96
"""A graph is some 300 units wide: one every three of them."""

SEEN = 1e-3
"""Of a run. An event whose time is known better than that has no width in a graph."""

INSIDE = 1e-3
"""Of an event's own time: so near to its edges a band has its steps."""

MOST_CHANGES = 200
"""Of a run whose digits are proved in a page: some seconds there."""

PATIENCE = 60.0
"""s. Of one proof. A row that loses its digits at every hit asks for a thousand bits and minutes,
and the page plays nothing else meanwhile."""


def certify_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """Header without numbers; raises SceneError or UnsolvedError for what cannot be run."""
    scene = read_scene(plain_of(request))
    exact = _seconds(scene)
    begun = perf_counter()
    limit = Limit(MOST_CHANGES, monotonic() + PATIENCE, alive)
    found = certify(scene, limit=limit)
    if scene.tolerances:
        # The band is drawn in a second proof, which knows where the first found its steps.
        instants = sorted({*_instants(scene), *_edges(scene, found)})
        finer = certify(scene, limit=limit, instants=instants)
        found = finer if _far(finer) >= _far(found) else found  # time may run out in it
    told = document(found)
    told["reason"] = wire(told["reason"])
    seconds = {"exact": exact, "proof": perf_counter() - begun}
    return {"certificate": told, "seconds": seconds, "band": _band(scene, found)}, array("d")


def _far(found: Certificate) -> tuple[bool, int]:
    """How far a proof came: to the end or not, and over how many events."""
    return bool(found.x), len(found.events)


def _seconds(scene: Scene) -> float:
    """Of one exact run, from as many as a browser's clock can tell."""
    begun, count, passed = perf_counter(), 0, 0.0
    while passed < LONG_ENOUGH:
        run(scene)
        count, passed = count + 1, perf_counter() - begun
    return passed / count


def _instants(scene: Scene) -> list[float]:
    """s. At which the band of a tolerant scene is drawn."""
    return [scene.until * k / INSTANTS for k in range(INSTANTS + 1)]


def _edges(scene: Scene, found: Certificate) -> set[float]:
    """s. Just outside and inside of every event's own time that is wide enough to be seen: there
    the band has a step."""
    edges: set[float] = set()
    for event in found.events:
        low, high = bounds(event.when.ball)
        inside = INSIDE * (high - low)
        if high - low > SEEN * scene.until:
            edges |= {low, low + inside, high - inside, high}
    return {t for t in edges if 0.0 <= t <= scene.until}


def _band(scene: Scene, found: Certificate) -> dict[str, Any] | None:
    if not found.seen:
        return None
    rows = found.seen.values()
    x, v = (
        {cart.name: [bounds(row[which][k]) for row in rows] for k, cart in enumerate(scene.carts)}
        for which in (0, 1)
    )
    return {"t": list(found.seen), "x": x, "v": v}
