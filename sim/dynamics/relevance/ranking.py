"""What each effect would change, largest first, with the reading accuracy as the line between.

Nothing here is a rule of thumb: the scene is run as it is, and once more for each candidate. One
that cannot be run, or has no usual size, stands at the foot and says why.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sim.dynamics.loop.run import run
from sim.dynamics.relevance.candidates import CONTACT, Candidate, candidates
from sim.dynamics.relevance.difference import READS, Difference, Seen, difference, seen
from sim.dynamics.result.finished import Run
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene.model import Scene
from sim.scene.said import capital, said, wire

MOST_EVENTS = 5_000
"""Of one run. A scene with more is compared up to there, which tells as much."""

MOST_STEPS = 2_500
"""Short steps of one run, as in a page."""

MUCH = 50.0 * READS
"""Half the graph's height. A missing effect that changes less is an honest idealisation."""

WHOLE = 99.5
"""Per cent of the graph. From here on two figures would be written with an exponent."""

BEYOND = 10.0
"""Heights of the graph. A change by more has no percentage that says anything."""


@dataclass(frozen=True, slots=True)
class EffectChange:
    """One candidate and what it changes; None where that is not known."""

    candidate: Candidate
    changes: Difference | None
    sentence: str

    @property
    def visible(self) -> bool:
        """Would a graph show it?"""
        return self.changes is not None and self.changes.visible


def ranked_effects(scene: Scene) -> tuple[EffectChange, ...]:
    """Every effect that the program knows and the scene's contacts. Raises UnsolvedError."""
    own = _run(scene)
    whole = seen(own, own.t)
    ranked = [_change_by(own, whole, candidate) for candidate in candidates(scene)]
    return tuple(sorted(ranked, key=lambda r: -r.changes.relative if r.changes else 1.0))


def _run(scene: Scene) -> Run:
    return run(scene, max_events=MOST_EVENTS, max_steps=MOST_STEPS)


def _change_by(own: Run, whole: Seen, candidate: Candidate) -> EffectChange:
    """`whole`: all of the own run, which another one may have been stopped before the end of."""
    if candidate.scene is None:
        told = said("{effect}: no estimate, {why}.", effect=candidate.called, why=candidate.why)
        return EffectChange(candidate, None, told)
    try:
        other = _run(candidate.scene)
    except UnsolvedError:
        why = said("the scene cannot be run that way")
        told = said("{effect}: no estimate, {why}.", effect=candidate.called, why=why)
        return EffectChange(candidate, None, told)
    mine = whole if other.t >= own.t else seen(own, other.t)
    changes = difference(mine, seen(other, mine.times[-1]))
    return EffectChange(candidate, changes, _sentence(candidate, changes))


def _sentence(candidate: Candidate, changes: Difference) -> str:
    effect = candidate.called
    if candidate.size:
        effect = said("{effect} ({size})", effect=effect, size=candidate.size)
    if changes.nothing:
        if candidate.listed:
            return said("Without {effect} nothing would change.", effect=effect)
        return said("{effect} would change nothing.", effect=effect)
    values = {"effect": effect, "what": _what(changes), "amount": _amount(changes)}
    if candidate.listed and changes.visible:
        return said(
            "Without {effect}, {what} would differ by {amount}: a graph shows that.", **values
        )
    if candidate.listed:
        return said(
            "Without {effect}, {what} would differ by {amount}: a graph cannot show that.", **values
        )
    if changes.visible:
        return said(
            "{effect} would change {what} by {amount}: a graph would show that. Left out all the "
            "same, to keep the model simple.",
            **values,
        )
    return said(
        "{effect} would change {what} by {amount}: a graph cannot show that. Left out.", **values
    )


def _what(changes: Difference) -> str:
    kind, cart = changes.quantity.split(".", 1)
    time = f"{changes.at:.3g} s"
    if kind == "v":
        return said("the velocity of {cart} at {time}", cart=cart, time=time)
    return said("the place of {cart} at {time}", cart=cart, time=time)


def _amount(changes: Difference) -> str:
    unit = "m/s" if changes.quantity.startswith("v.") else "m"
    amount = f"{changes.amount:.2g} {unit}"
    if changes.relative > BEYOND:
        return amount
    percent = 100.0 * changes.relative
    part = f"{percent:.0f} %" if percent >= WHOLE else f"{percent:.2g} %"
    return said("{amount} ({part} of the graph)", amount=amount, part=part)


def rows(ranked: Sequence[EffectChange], *, wired: bool = False) -> list[dict[str, Any]]:
    """As `carts plan --relevance --json` prints them; `wired`: sentences as templates."""
    text: Any = wire if wired else capital
    return [
        {
            "effect": one.candidate.effect,
            "listed": one.candidate.listed,
            "changes": None if one.changes is None else _changes(one.changes),
            "visible": one.visible,
            "sentence": text(one.sentence),
            "size": one.candidate.size,
            "source": text(one.candidate.source),
        }
        for one in ranked
    ]


def _changes(changes: Difference) -> dict[str, Any]:
    relative = changes.relative if math.isfinite(changes.relative) else None
    return {
        "quantity": changes.quantity,
        "at": changes.at,
        "amount": changes.amount,
        "relative": relative,
    }


def hint(ranked: Sequence[EffectChange]) -> str:
    """One line for the author of a scene: what is listed in vain, what is missing most; or ""."""
    effects = [(r, r.changes) for r in ranked if r.changes and r.candidate.effect != CONTACT]
    vain = [r for r, changes in effects if r.candidate.listed and not changes.visible]
    much = [r for r, c in effects if not r.candidate.listed and MUCH < c.relative < math.inf]
    return capital((vain + much)[0].sentence) if vain or much else ""
