"""A force keeps its formula between its switches: who does not is refused, once a run."""

from __future__ import annotations

import math

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.report.document import report
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.effects.forces import BodyForce
from sim.effects.push.force import Push
from sim.scene import read_scene
from tests import registry


def test_effects_are_checked_once_in_a_run_and_not_where_it_is_read(monkeypatch):
    asked = []
    monkeypatch.setattr("sim.effects.forces._refuse_drift", lambda one, _: asked.append(one.kind))
    scene = registry.scene("push-against-friction")
    listed_once = [effect.kind for effect in scene.effects]
    report(run(scene))
    assert asked == listed_once
    asked.clear()
    report(stepped(scene, MethodChoice("rk4", step=0.01)).run)
    assert asked == listed_once


def test_a_force_that_changes_where_no_switch_is_named_is_refused_and_not_frozen(monkeypatch):
    class Shaking(Push):
        def body_force(self, cart, t):
            return BodyForce("push", steady=math.cos(2 * math.pi * t))

    monkeypatch.setattr("sim.effects.push.force.act", Shaking)
    with pytest.raises(TypeError, match=r"push: its force on cart 0 changes from 0 to 1 s"):
        run(read_scene({
            "carts": {"A": {"mass": 1, "position": 0}}, "until": 1,
            "effects": [{"push": {"cart": "A", "force": 1}}],
        }))  # fmt: skip
