"""The pure functions that draw: numbers as text, curves, slow motion; each against its own law."""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, Decimal
from itertools import pairwise
from typing import Any

import pytest

from tests.web.scene.given.widget_site import MEETING, STRUCK, baked, in_node

NUMBERS = [
    0.0, -0.0, 1.0, -1.0, 0.5, 0.25, 0.125, 2.5, 0.0005, -0.00049, 1e-13, 12345.678, 999.95, 0.9996,
    1e9, -3e-7, 1 / 3, 2 / 3, 1e5, 1e6, 0.15, 0.35, 8.5, 1234.5, math.pi * 1e4, -math.e,
]  # fmt: skip


def test_a_number_has_its_decimals_rounded_half_away_from_zero_and_no_minus_zero() -> None:
    told = in_node(
        """const n = await import(view + "/numbers.js");
        give(data.map((v) => [0, 2, 5].map((places) => n.fixed(v, places))));""",
        NUMBERS,
    )
    for value, texts in zip(NUMBERS, told, strict=True):
        for places, text in zip((0, 2, 5), texts, strict=True):
            exact = Decimal(value).quantize(Decimal(1).scaleb(-places), ROUND_HALF_UP)
            assert text == f"{abs(exact):f}" if exact == 0 else f"{exact:f}".replace("-", "−")


@pytest.mark.parametrize(
    ("value", "text"),
    [(0, "0"), (0.5, "0.5"), (1.25, "1.25"), (0.9996, "1"), (12345.678, "12346"), (-2, "−2"),
     (1.5e9, "1.5 × 10⁹"), (-3e-7, "−3 × 10⁻⁷"), (1e6, "1 × 10⁶"),
     (0.000125, "1.25 × 10⁻⁴"), (9.999e-5, "1 × 10⁻⁴"), (-9.996e8, "−1 × 10⁹"),
     (5e-324, "4.94 × 10⁻³²⁴")],
)  # fmt: skip
def test_a_short_number_has_three_figures_and_no_zeros_behind(value: float, text: str) -> None:
    assert in_node('give((await import(view + "/numbers.js")).short(data));', value) == text


def test_every_tick_is_a_round_multiple_within_its_axis() -> None:
    spans = [(-0.3, 2.4), (0, 0.6), (0, 7.2), (-1e-7, 3e-7), (0, 0), (-5, -1), (0, 1e9), (0.1, 0.3)]
    made = in_node(
        """const s = await import(view + "/scales.js");
        give(data.map(([a, b]) => { const axis = s.axis(a, b, 4);
          return [axis.low, axis.high, axis.step, s.ticks(axis)]; }));""",
        spans,
    )
    for (low, high), (start, end, step, ticks) in zip(spans, made, strict=True):
        assert start <= min(low, 0)
        assert end >= max(high, 0)
        mantissa = float(f"{step:.3e}".split("e", maxsplit=1)[0])
        assert mantissa in (1, 2, 5)
        assert 0 in [round(tick / step) for tick in ticks]
        assert all(start - 1e-9 * step <= tick <= end + 1e-9 * step for tick in ticks)
        assert [round(b / step) - round(a / step) for a, b in pairwise(ticks)] == [1] * (
            len(ticks) - 1
        )


def test_what_rounding_leaves_of_nothing_has_the_axis_of_nothing() -> None:
    axes = in_node(
        """const s = await import(view + "/scales.js");
        give(data.map(([a, b]) => s.axis(a, b, 4)));""",
        [(0, 0), (-1.5e-17, 5e-18), (0, 2), (-1e-16, 2)],
    )
    assert axes[0] == axes[1]
    assert axes[2] == axes[3]


@pytest.mark.parametrize("until", [2, 3.5, 60, 600, 6000])
def test_the_last_number_of_a_time_axis_stays_in_the_picture(until: float) -> None:
    marks, width, letter = in_node(
        """const g = await import(view + "/graph.js");
        give([g.timeMarks(g.planeFor([0, 1], [0, data])), g.WIDTH, 8]);""",
        until,
    )
    for mark in marks:
        right = float(mark["textX"]) + letter * len(mark["label"].replace(".", "")) / 2
        assert right <= width
    assert [mark["at"] for mark in marks[:-1]] == [mark["textX"] for mark in marks[:-1]]


@pytest.mark.parametrize(
    ("high", "power"), [(0.6, 0), (8_000, 0), (1_200_000, 6), (4e9, 9), (3e-6, -6)]
)
def test_the_numbers_of_an_axis_have_room_beside_it(high: float, power: int) -> None:
    """A truck's energy lost its first digits, and “00000” stood there five times."""
    found, labels = in_node(
        """const g = await import(view + "/graph.js");
        const plane = g.planeFor([0, data], [0, 1]);
        const mirrored = g.planeFor([-data, data], [0, 1]);
        give([g.valuePower(plane), [plane, mirrored].flatMap(
          (one) => g.valueMarks(one).map(({ label }) => label))]);""",
        high,
    )
    assert found == power
    assert high / 2 < float(labels[-1]) * 10**power <= high * 1.1
    # 47 units are left of the axis, and a figure has 9.2 of them on a phone.
    assert max(9.2 * (len(label) - ("." in label) / 2) for label in labels) <= 47


def test_between_rows_a_cubic_is_met_exactly_and_a_jump_is_not_smoothed() -> None:
    times = [0.0, 1.0, 2.0, 2.0, 5.0]
    cubic = [0.0, 1.0, 8.0, -3.0, -9.0]  # t³ up to 2, then a jump and a straight line
    slopes = [0.0, 3.0, 12.0, -2.0, -2.0]
    asked = [-1.0, 0.0, 0.25, 0.5, 1.0, 1.9999999, 2.0, 3.5, 5.0, 6.0]
    wanted = [0, 0, 0.25**3, 0.125, 1.0, 1.9999999**3, -3.0, -6.0, -9.0, -9.0]
    found = in_node(
        """const { valueAt } = await import(view + "/trajectory.js");
        const [times, values, slopes, asked] = data;
        give(asked.map((t) => valueAt(times, values, slopes, t)));""",
        [times, cubic, slopes, asked],
    )
    assert found == pytest.approx(wanted, abs=1e-12)


def curves(fence: dict[str, Any], quantity: str) -> dict[str, Any]:
    """The paths of a graph, and where 0 and 1 are on its axes."""
    _, header, numbers = baked(fence)
    made: dict[str, Any] = in_node(
        """const [t, s, g] = await Promise.all(["trajectory", "series", "graph"].map(
          (name) => import(`${view}/${name}.js`)));
        const run = t.fromWire(data.header, Float64Array.from(data.numbers));
        const found = s.seriesOf(data.quantity, data.header, run, 0);
        const plane = g.planeFor(g.extent(found, run.t), [0, data.header.until]);
        give({ paths: found.map((curve) => g.path(curve, run.t, plane)),
          x: [0, 1].map((v) => g.timeX(plane, v)), y: [0, 1].map((v) => g.valueY(plane, v)) });""",
        {"header": header, "numbers": numbers.tolist(), "quantity": quantity},
    )
    return {**made, "events": header["events"]}


def drawn_points(path: str) -> list[tuple[float, float]]:
    """Points on a path of lines and cubic Bézier curves, sixteen on each curve."""
    points: list[tuple[float, float]] = []
    for part in path.replace("L", "|L").replace("C", "|C").split("|"):
        values = [float(v) for v in part[1:].split()]
        if part[0] != "C":
            points.append((values[0], values[1]))
            continue
        (x0, y0), (x1, y1, x2, y2, x3, y3) = points[-1], values
        for k in range(1, 17):
            s = k / 16
            r = 1 - s
            points.append(
                (
                    r**3 * x0 + 3 * r * r * s * x1 + 3 * r * s * s * x2 + s**3 * x3,
                    r**3 * y0 + 3 * r * r * s * y1 + 3 * r * s * s * y2 + s**3 * y3,
                )
            )
    return points


UPHILL = {
    "id": "uphill",
    "carts": {"A": {"mass": 1, "position": 0.2, "velocity": 0.6}},
    "effects": [{"incline": {"angle": "-2 deg"}}],
    "until": 3,
}


def test_on_a_slope_the_curves_of_a_flight_are_those_of_its_parabola() -> None:
    """A flight has two rows, and the cart turns between them: its energy is nothing there, and its
    place is within the axis."""
    g, (begin, end) = 9.81 * math.sin(math.radians(2)), (0.6, 0.2)
    made = {quantity: curves(UPHILL, quantity) for quantity in ("energy", "x")}
    true = {
        "energy": lambda t: (begin - g * t) ** 2 / 2,
        "x": lambda t: end + begin * t - g * t * t / 2,
    }
    for quantity, drawn in made.items():
        (x0, x1), (y0, y1) = drawn["x"], drawn["y"]
        points = drawn_points(drawn["paths"][0])
        assert len(points) > 10, quantity
        for x, y in points:
            t, value = (x - x0) / (x1 - x0), (y - y0) / (y1 - y0)
            assert value == pytest.approx(true[quantity](t), abs=2e-3), (quantity, t)
            assert 8 <= y <= 129, quantity  # TOP and BOTTOM of graph.js


def test_the_area_under_the_drawn_force_is_the_impulse() -> None:
    """What students see as area is what the run's own events say, within 3 %."""
    made = curves(MEETING, "F")
    separate = [e for e in made["events"] if e["kind"] == "separate"]
    (x0, x1), (y0, y1) = made["x"], made["y"]
    for path, event in zip(made["paths"][::2], separate, strict=True):
        points = drawn_points(path)
        area = sum((b[0] - a[0]) * (2 * y0 - a[1] - b[1]) / 2 for a, b in pairwise(points))
        # One tenth of a unit is the finest the picture draws; the contact is five units wide.
        assert area / ((x1 - x0) * (y0 - y1)) == pytest.approx(event["impulse"], rel=0.03)


def test_a_jump_is_drawn_upright() -> None:
    """An instant impact changes the velocity at one time, not along a ramp."""
    points = drawn_points(curves(STRUCK, "v")["paths"][0])
    assert len({x for x, _ in points}) == len(points) - 1


def test_free_flight_is_drawn_level_from_where_the_contact_ends() -> None:
    """A curve that rises where nothing pushes would tell of a force that is not there."""
    for path in curves(MEETING, "v")["paths"]:
        (_, before), (_, end) = drawn_points(path)[-2:]
        assert before == end


def test_slow_motion_makes_a_contact_last_and_misses_none() -> None:
    parts, ends = in_node(
        """const { slowParts, advance } = await import(source + "/scene/time/slow.js");
        const parts = slowParts([{ start: 1, end: 1.08 }, { start: 3, end: 3.0004 }]);
        const ends = data.map((speed) => {
          let [t, frames] = [0, 0];
          while (t < 5 && frames < 1e6) { t = advance(t, 1 / 60, speed, parts, 5); frames += 1; }
          return [t, frames / 60];
        });
        give([parts, ends]);""",
        [0.5, 1, 100],
    )
    for (start, end), part in zip(((1, 1.08), (3, 3.0004)), parts, strict=True):
        assert part["from"] < start
        assert part["to"] > end
        assert (end - start) / part["rate"] >= 3
    for t, seconds in ends:
        assert t == 5
        assert seconds > 8  # both contacts are seen slowly whatever the speed


@pytest.mark.parametrize(
    ("reach", "mirrored", "shown"),
    [
        ([0, 10, 1, 100], False, [-2, 10]),
        ([0, 10, 1, 100], True, [-10, 10]),  # forces with their signs: one of each pair below
        ([0, 10, 2, 100], False, [-4, 10]),
        ([-5, 10, 1, 2], False, [-5, 6]),  # no more than twice the run: else it gets small
        ([0, 10, 1, 2], True, [-6, 6]),
    ],
)
def test_an_axis_goes_as_far_as_sliders_may_take_the_run(
    reach: list[float], mirrored: bool, shown: list[float]
) -> None:
    script = 'give((await import(view + "/graph.js")).reached([-2, 3], data[0], data[1]));'
    assert in_node(script, [reach, mirrored]) == shown
