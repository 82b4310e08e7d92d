"""Between two contacts a bumper comes clear and forgets how far it was pressed in.

Methods that choose their own steps never saw it, and came to another run with its energy closed.
"""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.adaptive_events import AdaptiveStepper
from sim.scene import read_scene

TWICE: dict[str, Any] = {
    "carts": {
        "B": {"mass": 0.3, "position": 0.5},
        "C": {"mass": 1, "position": 0.8, "length": 0.3, "velocity": -0.6},
    },
    "contact": {"restitution": 0.9, "stiffness": 30},
    "track": {"left": "wall", "length": 2},
    "until": 2,
}
"""B and C touch twice, and B the wall between."""


@pytest.mark.parametrize("e", [0.5, 0.9, 0.98])
@pytest.mark.parametrize("name", ["adaptive", "rk45"])
def test_methods_that_choose_their_steps_come_to_the_exact_run(name: str, e: float) -> None:
    scene = read_scene({**TWICE, "contact": {"restitution": e, "stiffness": 30}})
    stepper = AdaptiveStepper(scene, 1e-10, name)
    stepper.advance(0.0, scene.until)
    assert stepper.v == pytest.approx(run(scene).v, abs=1e-7)
