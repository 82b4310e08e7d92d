"""What one more digit costs, of v and of x, and where doubles end."""

from __future__ import annotations

import json
import math

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.dynamics.cost import measure
from sim.dynamics.cost.digits import one_more_digit
from sim.dynamics.cost.exact import exact
from sim.dynamics.cost.report import digits_of, floor_of
from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.pages.hard_cases import ALL
from sim.pages.text.yaml.source import load
from sim.scene import read_scene
from tests import registry


@pytest.mark.parametrize("order", [1, 2, 4, 8])
def test_a_line_of_order_p_costs_ten_to_the_pth_root(order: int) -> None:
    rows = [("m", float(n), 10.0 * n**-order) for n in (10, 30, 100, 300)]
    rows += [("m", 5.0, 7.0), ("m", 1e9, 1e-16), ("other", 2.0, 1e-3)]
    assert one_more_digit(rows, 1.0) == pytest.approx({"m": 10 ** (1 / order)})


@pytest.mark.parametrize("name", ["incline-bounce", "off-the-wall", "paper-two-carts"])
def test_rounding_begins_at_half_a_step_of_the_greatest_speed_of_the_run(name: str) -> None:
    """On the slope a cart gets to 0.64 m/s between starting and ending slower."""
    scene = registry.scene(name)
    solved = run(scene)
    times = [solved.t * k / 5000 for k in range(5001)]
    fastest = max(abs(v) for t in times for v in sample(solved, t)[1])
    assert floor_of(exact(scene)) == 0.5 * math.ulp(fastest)


STOPS = """
carts: {A: {mass: 1 kg, position: 0 m, velocity: 1 m/s}}
effects: [friction: {coefficient: 0.05}]
until: 3 s
"""


def test_where_carts_end_at_rest_a_digit_is_one_of_the_place(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What Verlet leaves of v falls to 1e-13, and 1e-324: a digit of it was had for × 1.1."""
    monkeypatch.setattr(measure, "LADDER", (("verlet", (61, 103, 211, 997)),))
    monkeypatch.setattr(measure, "TOLERANCES", ())
    monkeypatch.setattr(measure, "BATCH", 1e-4)
    document = json.loads(CliRunner().invoke(main, ["cost", "-", "--json"], input=STOPS).stdout)
    assert document["digits"] == {} and set(document["digits_x"]) == {"verlet"}
    counted = [row | {"time_ratio": row["evaluations"]} for row in document["rows"]]
    truth = exact(read_scene(load(STOPS).plain))
    stepped = [row for row in counted if row["evaluations"]]
    assert digits_of(stepped, truth)["digits_x"]["verlet"] == pytest.approx(10**0.5, rel=0.01)
    told = CliRunner().invoke(main, ["cost", "-"], input=STOPS).stdout
    assert "One more digit of x (the carts end at rest) costs: verlet × " in told
    assert "One more digit costs" not in told


def test_carts_that_only_turn_round_at_the_end_do_not_rest() -> None:
    """Their v is nought there too, and what a method makes of it is of its order."""
    (turning,) = (case for case in ALL if case.name == "spring-pair-quarter-period")
    truth = exact(read_scene(turning.plain))
    assert max(map(abs, truth.v)) < 1e-14 and not truth.rests
    assert exact(read_scene(load(STOPS).plain)).rests
