"""The greatest force of a contact that the end of a run cuts off: told where it lies before."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.certify.certificate import certify, document
from sim.dynamics.batch.grid import run_points, solve
from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.scene import read_scene

LAWS = ["bumper", "paper", "push-only", "push-only-uncorrected", "hertz"]
STIFF = {"hertz": 3000}


def cut_off(law: str, until: float, e: float = 0.8, third: float = 2.0) -> dict[str, Any]:
    """A and B touch at 0.4 s; C stands beyond."""
    return {
        "carts": {
            "A": {"mass": 1, "position": 0.4, "velocity": 1},
            "B": {"mass": 1, "position": 1.0},
            "C": {"mass": 0.2, "position": third},
        },
        "contact": {
            "law": law,
            "restitution": e,
            "stiffness": STIFF.get(law, 100),
            "pairs": {"B-C": {"law": law, "restitution": e, "stiffness": 5}},
        },
        "until": until,
    }


def peaks(done: Any) -> list[tuple[float, tuple[str, ...]]]:
    return [(e.t, e.bodies) for e in done.record.events if e.kind == "peak"]


@pytest.mark.parametrize("third", [2.0, 1.28])
@pytest.mark.parametrize("until", [0.42, 0.47, 0.49, 0.53, 0.58])
@pytest.mark.parametrize("law", LAWS)
def test_a_run_tells_the_peaks_that_a_longer_run_tells_before_its_end(
    law: str, until: float, third: float
) -> None:
    """It told its last instant: bumpers “squeezed the most” while they were pressed on."""
    longer = peaks(run(read_scene(cut_off(law, 2, third=third))))
    cut = peaks(run(read_scene(cut_off(law, until, third=third))))
    assert [bodies for _, bodies in cut] == [bodies for t, bodies in longer if t < until]
    assert [t for t, _ in cut] == pytest.approx([t for t, _ in longer if t < until], abs=1e-7)


@pytest.mark.parametrize("e", [0.8, 1])
@pytest.mark.parametrize("third", [2.0, 1.28])
@pytest.mark.parametrize("until", [0.42, 0.49, 0.53, 0.58, 2])
@pytest.mark.parametrize("law", [law for law in LAWS if law != "hertz"])
def test_a_certificate_tells_the_peaks_of_a_run(
    law: str, until: float, third: float, e: float
) -> None:
    """Of a contact in progress it told none; and of elastic bumpers that a third cart meets after
    their turn it told half of the time until then."""
    scene = read_scene(cut_off(law, until, e, third))
    told = document(certify(scene))
    assert told["order"] == "proved"
    bounds = {tuple(one["bodies"]): one["t"] for one in told["events"] if one["kind"] == "peak"}
    found = {bodies: t for t, bodies in peaks(run(scene))}
    assert set(bounds) == set(found)
    for bodies, (low, high) in bounds.items():
        assert float(low) - 1e-9 <= found[bodies] <= float(high) + 1e-9


@pytest.mark.parametrize("method", ["euler", "verlet", "rk4", "rk4-events"])
def test_a_stepped_run_tells_no_peak_of_a_force_that_grows_at_its_end(method: str) -> None:
    for until, told in ((0.45, 0), (0.55, 1)):
        done = stepped(read_scene(cut_off("bumper", until)), MethodChoice(method, step=0.001))
        assert len(peaks(done.run)) == told


def test_a_map_of_greatest_forces_counts_those_that_still_grow() -> None:
    """A spring of k = 100 N/m between 1 kg and 1 kg for 0.02 s: N = √(k μ) u sin(ω t)."""
    plain = cut_off("bumper", 0.42)
    grid = solve(plain, (("A.mass", (1.0, 2.0)),), ("F", "A-B"))
    assert grid.left == (0, 1)
    values = run_points(plain, grid, ("F", "A-B"), 0)
    for value, mass in zip(values, (1.0, 2.0), strict=True):
        mu = mass / (mass + 1.0)
        force = math.sqrt(100 * mu) * math.sin(math.sqrt(100 / mu) * 0.02)
        assert value == pytest.approx(force, rel=1e-9)
