"""The truth of a scene with a proof, where python-flint is installed and proves it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from sim.dynamics.cost.exact import Exact
from sim.dynamics.cost.measure import CostRow, ratio
from sim.scene import Scene


def proved(scene: Scene, truth: Exact) -> tuple[Exact, CostRow] | None:
    """`truth` with the middles of the certificate in its place, and the certificate as a row of the
    table: half of its width is its error. None where nothing is proved, or inputs are tolerant."""
    from sim.certify.certificate import certify
    from sim.certify.numbers.arithmetic import ARB

    if not ARB:  # a thousand contacts would take minutes
        return None
    found = certify(scene)
    if not found.proved or scene.tolerances:
        return None
    (x, off_x), (v, off_v) = (_middles(scene, balls) for balls in (found.x, found.v))
    known = replace(truth, x=x, v=v, proved=True)
    dearer = ratio(lambda: certify(scene), truth.outcome)
    return known, CostRow("certified", None, None, None, 0, dearer, off_v, off_x, None)


def _middles(scene: Scene, balls: Mapping[str, Any]) -> tuple[tuple[float, ...], float]:
    """The doubles in the middle, and the greatest half of a width."""
    from sim.certify.numbers.balls import bounds

    ends = [bounds(balls[cart.name]) for cart in scene.carts]
    middles = tuple(low + 0.5 * (high - low) for low, high in ends)
    return middles, max(0.5 * (high - low) for low, high in ends)
