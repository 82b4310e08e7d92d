"""Carts that go downhill side by side: hops and rooms between two that move nearly alike.

A classroom's scenes: one slope, air, carts of one mass or of two.
"""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop import detect
from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.processor_time import budget


def downhill(carts: dict[str, Any], drag: dict[str, float], until: float = 30.0) -> Any:
    scene = {
        "carts": carts,
        "contact": {"law": "instant", "restitution": 0.5},
        "effects": [{"incline": {"angle": "10 deg"}}, {"drag": drag}],
        "until": until,
    }
    with budget(3.0):
        return run(read_scene(scene))


@pytest.mark.parametrize("speed", [0.1, 0.02])
@pytest.mark.parametrize("drag", [{"linear": 0.05}, {"quadratic": 0.05}])
def test_hops_of_two_that_air_presses_together_downhill_end(
    speed: float, drag: dict[str, float]
) -> None:
    """The light cart is slowed more, the heavy one comes after it: hop after hop, each half as
    fast. Hops slower than 1e-13 of the speed at the bottom were touched anew at once for ever."""
    carts = {
        "A": {"mass": 2, "position": 0.1, "velocity": speed},
        "B": {"mass": 0.25, "position": 0.3},
    }
    done = downhill(carts, drag)
    assert 30 < len(done.record.events) < 60
    assert done.v[0] == pytest.approx(done.v[1], rel=1e-13)
    assert done.x[1] - done.x[0] == pytest.approx(0.2, abs=1e-12)


@pytest.mark.parametrize("drag", [{"linear": 0.05}, {"quadratic": 0.05}])
def test_of_two_under_one_law_of_motion_the_faster_stays_faster(drag: dict[str, float]) -> None:
    """Two solutions of one equation do not cross: none is searched for. It took 1,275 steps."""
    carts = {
        "A": {"mass": 0.25, "position": 0.1},
        "B": {"mass": 0.25, "position": 0.3, "velocity": 1e-8},
    }
    done = downhill(carts, drag)
    assert [event.kind for event in done.record.events] == ["end"]
    assert done.x[1] - done.x[0] > 0.2


def test_a_search_beside_a_row_that_slides_along_takes_few_steps(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What matters is how far two accelerations differ: their sum let each search take 400 steps
    (24 s for the whole run of eight carts)."""
    searches: list[int] = []
    safe, first_fall = detect.alike.safe, detect._first_fall

    def counted(*given: Any) -> Any:
        searches[-1] += 1
        return safe(*given)

    def begun(*given: Any) -> Any:
        searches.append(0)
        return first_fall(*given)

    monkeypatch.setattr(detect.alike, "safe", counted)
    monkeypatch.setattr(detect, "_first_fall", begun)
    carts = {
        "A": {"mass": 1.0, "position": 0.1, "velocity": 0.5},
        "B": {"mass": 0.5, "position": 0.5},
        "C": {"mass": 2.0, "position": 0.8},
        "D": {"mass": 0.25, "position": 1.0, "velocity": -0.5},
    }
    downhill(carts, {"linear": 0.05}, until=2.0)
    assert max(searches) < 60


@pytest.mark.parametrize("speed", [1e-3, 1e-5, 1e-7])
@pytest.mark.parametrize("drag", [{"linear": 0.05}, {"linear": 0.05, "quadratic": 0.5}])
def test_two_that_touch_and_roll_uphill_in_air_come_down_together(
    speed: float, drag: dict[str, float]
) -> None:
    """Air parts them as they go up, by less than any place is known, and presses them together as
    they come down: they touched by what was foreseen, parted by their forces, and so on for ever.
    """
    carts = {
        "A": {"mass": 0.25, "position": 0.1, "velocity": speed},
        "B": {"mass": 1, "position": 0.3, "velocity": speed},
    }
    scene = {
        "carts": carts,
        "contact": {"law": "instant", "restitution": 0.9},
        "effects": [{"incline": {"angle": "-5 deg"}}, {"drag": drag}],
        "until": 30,
    }
    with budget(3.0):
        done = run(read_scene(scene))
    assert len(done.record.events) < 300
    assert done.v[0] == pytest.approx(done.v[1], rel=1e-13)
    assert done.x[1] - done.x[0] == pytest.approx(0.2, abs=1e-12)
    assert done.ledger.imbalance() < 1e-14


@pytest.mark.parametrize(("law", "waits"), [("instant", True), ("bumper", False)])
def test_only_a_contact_without_a_duration_waits_until_the_two_are_pressed_together(
    law: str, waits: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An impact cannot hold two that part: it waits. A bumper can be touched without a force, and
    where it does not spring back (e = 0), waiting for a push could end the contact at once, and
    begin it anew, without end. Either way the heavy cart presses the light one on
    its way down."""
    waited: list[float] = []
    pressed_from = detect.alike.pressed_from

    def asked(*given: Any) -> Any:
        waited.append(pressed_from(*given))
        return waited[-1]

    monkeypatch.setattr(detect.alike, "pressed_from", asked)
    contact = {"law": law, "restitution": 0} | ({"stiffness": 1000} if law == "bumper" else {})
    scene = {
        "carts": {
            "A": {"mass": 0.5, "position": 0.2, "velocity": 1e-7},
            "B": {"mass": 2, "position": 0.4, "velocity": 1e-7},
        },
        "contact": contact,
        "effects": [{"incline": {"angle": "-5 deg"}}, {"drag": {"linear": 0.05}}],
        "until": 5,
    }
    done = run(read_scene(scene), max_steps=200)
    assert any(late > 0.0 for late in waited) is waits
    assert done.v[0] == pytest.approx(done.v[1], rel=1e-5)  # the bumper gives as air grows
    assert done.ledger.imbalance() < 1e-14
