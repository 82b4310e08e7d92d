"""adaptive, rk45: Dormand & Prince's embedded methods of order 8 and 5 (scipy), events located.

    adaptive   DOP853   order 8, 12 evaluations per step, dense output of degree 7
    rk45       RK45     order 5, 6 evaluations per step, dense output of degree 4

They choose their own steps so that the error of each stays below a tolerance; there is no limit of
stability to mind, only of patience. Events are looked for in the dense output, and the step is
taken again up to there. numpy and scipy are imported when used.
Source: Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, II.4 to II.6.
"""

from __future__ import annotations

import math
from typing import Any

from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.stepping.falls import Along, State, first_falls
from sim.dynamics.stepping.located import Key
from sim.dynamics.stepping.pairs import PerCart
from sim.dynamics.stepping.stepper import LocatedStepper
from sim.scene.model import Scene
from sim.scene.said import said

RTOL = 1e-9
"""Relative error per step where nobody says otherwise."""

QUICK = 0.01
"""s. A displacement counts as small beside the greatest speed times this."""

SCIPY = {"adaptive": "DOP853", "rk45": "RK45"}
"""Methods by the name of their class in scipy.integrate."""

LOOKS = 10
"""Steps that a run has at least, so that an event has a chance to be seen."""


class AdaptiveStepper(LocatedStepper):
    """A run whose steps follow a tolerance; `advance` goes over any time."""

    most_changes = 2_000

    def __init__(self, scene: Scene, rtol: float = RTOL, name: str = "adaptive") -> None:
        super().__init__(scene)
        self.solver = SCIPY[name]
        self.rtol, self.longest = rtol, scene.until / LOOKS
        self.soft = any(one is not None and not one.sudden for one in scene.contacts)
        speeds = [abs(cart.velocity) for cart in scene.carts]
        self.speed = max(*speeds, *(abs(w) for w in scene.approaches if math.isfinite(w)), 1e-3)

    def give_up(self, t: float, h: float) -> None:
        """Nothing is taken without looking here."""
        raise UnsolvedError(
            said(
                "more than {count} events, ever closer to each other", count=str(self.most_changes)
            ),
            said("the exact method, or one of fixed step"),
            t,
            (),
        )

    def part(self, t: float, h: float) -> tuple[float, list[Key]]:
        """Step after step until h, or up to the first event."""
        solver = self._solver(t, h)
        first = self._detail(t)
        while solver.status == "running":
            begin, y, now = solver.t, solver.y, (self.s, self.v)
            self._one(solver)
            s, v = self._split(solver.y)
            span, dense = solver.t - begin, self._dense(solver, begin)
            part, keys = first_falls(self.located, t + begin, span, now, (s, v), dense)
            if keys:
                self.s, self.v = self._split(y)
                self._over(t + begin, part)
                self.impacts.remember(self.s, self.v)
                return float(begin + part), keys
            self.s, self.v = s, v
            self.impacts.remember(self.s, self.v)
            first = self._tell_step(float(t + solver.t), span, solver, first)
        return h, []

    def _dense(self, solver: Any, begin: float) -> Along:
        """Displacements and velocities in the step that was taken last, from its dense output."""
        dense: list[Any] = []

        def state(tau: float) -> State:
            if not dense:
                dense.append(solver.dense_output())  # which takes evaluations of its own
            return self._split(dense[0](begin + tau))

        return state

    def _over(self, t: float, h: float) -> None:
        """Exactly h, no event inside."""
        if h <= 0.0:
            return
        solver, first = self._solver(t, h), self._detail(t)
        while solver.status == "running":
            begin = solver.t
            self._one(solver)
            self.s, self.v = self._split(solver.y)
            first = self._tell_step(float(t + solver.t), solver.t - begin, solver, first)

    def _solver(self, t: float, h: float) -> Any:
        numpy, integrate = _scipy()
        count, field = len(self.s), self.field

        def slope(tau: float, y: Any) -> list[float]:
            s, v = self._split(y)
            try:
                return [*v, *field.accelerations(t + tau, s, v, h)]
            except UnsolvedError:  # a trial beyond where forces are known: the step is shortened
                return [math.nan] * (2 * count)

        return getattr(integrate, self.solver)(
            slope,
            0.0,
            numpy.array([*self.s, *self.v]),
            h,
            rtol=max(self.rtol, 3e-14),
            atol=numpy.array(
                [self.rtol * self.speed * QUICK] * count + [self.rtol * self.speed] * count
            ),
            max_step=self.longest,
        )

    def _one(self, solver: Any) -> None:
        if self.field.keep is not None:
            self.field.keep.clear()
        solver.step()
        if solver.status == "failed":
            raise UnsolvedError(
                said("the step became too small"),
                said("a softer contact, or a larger --rtol")
                if self.soft
                else said("a larger --rtol"),
                float(solver.t),
                (),
            )

    def _split(self, y: Any) -> tuple[PerCart, PerCart]:
        values = y.tolist()
        return values[: len(self.s)], values[len(self.s) :]

    def _detail(self, t: float) -> Any:
        """The forces at the beginning of a step, where anybody asks."""
        if self.seen is None or self.field.keep is None:
            return None
        self.field.accelerations(t, self.s, self.v, self.longest)
        self.field.evaluations -= 1
        return self.field.keep.pop()

    def _tell_step(self, t: float, h: float, solver: Any, first: Any) -> Any:
        """Tell of an accepted step with the weights of its stages; returns its last forces."""
        if self.seen is None or self.field.keep is None:
            return None
        weights = solver.B.tolist()
        stages = [first, *self.field.keep[-len(weights) : -1]]
        last = self.field.keep[-1]
        self.field.keep.clear()
        self.seen(t, h, list(zip(weights, stages, strict=True)))
        return last


def _scipy() -> tuple[Any, Any]:
    try:
        import numpy
        from scipy import integrate
    except ImportError:
        raise UnsolvedError(
            said("this method needs the Python package scipy"),
            said("install scipy, or choose another method"),
            0.0,
            (),
        ) from None
    return numpy, integrate
