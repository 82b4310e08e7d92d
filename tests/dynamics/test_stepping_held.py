"""Carts that a push keeps together on bumpers with e = 0: located steps against exact runs."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.scene import read_scene

PARTS = 997
UNTIL = 4


@st.composite
def pushed_rows(draw: st.DrawFn) -> dict[str, Any]:
    """Two or three carts, a push on the first that ends, perhaps a wall, perhaps friction."""
    count = draw(st.integers(2, 3))
    gaps = [draw(st.sampled_from(["0", "0.03", "0.1"])) for _ in range(count)]
    place, carts = 0.3, {}
    for k in range(count):
        mass = draw(st.sampled_from([0.5, 1, 2]))
        carts["ABC"[k]] = {"mass": mass, "position": f"{place:.12g}"}
        place += 0.2 + float(gaps[k])
    force, ends = draw(st.sampled_from([0.5, 1, 3])), draw(st.sampled_from([1.3, 2.1, UNTIL]))
    effects: list[dict[str, Any]] = [{"push": {"cart": "A", "force": force, "until": ends}}]
    if draw(st.booleans()):
        effects.append({"friction": {"coefficient": draw(st.sampled_from([0.01, 0.05]))}})
    track = {"right": "wall", "length": f"{place - 0.1:.12g}"} if draw(st.booleans()) else {}
    contact = {"restitution": 0, "stiffness": draw(st.sampled_from([100, 400]))}
    return {"carts": carts, "track": track, "contact": contact, "effects": effects, "until": UNTIL}


@settings(max_examples=30)
@given(pushed_rows())
def test_located_steps_hold_what_the_exact_solver_holds(plain: dict[str, Any]) -> None:
    scene = read_scene(plain)
    true = run(scene, max_steps=1_000)
    assume(true.t == UNTIL)  # two such contacts in a row make the exact solver give up
    done = stepped(scene, MethodChoice("rk4-events", step=UNTIL / PARTS))
    assert done.run.v == pytest.approx(true.v, abs=2e-3)
    assert done.run.x == pytest.approx(true.x, abs=2e-3)
    assert abs(done.lost_momentum) < 1e-9
    assert abs(done.lost_energy) < 1e-4
