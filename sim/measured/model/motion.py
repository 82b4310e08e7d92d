"""Two carts that approach, touch and part: the model that real readings are compared with.

    before    x = x(touch) + v τ                    τ = t − touch
    contact   overlap from the closed form, the centre of mass moves on undisturbed
    after     straight on with v' = V ± e u m_other/M

`friction` brakes a cart by a constant deceleration until it stands, and then it stays; `tilt`
accelerates both alike (+ to the right), but for a cart that friction holds. Only the ratio of the
masses is in it: a motion does not show the masses themselves. Standard library only.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from dataclasses import dataclass, field
from functools import partial

from sim.laws.damped_oscillation import Swing
from sim.measured.model.contact import Law, Stretch, with_friction, without_friction
from sim.scene.fields import FREE_FALL

GRAVITY = float(FREE_FALL)
"""m/s²."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameters:
    """What the model needs. A is the left cart. SI."""

    touch: float  # s, first touch
    x: float  # m, place of A's mark at first touch
    distance: float  # m, from A's mark to B's at first touch
    v: tuple[float, float]  # m/s, of both at first touch
    ratio: float  # mass of B : mass of A
    e: float
    w0: float  # 1/s, sqrt(k/mu)
    friction: tuple[float, float] = (0.0, 0.0)  # m/s², ≥ 0, against each cart's motion
    tilt: float = 0.0  # m/s², + to the right
    rests: tuple[bool, bool] = (False, False)  # stands still before the touch

    @property
    def approach(self) -> float:
        """u in m/s."""
        return self.v[0] - self.v[1]


State = tuple[tuple[float, float], tuple[float, float]]
"""Places in m and velocities in m/s of both carts."""


@dataclass(frozen=True, slots=True)
class _Piece:
    """A stretch of the contact with the state of the centre of mass where it starts."""

    stretch: Stretch
    x: float
    v: float


@dataclass(frozen=True, slots=True)
class Motion:
    """The motion for some parameters; `state` gives it at any time."""

    parameters: Parameters
    law: Law
    pieces: tuple[_Piece, ...] = field(init=False)
    starts: tuple[float, ...] = field(init=False)
    duration: float = field(init=False)
    after: State = field(init=False)

    def __post_init__(self) -> None:
        p = self.parameters
        pieces = _contact(p, self.law) if p.approach > 0.0 else ()
        duration = pieces[-1].stretch.end if pieces else 0.0
        object.__setattr__(self, "pieces", pieces)
        object.__setattr__(self, "starts", tuple(one.stretch.swing.start for one in pieces))
        object.__setattr__(self, "duration", duration)
        after: State = ((p.x, p.x + p.distance), p.v)
        if pieces and math.isfinite(duration):
            after = _tilted(self._touching(duration), duration, p.tilt)
        object.__setattr__(self, "after", after)

    def state(self, t: float) -> State:
        """Places and velocities at time t [s], the tilt included."""
        p, tau = self.parameters, t - self.parameters.touch
        if tau <= 0.0:
            first = ((p.x, p.x + p.distance), p.v)
            return _flown(first, tau, p, p.rests)
        if tau < self.duration:
            return _tilted(self._touching(tau), tau, p.tilt)
        return _flown(self.after, tau - self.duration, p, (False, False))

    def overlap(self, t: float) -> float:
        """m. How far the bumpers are pressed in; 0 outside of the contact."""
        tau = t - self.parameters.touch
        if not 0.0 <= tau < self.duration:
            return 0.0
        return self._piece(tau).stretch.swing.at(tau)[0]

    def _piece(self, tau: float) -> _Piece:
        return self.pieces[max(0, bisect_right(self.starts, tau) - 1)]

    def _touching(self, tau: float) -> State:
        p, piece = self.parameters, self._piece(tau)
        overlap, rate, _, _ = piece.stretch.swing.at(tau)
        since = tau - piece.stretch.swing.start
        share = 1.0 / (1.0 + p.ratio)  # of the mass that A has
        a1, a2 = piece.stretch.a
        a = share * a1 + (1.0 - share) * a2
        v = piece.v + a * since
        x = piece.x + (piece.v + 0.5 * a * since) * since
        apart = p.distance - overlap
        return (
            (x - (1.0 - share) * apart, x + share * apart),
            (v + (1.0 - share) * rate, v - share * rate),
        )


def _tilted(state: State, tau: float, tilt: float) -> State:
    """A state that a tilt has changed for tau seconds."""
    (x1, x2), (v1, v2) = state
    more, faster = 0.5 * tilt * tau * tau, tilt * tau
    return (x1 + more, x2 + more), (v1 + faster, v2 + faster)


def _flown(state: State, tau: float, p: Parameters, rests: tuple[bool, bool]) -> State:
    """Both carts tau seconds on (or back) from a state, braked and tilted."""
    flown = []
    for k, (x, moved) in enumerate(zip(*state, strict=True)):
        v = 0.0 if rests[k] else moved
        a, stands = pull(v, p.friction[k], p.tilt)
        since = min(tau, stands) if stands >= 0.0 else max(tau, stands)
        flown.append((x + (v + 0.5 * a * since) * since, v + a * since))
    (x1, v1), (x2, v2) = flown
    return (x1, x2), (v1, v2)


def pull(v: float, friction: float, tilt: float) -> tuple[float, float]:
    """Acceleration in m/s² of a cart with velocity v, and after which time in s it stands (below 0:
    until then it stood) and is held; inf: never."""
    if friction <= 0.0:
        return tilt, math.inf
    holds = abs(tilt) <= friction
    if v == 0.0:
        return (0.0, math.inf) if holds else (tilt - math.copysign(friction, tilt), math.inf)
    a = tilt - math.copysign(friction, v)
    return a, -v / a if holds and a != 0.0 else math.inf


def _contact(p: Parameters, law: Law) -> tuple[_Piece, ...]:
    """The stretches with the centre of mass carried along."""
    u, share = p.approach, 1.0 / (1.0 + p.ratio)
    plain = without_friction(law, p.w0, p.e, u)
    if not any(p.friction):
        stretches = tuple(Stretch(swing, (0.0, 0.0)) for swing in plain)
    else:
        v = share * p.v[0] + (1.0 - share) * p.v[1]
        weights = (1.0 - share, -share)
        turns = [_turn(plain, p.v[k], v, weights[k]) for k in range(2)]
        signs = [_signs(plain, p.v[k], v, weights[k], p.rests[k]) for k in range(2)]
        stretches = with_friction(
            law, p.w0, p.e, u, sorted(t for t in turns if 0.0 < t < math.inf),
            partial(_brakes, p.friction, turns, signs),
        )  # fmt: skip
    pieces = []
    x = p.x + (1.0 - share) * p.distance
    v = share * p.v[0] + (1.0 - share) * p.v[1]
    for one in stretches:
        pieces.append(_Piece(one, x, v))
        a, length = share * one.a[0] + (1.0 - share) * one.a[1], one.swing.duration
        if math.isfinite(length):
            x, v = x + (v + 0.5 * a * length) * length, v + a * length
    return tuple(pieces)


def _brakes(
    friction: tuple[float, float],
    turns: list[float],
    signs: list[tuple[float, float]],
    t: float,
) -> tuple[float, float]:
    """Accelerations by friction at a time after touch."""
    first, second = (-friction[k] * signs[k][0 if t < turns[k] else 1] for k in range(2))
    return first, second


def _at(plain: tuple[Swing, ...], t: float) -> float:
    """d' at a time after touch."""
    swing = next((one for one in plain if t <= one.start + one.duration), plain[-1])
    return swing.at(min(t, swing.start + swing.duration))[1]


def _signs(
    plain: tuple[Swing, ...], before: float, v: float, weight: float, rests: bool
) -> tuple[float, float]:
    """Direction of a cart's motion before and after it turns round."""
    end = plain[-1].start + plain[-1].duration
    after = v + weight * _at(plain, end) if math.isfinite(end) else v
    first = 0.0 if rests else before
    second = math.copysign(1.0, after) if after else 0.0
    return (math.copysign(1.0, first) if first else second), second


def _turn(plain: tuple[Swing, ...], before: float, v: float, weight: float) -> float:
    """s after touch at which a cart's velocity v + weight d' changes its sign; inf: never."""
    end = plain[-1].start + plain[-1].duration
    if not math.isfinite(end):
        end = 40.0 / plain[-1].rate.w0
    if before == 0.0 or before * (v + weight * _at(plain, end)) >= 0.0:
        return math.inf
    low, high = 0.0, end
    for _ in range(50):
        middle = 0.5 * (low + high)
        if before * (v + weight * _at(plain, middle)) > 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
