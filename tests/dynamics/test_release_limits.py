"""A release by a spring at its limits: a run that ends early, nobody who lets go, bad numbers."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.report.document import report
from sim.dynamics.report.plan import plan
from sim.scene import read_scene
from sim.scene.problem import SceneError
from tests.dynamics.given.spring_release import done, pair


def test_a_run_that_ends_on_the_way_still_has_energy_in_the_spring() -> None:
    """After a sixth of an oscillation cos² 60° = 1/4 of it is left."""
    w = math.sqrt(20 / (0.5 / 1.5))
    finished = done(pair(until=f"{0.25 + math.pi / 3 / w:.16g}"))
    assert finished.ledger.potential["release"] == pytest.approx((0.06, 0.015), rel=1e-12)
    assert [e.kind for e in finished.record.events] == ["release", "end"]


@pytest.mark.parametrize("until", [0.2, 1])
def test_nobody_lets_it_go_so_it_keeps_its_energy(until: float) -> None:
    """Before its time, and where the two have parted: it stays squeezed."""
    carts = pair()["carts"]
    if until == 1:
        carts = carts | {"B": {"mass": 1, "position": 1.3, "velocity": 0.1}}
    finished = done(pair(carts=carts, until=until))
    assert finished.ledger.potential["release"] == (0.06, 0.06)
    assert bool(finished.record.idle_bursts) == (until == 1)
    assert [e.kind for e in finished.record.events] == ["end"]


def test_what_it_has_left_behind_it_does_not_meet_again() -> None:
    """It falls off: when the two come together again only their bumpers are between them."""
    plain = pair(track={"length": 2.4, "left": "wall", "right": "wall"}, until=12)
    finished = done(plain)
    kinds = [e.kind for e in finished.record.events if e.bodies == ("A", "B")]
    assert kinds[:2] == ["release", "separate"]
    assert kinds[2:5] == ["contact", "peak", "separate"]
    assert finished.ledger.imbalance() < 1e-12
    assert finished.ledger.warmed == pytest.approx(0.0, abs=1e-13)


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only", "instant", "velcro", "hertz"])
def test_every_law_of_contact_lets_it_push(law: str) -> None:
    contact: dict[str, Any] = {"law": law}
    finished = done(pair(contact=contact))
    assert list(finished.v) == pytest.approx([-0.4, 0.2], rel=1e-12)


def test_the_plan_says_that_a_formula_does_it() -> None:
    phases = plan(done(pair()))
    assert [phase.tier for phase in phases] == [0, 1, 0]
    assert "release between A with B" in phases[1].why


def test_without_a_stiffness_nothing_has_changed() -> None:
    plain = pair()
    del plain["effects"][0]["release"]["stiffness"]
    document = report(done(plain))
    (event, _) = document["events"]
    assert (event["kind"], event["force"]) == ("release", None)
    assert document["work"] == {"release": 0.06}


def test_two_that_overlap_have_no_room_for_a_spring_and_are_told_so() -> None:
    plain = pair()
    plain["carts"]["B"]["position"] = 1.29
    with pytest.raises(SceneError) as wrong:
        read_scene(plain)
    (problem,) = wrong.value.problems
    assert problem.path == ("effects", 0, "release", "stiffness")
    assert "overlap" in problem.message


@pytest.mark.parametrize("stiffness", [0, -1, "20 kg", "many"])
def test_a_stiffness_that_is_none_is_refused(stiffness: Any) -> None:
    with pytest.raises(SceneError):
        read_scene(pair(release={"stiffness": stiffness}))


@pytest.mark.parametrize("at", [0.11, 0.12, 0.14, 0.16])
def test_let_go_in_the_middle_of_a_collision_it_acts_beside_the_bumpers(at: float) -> None:
    """Bumpers and spring give all back: momentum and energy alone say how the two part."""
    carts = {
        "A": {"mass": 0.5, "position": 1, "velocity": 0.5},
        "B": {"mass": 1, "position": 1.25},
    }
    contact = {"stiffness": 400, "restitution": 1}
    finished = done(pair(carts=carts, contact=contact, release={"at": at, "stiffness": 30}))
    centre, mu = 0.25 / 1.5, 1 / 3
    apart = math.sqrt(0.5**2 + 2 * 0.06 / mu)
    wanted = [centre - mu / 0.5 * apart, centre + mu / 1.0 * apart]
    assert list(finished.v) == pytest.approx(wanted, abs=1e-13)
    assert finished.ledger.imbalance() < 1e-12
    impulses = [e.impulse for e in finished.record.events if e.kind == "separate"]
    assert math.fsum(impulses) == pytest.approx(mu * (0.5 + apart), abs=1e-13)
