"""One scene of the search and its runs. Each changed run is undone, so that both should agree.

    plain     as it is
    train     all velocities less u: afterwards they are less by u again (Galilei)
    mirror    left and right exchanged: the motion is its mirror image
    order     A called B and B called A, and the right one is asked first: nothing changes
    coarse    ten times the error allowed in each step: hardly anything changes

Numbers are kept as the end of a run gives them: places and velocities of the left and right cart.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from sim.mine.contact import Apart, WrittenForce, side_of
from sim.mine.instance import Instance, read_law
from sim.mine.judge.one_contact import Contact, NoEndError
from sim.mine.judge.scenes import LENGTH

FINE, COARSE = 1e-7, 1e-6
"""Relative errors of one step."""

TRAIN = 0.7
"""m/s, to the right."""

MOST_CALLS = 4_000
"""Questions in one run: eight times those of a spring; three times as many with smaller errors."""


@dataclass(frozen=True, slots=True)
class End:
    """m and m/s of the left and the right cart at the end, and what was seen on the way."""

    x: tuple[float, float]
    v: tuple[float, float]
    overlap: float  # m, left at the end
    apart: Apart
    greatest: float  # N


@dataclass(slots=True)
class Counter:
    """Questions to the law that were asked, and how many may be."""

    most: int
    asked: int = 0

    @property
    def over(self) -> bool:
        """Is the budget used up?"""
        return self.asked >= self.most


@dataclass(slots=True)
class Trial:
    """Runs are made when they are asked for, and once. None: no steps lead to the end."""

    plain: dict[str, Any]
    counter: Counter
    finer: float = 1.0  # by which the error that is allowed in a step is divided
    ends: dict[str, End | None] = field(default_factory=dict)

    def end(self, name: str) -> End | None:
        """The end of one of the five runs, undone."""
        if name not in self.ends:
            self.ends[name] = RUNS[name](self)
        return self.ends[name]

    @property
    def masses(self) -> tuple[float, float]:
        """kg."""
        carts = self.plain["carts"]
        return carts["A"]["mass"], carts["B"]["mass"]

    @property
    def velocities(self) -> tuple[float, float]:
        """m/s at the start."""
        carts = self.plain["carts"]
        return carts["A"]["velocity"], carts["B"]["velocity"]

    @property
    def closing(self) -> float:
        """m/s."""
        left, right = self.velocities
        return left - right


def _run(
    trial: Trial, carts: dict[str, Any], rtol: float = FINE, *, right_first: bool = False
) -> End | None:
    """Fly to the touch, press, fly on. All carts are of one length and run into each other."""
    (one, left), (two, right) = sorted(carts.items(), key=lambda item: item[1]["position"])
    contact, until = trial.plain["contact"], trial.plain["until"]
    ((file, text),) = trial.plain["laws"].items()
    law = Instance(read_law(text, file))
    sides = side_of(one, left["mass"]), side_of(two, right["mass"])
    force = WrittenForce(law, sides, contact["stiffness"], contact["restitution"], right_first)
    masses, v = (left["mass"], right["mass"]), (left["velocity"], right["velocity"])
    gap = right["position"] - left["position"] - LENGTH
    touch = gap / trial.closing
    most = MOST_CALLS if trial.finer == 1.0 else 3 * MOST_CALLS
    try:
        pressing = Contact(force, masses, trial.closing, until, rtol / trial.finer, most)
        end, y = pressing.run(touch, v)
    except NoEndError:
        return None
    finally:
        trial.counter.asked += law.calls
    rest, overlap = until - end, y[0] - y[1]
    places = (
        left["position"] + v[0] * touch + y[0] + y[2] * rest,
        right["position"] + v[1] * touch + y[1] + y[3] * rest,
    )
    return End(places, (y[2], y[3]), overlap, force.apart, force.greatest)


def _plain(trial: Trial) -> End | None:
    return _run(trial, trial.plain["carts"])


def _coarse(trial: Trial) -> End | None:
    return _run(trial, trial.plain["carts"], COARSE)


def _train(trial: Trial) -> End | None:
    carts = {
        name: cart | {"velocity": cart["velocity"] - TRAIN}
        for name, cart in trial.plain["carts"].items()
    }
    end = _run(trial, carts)
    if end is None:
        return None
    way = TRAIN * trial.plain["until"]
    x, v = [a + way for a in end.x], [a + TRAIN for a in end.v]
    return End((x[0], x[1]), (v[0], v[1]), end.overlap, end.apart, end.greatest)


def _mirror(trial: Trial) -> End | None:
    """About x = 0; the left cart is then the right one."""
    carts = {
        name: cart | {"velocity": -cart["velocity"], "position": -cart["position"]}
        for name, cart in trial.plain["carts"].items()
    }
    end = _run(trial, carts)
    if end is None:
        return None
    return End((-end.x[1], -end.x[0]), (-end.v[1], -end.v[0]), end.overlap, end.apart, end.greatest)


def _order(trial: Trial) -> End | None:
    carts = trial.plain["carts"]
    return _run(trial, {"B": carts["A"], "A": carts["B"]}, right_first=True)


RUNS: dict[str, Callable[[Trial], End | None]] = {
    "plain": _plain,
    "train": _train,
    "mirror": _mirror,
    "order": _order,
    "coarse": _coarse,
}
