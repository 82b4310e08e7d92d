"""Energy at every sample: what is stored comes from the state, and only what warms is left over."""

from __future__ import annotations

import itertools
import math

import pytest

from sim.bridge.protocol import answer
from sim.dynamics.loop.run import run
from sim.dynamics.result.energy_parts import energy_parts
from sim.dynamics.result.trajectory import trajectory
from sim.scene import read_scene
from tests import registry

WITH_EFFECTS = [name for name in registry.NAMES if registry.scene(name).effects]
LAST = 1e-9
"""Of all energy: rounding of the samples, whose positions are good to 1e-15 m or so."""
NEVER_BACK = 1e-6
"""Of all energy: the sampled force tells what bumpers hold to a part in 1e7."""


@pytest.mark.parametrize("name", WITH_EFFECTS)
def test_at_the_end_every_part_is_what_the_account_of_the_run_says(name: str) -> None:
    finished = run(registry.scene(name))
    parts = energy_parts(finished, trajectory(finished))
    ledger = finished.ledger
    scale = max(ledger.energy_initial, ledger.energy_final, 1e-9, *map(abs, ledger.works.values()))
    for kind, (start, end) in ledger.potential.items():
        assert parts[kind][-1] == pytest.approx(end, abs=LAST * scale), kind
        assert parts[kind][0] == pytest.approx(start, abs=LAST * scale), kind
    for kind in ("push", "release"):
        if kind in parts:
            assert parts[kind][-1] == pytest.approx(ledger.works.get(kind, 0.0), abs=LAST * scale)
    lost = math.fsum(work for by, work in ledger.works.items() if by not in ("push", "release"))
    assert parts["warmed"][-1] == pytest.approx(ledger.warmed - lost, abs=1e-7 * scale)


@pytest.mark.parametrize("name", WITH_EFFECTS)
def test_what_has_warmed_never_comes_back(name: str) -> None:
    finished = run(registry.scene(name))
    warmed = energy_parts(finished, trajectory(finished))["warmed"]
    scale = max(finished.ledger.energy_initial, finished.ledger.energy_final, *map(abs, warmed))
    assert warmed[0] >= -NEVER_BACK * scale
    for before, after in itertools.pairwise(warmed):
        assert after >= before - NEVER_BACK * scale


def test_the_ledger_of_a_page_holds_within_a_flight() -> None:
    """Up a slope and down again: in the middle all is height. The page draws straight lines."""
    plain = {
        "carts": {"A": {"mass": 1, "position": "0.2", "velocity": "0.6"}},
        "effects": [{"incline": {"angle": "-2 deg"}}],
        "until": 3,
    }
    header, numbers = answer({"id": 1, "kind": "energy", "scene": plain})
    rows, names = header["rows"], header["parts"]
    columns = [numbers[k * rows : (k + 1) * rows] for k in range(2 + len(names))]
    t, (*parts, moving) = columns[0], columns[1:]
    g = 9.81 * math.sin(math.radians(2))
    for k, (before, after) in enumerate(itertools.pairwise(t)):
        middle = (before + after) / 2
        shown = (moving[k] + moving[k + 1]) / 2
        assert shown == pytest.approx((0.6 - g * middle) ** 2 / 2, abs=5e-6)
    height = parts[names.index("incline")]
    assert [a + b for a, b in zip(moving, height, strict=True)] == pytest.approx([0.18] * rows)


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only", "hertz"])
def test_an_elastic_contact_on_a_rough_track_warms_only_the_track(law: str) -> None:
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.5, "velocity": 1},
            "B": {"mass": 2, "position": 1.0},
        },
        "contact": {"law": law, "restitution": 1, "stiffness": 200},
        "effects": [{"friction": {"coefficient": "0.01"}}],
        "until": 0.8,
    }
    finished = run(read_scene(plain))
    samples = trajectory(finished)
    parts = energy_parts(finished, samples)
    assert max(parts["bumpers"]) > 0.1
    assert parts["bumpers"][-1] == 0.0
    rubbed = (
        0.01 * 9.81 * ((finished.x[0] - 0.5) + 2 * (finished.x[1] - 1.0))
    )  # neither turns round
    assert all(v >= 0 for v in samples.columns[("v", "B")])
    if all(v >= 0 for v in samples.columns[("v", "A")]):
        assert parts["warmed"][-1] == pytest.approx(rubbed, rel=1e-6)


@pytest.mark.parametrize("damping", [0, 0.2])
@pytest.mark.parametrize("law", ["bumper", "paper", "push-only", "hertz"])
def test_a_spring_beside_pressed_bumpers_keeps_its_own_energy(law: str, damping: float) -> None:
    """Squeezed together with them it holds k (l − room)²/2, the room being below nought; without
    a damper nothing warms."""
    spring = {"between": ["A", "B"], "stiffness": 100, "length": 0.1, "damping": damping}
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.4, "velocity": 1},
            "B": {"mass": 1, "position": 0.8, "velocity": -1},
        },
        "contact": {"law": law, "restitution": 1, "stiffness": 2000},
        "effects": [{"spring": spring}],
        "until": 0.4,
    }
    finished = run(read_scene(plain))
    samples = trajectory(finished)
    parts, columns = energy_parts(finished, samples), samples.columns
    rooms = [b - a - 0.2 for a, b in zip(columns["x", "A"], columns["x", "B"], strict=True)]
    assert min(rooms) < -0.01
    assert parts["spring"] == pytest.approx([50 * (0.1 - room) ** 2 for room in rooms], abs=LAST)
    if damping:
        for before, after in itertools.pairwise(parts["warmed"]):
            assert after >= before - LAST
    else:
        assert parts["warmed"] == pytest.approx([0] * samples.rows, abs=LAST)


@pytest.mark.parametrize("e", [0.1, 0.5, 0.9])
@pytest.mark.parametrize(("law", "power"), [("paper", 2.0), ("hertz", 2.5)])
def test_what_is_squeezed_stays_stored_while_the_damper_pulls(
    law: str, power: float, e: float
) -> None:
    """Laws that end at no overlap: their spring holds k d^p/p, whichever way they pull."""
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.4, "velocity": 1},
            "B": {"mass": 1, "position": 0.8},
        },
        "contact": {"law": law, "restitution": e, "stiffness": 400},
        "effects": [{"drag": {"linear": 0.001}}],
        "until": 1.2,
    }
    finished = run(read_scene(plain))
    samples = trajectory(finished)
    parts, columns = energy_parts(finished, samples), samples.columns
    rooms = [b - a - 0.2 for a, b in zip(columns["x", "A"], columns["x", "B"], strict=True)]
    assert min(columns["F", "A-B"]) < 0.0
    held = [400 / power * max(0.0, -room) ** power for room in rooms]
    assert parts["bumpers"] == pytest.approx(held, abs=LAST)
    for before, after in itertools.pairwise(parts["warmed"]):
        assert after >= before - LAST
