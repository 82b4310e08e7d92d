"""Six laws that every force between two bodies keeps, each as a number: nought where it is kept.

    third-law   |F_A − F_B| at one instant, of the greatest force
    energy      what the carts have more of when they part than before, of ½ μ w²
    galilei     what two observers say of one velocity at the end, of the closing speed w
    mirror      a velocity in the mirror image, of w
    order       a velocity after the carts have exchanged their names, of w
    step        a velocity from longer steps, of w

For the last four places count too: what differs by w times 1 s counts like w.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sim.mine.instance import Written
from sim.mine.judge.trial import Trial
from sim.mine.judge.two_numbers import both, joule, newton, place, speed
from sim.scene.said import said, template

FORCES = 1e-9
"""Of a force. Two answers are compared at one instant: nothing but rounding is between them."""

ENERGY = 1e-5
"""Of ½ μ w². Steps of 1e-7 are off by some 1e-6 over a contact."""

ENDS = 1e-4
"""Of the closing speed. Steps of 1e-6 are off by 1e-5 over a contact with a kink in it."""

PARTED = 1e-9
"""m. Less overlap than that is none: what has not parted may still give energy back."""


@dataclass(frozen=True, slots=True)
class Found:
    """How far a trial is off, and in words. `amount` inf: no steps lead to the end at all."""

    amount: float
    sentence: str


@dataclass(frozen=True, slots=True)
class Check:
    """One law: its name, what it says, how much is nothing, and the number of a trial.

    `of` gives None where a trial cannot tell. `asks`: what a law that remembers nothing has to ask
    for before it can break this one at all; empty: any law can.
    """

    name: str
    says: str
    limit: float
    of: Callable[[Trial], Found | None]
    asks: frozenset[str] = frozenset()

    def kept_by_form(self, written: Written) -> bool:
        """What a law does not know cannot matter to it: nothing has to be run."""
        return bool(self.asks) and written.forgets and not self.asks & set(written.wants)


def _third_law(trial: Trial) -> Found | None:
    end = trial.end("plain")
    if end is None or end.greatest == 0.0:
        return None
    off = end.apart
    left, right = both(off.left, off.right, newton)
    return Found(
        2.0 * abs(off.odd) / end.greatest,
        said(
            "At {time} B pushes A with {left}, and A pushes B with {right}.",
            time=f"{off.time:.3f} s", left=left, right=right,
        ),
    )  # fmt: skip


def _energy(trial: Trial) -> Found | None:
    """Only of carts that have parted: until then a spring may hold what is missing."""
    end = trial.end("plain")
    if end is None or end.overlap > PARTED:
        return None
    before, after = _kinetic(trial, trial.velocities), _kinetic(trial, end.v)
    first, second = trial.masses
    texts = both(before, after, joule)
    in_play = 0.5 * first * second / (first + second) * trial.closing**2
    return Found(
        max(0.0, after - before) / in_play,
        said(
            "Before they touch the carts have {before}, after they have parted {after}.",
            before=texts[0], after=texts[1],
        ),
    )  # fmt: skip


def _kinetic(trial: Trial, v: tuple[float, float]) -> float:
    return math.fsum(0.5 * m * u * u for m, u in zip(trial.masses, v, strict=True))


GALILEI = template(
    "On the ground {cart} ends with {here}; an observer in a train finds {there} for the same cart."
)
MIRROR = template("{cart} ends with {here}; in a mirror the same law gives it {there}.")
ORDER = template("{cart} ends with {here}; with the names of the carts exchanged, with {there}.")
STEP = template("{cart} ends with {here}; computed in longer steps, with {there}.")


def _compared(run: str, sentence: str) -> Callable[[Trial], Found | None]:
    """A run that should agree with the plain one."""

    def of(trial: Trial) -> Found | None:
        end = trial.end("plain")
        other = None if end is None else trial.end(run)
        if end is None or other is None:
            return None
        told = ((speed, end.v, other.v), (place, end.x, other.x))
        amount, k, write, two = max(
            (
                (abs(a - b), k, write, (a, b))
                for write, ours, others in told
                for k, (a, b) in enumerate(zip(ours, others, strict=True))
            ),
            key=lambda one: one[0],  # bumps without a loss may end in the same velocities
        )
        here, there = both(*two, write)
        return Found(amount / trial.closing, said(sentence, cart="AB"[k], here=here, there=there))

    return of


def _step(trial: Trial) -> Found | None:
    """A run that never ends depends on its steps more than any other."""
    if trial.end("plain") is None:
        return Found(
            math.inf, said("However short the steps are, they do not agree: the run has no end.")
        )
    return _compared("coarse", STEP)(trial)


VELOCITIES = frozenset({"velocity_self", "velocity_other"})

CHECKS: Mapping[str, Check] = {
    check.name: check
    for check in (
        Check(
            "third-law",
            template("Newton's third law: both push equally hard"),
            FORCES,
            _third_law,
        ),
        Check("energy", template("No energy is made"), ENERGY, _energy),
        Check(
            "galilei",
            template("A train makes no difference (Galilei)"),
            ENDS,
            _compared("train", GALILEI),
            VELOCITIES,
        ),
        Check(
            "mirror",
            template("Left and right are alike"),
            ENDS,
            _compared("mirror", MIRROR),
            VELOCITIES | {"side"},
        ),
        Check(
            "order",
            template("The names and the order of the carts do not matter"),
            ENDS,
            _compared("order", ORDER),
            frozenset({"name_self", "name_other"}),
        ),
        Check("step", template("Shorter steps give the same motion"), ENDS, _step),
    )
}
"""In the order in which they are told."""
