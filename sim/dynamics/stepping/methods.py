"""The methods by name, and a whole run with one of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from sim.dynamics.result.outcome import refuse_written
from sim.dynamics.stepping.explicit_euler import ExplicitEuler
from sim.dynamics.stepping.method import StepMethod
from sim.dynamics.stepping.pairs import PerCart
from sim.dynamics.stepping.richardson import Richardson
from sim.dynamics.stepping.rk4 import RK4
from sim.dynamics.stepping.semi_implicit_euler import SemiImplicitEuler
from sim.dynamics.stepping.stepper import LocatedStepper, Stepper
from sim.dynamics.stepping.velocity_verlet import VelocityVerlet
from sim.dynamics.stepping.yoshida import Yoshida
from sim.effects.forces import acting
from sim.scene.model import Scene

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

FIXED: dict[str, type[StepMethod]] = {
    method.name: method
    for method in (ExplicitEuler, SemiImplicitEuler, VelocityVerlet, Yoshida, Richardson, RK4)
}
ADAPTIVE = ("rk45", "adaptive")
"""They choose their steps themselves, and need numpy and scipy."""

NAMES = (*FIXED, "rk4-events", *ADAPTIVE)
STEP = 1e-3
"""s, where nobody says otherwise."""

MOST_STEPS = 10_000_000
"""Of one run; about a minute."""

ROUND = 1e-9
"""Of a step. A last step shorter than this is rounding, and goes with the one before."""


@dataclass(frozen=True, slots=True)
class MethodChoice:
    """A stepping method with its fixed step [s] or its relative tolerance."""

    method: str
    step: float | None = None
    rtol: float | None = None

    @property
    def order(self) -> int:
        """Where the force is smooth."""
        if self.method in FIXED:
            return FIXED[self.method].order
        return {"rk45": 5, "adaptive": 8}.get(self.method, 4)


def stepper(scene: Scene, choice: MethodChoice) -> Stepper:
    """A run at its start."""
    refuse_written(scene)
    if choice.method in FIXED:
        return Stepper(scene, FIXED[choice.method])
    if choice.method == "rk4-events":
        return LocatedStepper(scene)
    from sim.dynamics.stepping.adaptive_events import RTOL, AdaptiveStepper

    return AdaptiveStepper(scene, choice.rtol or RTOL, choice.method)


def drive(run: Stepper, until: float, h: float, phase: float = 1.0) -> None:
    """From 0 to `until` in steps of h, the first of them only `phase` of that."""
    t, k = 0.0, 0
    run.start()
    while t < until:
        end = (phase + k) * h
        if end > until - ROUND * h:
            end = until
        for stop in run.boundaries(t, end):
            run.advance(t, stop - t)
            t = stop
        k += 1


def outcome(scene: Scene, choice: MethodChoice, phase: float = 1.0) -> Stepper:
    """A run of which nothing is kept but its end."""
    run = stepper(scene, choice)
    drive(run, scene.until, choice.step or scene.until, phase)
    return run


def batchable(scene: Scene) -> bool:
    """Can many runs with fixed steps go on together as arrays? No impulses, joints or friction."""
    for effect in acting(scene):
        frictions = [effect.friction(k) for k in range(len(scene.carts))]
        if effect.switches() or effect.releases() or any(frictions):
            return False
    return not any(contact is not None and contact.sudden for contact in scene.contacts)


def batch(
    scene: Scene, choice: MethodChoice, phases: NDArray[np.float64]
) -> tuple[PerCart, PerCart, Stepper]:
    """Displacements and velocities at the end of one run per phase, all in the same arrays."""
    import numpy as np

    assert choice.step is not None
    run = Stepper(scene, FIXED[choice.method], lanes=len(phases))
    t, k = np.zeros(len(phases)), 0
    while (t < scene.until).any():
        end = np.maximum(t, np.minimum(scene.until, (phases + k) * choice.step))
        run.advance(t, end - t)
        t, k = end, k + 1
    return run.s, run.v, run
