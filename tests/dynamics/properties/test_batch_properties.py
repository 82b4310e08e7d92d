"""Grids over random scenes of one pair: a value in closed form is that of a run of its own."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from sim.dynamics.batch.grid import changes_at, solve
from sim.dynamics.loop.run import run
from sim.laws.many import outcome_known
from sim.scene import apply_changes, read_scene
from sim.scene.laws import laws
from tests.dynamics.given.batch_points import FINITE, by_engine, spread


@st.composite
def pair_scenes(draw: st.DrawFn) -> dict[str, Any]:
    """Two carts or one, any walls, any law: sometimes one contact, sometimes none or several."""
    count, law = (
        draw(st.integers(1, 2)),
        draw(st.sampled_from([law for law in laws() if outcome_known(law)])),
    )
    contact: dict[str, Any] = {"law": law}
    if law != "velcro":
        contact["restitution"] = draw(st.sampled_from(["0.5", "1", "0.05", "0.8"]))
    if law in FINITE:
        contact["stiffness"] = draw(st.sampled_from([30, 500, 1e6]))
    gap = draw(st.sampled_from(["0", "0.3", "0.55"]))
    carts: dict[str, Any] = {}
    for k in range(count):
        carts["AB"[k]] = {
            "mass": draw(st.sampled_from(["0.5", "1", "7", "1e9", "1e-9"])),
            "position": f"{0.6 + k * (0.2 + float(gap)):.6f}",
            "velocity": draw(st.sampled_from(["0", "1", "-0.4", "0.9"])),
        }
    side = st.sampled_from(["open", "wall"])
    return {
        "carts": carts,
        "track": {"left": draw(side), "right": draw(side), "length": "2"},
        "contact": contact,
        "until": draw(st.sampled_from(["0.2", "0.9", "3"])),
    }


@st.composite
def axes_of(draw: st.DrawFn, plain: dict[str, Any]) -> tuple[tuple[str, tuple[float, ...]], ...]:
    choices = {
        "A.mass": spread(0.1, 4.0, 5),
        "A.velocity": spread(-0.7, 1.3, 5),
        "A.position": spread(0.35, 0.6, 4),
        "until": spread(0.3, 2.5, 4),
    }
    if plain["contact"]["law"] != "velcro":
        low = 0.0 if not plain["contact"]["law"].startswith("push-only") else 0.1
        choices["contact.restitution"] = spread(low, 1.0, 5)
    if plain["contact"]["law"] in FINITE:
        choices["contact.stiffness"] = spread(40.0, 2000.0, 4)
    names = draw(st.lists(st.sampled_from(sorted(choices)), min_size=1, max_size=2, unique=True))
    return tuple((name, choices[name]) for name in names)


def test_a_point_with_a_closed_form_is_a_run_of_its_own() -> None:
    points: Counter[bool] = Counter()

    @given(st.data())
    def each(data: st.DataObject) -> None:
        points.update(_held(data))

    each()
    assert points[True] > 0.5 * points.total(), "most have no closed form"


def _held(data: st.DataObject) -> list[bool]:
    """Of each point of a grid, whether it has a closed form; that is then held against a run."""
    plain = data.draw(pair_scenes())
    axes = data.draw(axes_of(plain))
    show = data.draw(st.sampled_from([("v", "A"), ("v", "B"), ("warmed", ""), ("F", "A-B")]))
    if "B" not in plain["carts"]:
        show = ("v", "A") if show[0] != "warmed" else show
    if plain["contact"]["law"] not in FINITE and show[0] == "F":
        show = ("warmed", "")
    grid = solve(plain, axes, show)
    fastest = max(abs(float(c["velocity"])) for c in plain["carts"].values()) + 1.3
    heaviest = max(float(c["mass"]) for c in plain["carts"].values()) + 4.0
    scale = {"v": fastest, "warmed": 1e-3 * min(heaviest, 10.0), "F": 0.0}[show[0]]
    for point, value in enumerate(grid.values.ravel().tolist()):
        if point in grid.left:
            assert math.isnan(value)
            continue
        changes = changes_at(axes, point)
        expected = by_engine(plain, changes, show)
        assert abs(value - expected) <= last_places(plain, changes) * max(abs(expected), scale), (
            plain,
            changes,
            show,
        )
    return [point not in grid.left for point in range(grid.values.size)]


def last_places(plain: dict[str, Any], changes: dict[str, float]) -> float:
    """Relative. Rounding puts a touch up to 1e-16 m inside, and the run goes on from there: that
    is seen where the greatest overlap is not much larger."""
    done = run(read_scene(apply_changes(plain, changes)))
    depths = [depth for depth, _ in done.record.deepest.values() if depth > 0.0]
    return 2e-14 + 1e-15 / min(depths, default=1.0)
