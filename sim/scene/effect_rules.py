"""What the numbers of listed effects have to do with each other, and with the scene."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sim.scene.effects import Effect
from sim.scene.problem import Path, Problem

STEEPEST = 1.5
"""rad. All inclines under one cart together: a track that hangs over carries nothing."""


def check_effects(effects: tuple[Effect, ...], listed: object, problems: list[Problem]) -> None:
    """One problem for each effect that cannot be meant. `listed` is the author's list."""
    if not isinstance(listed, Sequence) or len(effects) != len(listed):
        return  # some of them were not understood: that has been told
    for k, effect in enumerate(effects):
        path: Path = ("effects", k, effect.kind)
        begins, ends = effect.numbers.get("from", 0.0), effect.numbers.get("until", math.inf)
        if ends <= begins:
            message = f"the push ends at {ends:g} s, but begins at {begins:g} s"
            hint = f"for example until: {begins + 1.0:g} s"
            problems.append(Problem((*path, "until"), "out-of-range", message, hint))
        moving = effect.numbers.get("coefficient", 0.0)
        if effect.numbers.get("static", moving) < moving:
            problems.append(
                Problem(
                    (*path, "static"),
                    "out-of-range",
                    f"static friction is never less than that of a moving cart, {moving:g}",
                    f"static: {moving:g} or more, or remove it",
                )
            )
    _not_too_steep(effects, problems)


def _not_too_steep(effects: tuple[Effect, ...], problems: list[Problem]) -> None:
    total: dict[str, float] = {}
    for k, effect in enumerate(effects):
        if effect.kind != "incline":
            continue
        for cart in effect.carts:
            total[cart] = total.get(cart, 0.0) + effect.numbers["angle"]
        if any(abs(total[cart]) > STEEPEST for cart in effect.carts):
            problems.append(
                Problem(
                    ("effects", k, "incline", "angle"),
                    "out-of-range",
                    f"all inclines under one cart together are more than {STEEPEST} rad",
                    "one incline is enough: angle: 2 deg",
                )
            )
            return
