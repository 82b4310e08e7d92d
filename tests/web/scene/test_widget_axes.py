"""Axes and units: one for the life of a scene, with room, and silent before a prediction."""

from __future__ import annotations

import re
from typing import Any

import pytest

from sim.pages.widget import render
from sim.pages.widget.baked import baked_values
from sim.pages.widget.run import from_wire
from sim.pages.widget.scale_of import read_scales
from tests.web.scene.given.widget_site import COASTING, FENCES, MEETING, QUESTIONS, STRUCK, baked

CREEPING: dict[str, Any] = {
    "id": "creeping",
    "carts": {"B": {"mass": "0.5 kg", "position": "0.40 m", "velocity": "0.5 mm/s"}},
    "track": {"length": "0.90 m"},
    "until": 600,
    "show": ["x", "v"],
    "controls": [{"set": "B.velocity", "from": "0 mm/s", "to": "0.5 mm/s", "step": "0.1 mm/s"}],
}


@pytest.mark.parametrize("name", [n for n in FENCES if n not in QUESTIONS and n != "guessed"])
def test_no_curve_lies_on_the_frame_of_its_graph(name: str) -> None:
    shown = ["x", "v", "a", "F", "p", "energy"]
    text = render(*baked({**FENCES[name], "forces": "shown", "show": shown}))
    plots = re.findall(r'<svg class="carts-plot".*?</svg>', text, re.DOTALL)
    assert len(plots) == len(shown)
    for plot in plots:
        top, bottom = 8, 129  # of the frame, in a picture 160 high
        room = 0.03 * (bottom - top)  # a little less than the headroom on both sides
        for curve in re.findall(r'<path [^>]*class="carts-curve[^>]*', plot):
            (path,) = re.findall(r' d="([^"]*)"', curve)
            heights = [float(y) for _, y in re.findall(r"([-\d.]+) ([-\d.]+)(?=[LC ]|$)", path)]
            assert heights
            assert top + room < min(heights)
            assert max(heights) < bottom - room


def test_an_axis_reaches_as_far_as_the_sliders_do() -> None:
    fence, header, numbers = baked(MEETING)
    scales = read_scales(header, fence.controls, from_wire(header, numbers), 0.0)
    assert scales.reach["v"].high == pytest.approx(1.0)  # the fastest start of A


@pytest.mark.parametrize("velocity", ["0 m/s", "-0.2 m/s"])
def test_where_nothing_touches_yet_a_slider_that_makes_it_has_a_scale_of_forces(
    velocity: str,
) -> None:
    """Arrows of the first touch would have no length, and no number of newtons beside the ruler."""
    carts = {**MEETING["carts"], "A": {**MEETING["carts"]["A"], "velocity": velocity}}
    controls = [{"set": "A.velocity", "from": "-0.2 m/s", "to": "1 m/s", "step": "0.1 m/s"}]
    fence, header, numbers = baked({**MEETING, "carts": carts, "controls": controls})
    assert not any(from_wire(header, numbers).F.values())
    met = {"A": {**carts["A"], "velocity": "1 m/s"}, "B": carts["B"]}
    _, other, moved = baked({**MEETING, "carts": met, "until": "2 s"})
    scales = read_scales(header, fence.controls, from_wire(header, numbers), 0.0)
    assert max(from_wire(other, moved).F["A-B"]) <= scales.force


def test_carts_that_no_slider_lets_touch_have_no_scale_of_forces() -> None:
    carts = {
        "A": {"mass": "1 kg", "position": "0.4 m"},
        "B": {"mass": "1 kg", "position": "1 m", "velocity": "0.5 m/s"},
    }
    controls = [{"set": "A.mass", "from": "0.5 kg", "to": "4 kg", "step": "0.1 kg"}]
    contact = {"law": "bumper", "stiffness": 200}
    plain = {"id": "away", "carts": carts, "contact": contact, "until": 2, "controls": controls}
    fence, header, numbers = baked(plain)
    assert read_scales(header, fence.controls, from_wire(header, numbers), 0.0).force == 0


def test_a_run_much_faster_than_its_start_makes_the_scale_of_its_velocities() -> None:
    """A push on a cart that creeps: metres per second, and an arrow that is not cut at once."""
    creep = {"mass": "1 kg", "position": "0.4 m", "velocity": "0.005 m/s"}
    push = [{"push": {"cart": "A", "force": "1 N", "until": "1 s"}}]
    plain = {"id": "pushed", "carts": {"A": creep}, "effects": push, "until": "2 s"}
    fence, header, numbers = baked(plain)
    scales = read_scales(header, fence.controls, from_wire(header, numbers), 0.0)
    assert scales.velocity == pytest.approx(1.5)
    guessed = {**plain, "predict": {"ask": "How fast?", "choice": ["faster", "slower"]}}
    fence, header, numbers = baked(guessed)
    assert read_scales(header, fence.controls, None, 0.0).velocity == pytest.approx(0.005)


def test_before_a_prediction_axes_know_only_the_start_and_the_sliders() -> None:
    fence, header, numbers = baked(QUESTIONS["choice"])
    run = from_wire(header, numbers)
    other = {**header, "events": [], "final": {}}
    here = read_scales(header, fence.controls, None, 0.0)
    assert here.reach == read_scales(other, fence.controls, None, 0.0).reach
    peak = max(run.F["A-B"])
    assert here.reach["F"].high != pytest.approx(peak, rel=1e-3)


def test_a_creeping_cart_speaks_of_millimetres_everywhere() -> None:
    text = render(*baked(CREEPING))
    picture = text.split('<script type="application/json"')[0]
    assert "m/s" in picture
    assert not re.search(r"(?<!m)(?<!kg )m/s(?!²)", picture)
    assert "× 10" not in picture
    assert '<span class="carts-value" data-quantity="v">0.50</span> mm/s' in picture
    assert "moves at 0.50\u00a0mm/s to the right" in picture
    assert picture.count(">0.50 mm/s<") == 2  # beside the arrow, wide and narrow
    assert "<td>0.50</td>" in picture


@pytest.mark.parametrize(
    ("until", "speed"), [(5, "1"), (60, "1"), (100, "10"), (600, "100"), (3000, "100")]
)
def test_a_long_run_opens_at_a_speed_that_shows_it_soon(until: int, speed: str) -> None:
    text = render(*baked({**CREEPING, "until": until}))
    assert re.findall(r'value="([\d.]+)" selected', text) == [speed]


def test_under_a_moving_camera_the_ruler_and_the_readout_have_two_names() -> None:
    text = render(*baked(COASTING))
    assert "position on the track in m" in text
    assert "position seen from the camera" in text
    assert "Position seen from the camera, <i>x</i> in m" in text


def test_two_walls_have_two_names() -> None:
    walls = {"left": "wall", "right": "wall", "length": 2}
    text = render(*baked({**MEETING, "id": "walls", "track": walls, "until": "12 s"}))
    assert "on B by the right wall" in text
    assert "on the left wall by A" in text
    assert "by the wall" not in text
    assert "left wall" not in render(*baked(STRUCK))


def test_the_only_wall_has_one_name_in_the_whole_widget() -> None:
    """“wall”, “right wall” and “the right wall” stood on one page."""
    track = {"right": "wall", "length": 2}
    text = render(*baked({**MEETING, "id": "wall", "track": track, "until": "12 s"}))
    assert "on B by the wall" in text
    assert "right wall" not in text and "by wall" not in text


def test_a_force_that_lasts_is_told_beside_the_push_of_a_bumper() -> None:
    """0.09 N by slope and friction, 20 N in the contact: “0.0 N, 0.1 m/s²” denied the law."""
    effects = [{"incline": {"angle": "1 deg"}}, {"friction": {"coefficient": 0.01}}]
    fence, header, numbers = baked({**MEETING, "effects": effects})
    decimals = read_scales(header, fence.controls, from_wire(header, numbers), 0.0).decimals
    assert (decimals["R"], decimals["a"]) == (2, 2)
    plain = baked(MEETING)[1]
    without = read_scales(plain, fence.controls, None, 0.0).decimals
    assert (without["R"], without["a"]) == (1, 1)


def test_a_short_run_has_decimals_of_its_time_and_a_light_cart_of_its_momentum() -> None:
    """The greatest force came “at 0.001 s” of 0.002 s, and 0.0081 kg m/s were 0."""
    carts = {
        "A": {"mass": "50 kg", "position": "0.1 m", "velocity": "2 m/s"},
        "B": {"mass": "2.7 g", "position": "0.3005 m"},
    }
    fence, header, numbers = baked(
        {"id": "quick", "carts": carts, "contact": {"stiffness": "2e7 N/m"}, "until": "2 ms"}
    )
    decimals = read_scales(header, fence.controls, from_wire(header, numbers), 0.0).decimals
    assert (decimals["t"], decimals["p"]) == (5, 3)
    fence, header, numbers = baked(MEETING)
    decimals = read_scales(header, fence.controls, from_wire(header, numbers), 0.0).decimals
    assert (decimals["t"], decimals["p"]) == (3, 2)


def test_ready_made_settings_are_compared_on_one_axis_of_forces_and_through_one_lens() -> None:
    """Foam and wall looked alike: 2 N of 4 N, and 11 N of 12 N."""
    foam = {"contact.stiffness": "40 N/m"}
    wall = {"contact.stiffness": "1000 N/m"}
    cart = {"mass": "0.5 kg", "position": "0.5 m", "velocity": "0.5 m/s", "bumper_length": "0 m"}
    views = []
    for stiffness in (40, 1000):
        fence = {
            "id": "things",
            "carts": {"A": cart},
            "track": {"length": "1.2 m", "right": "wall"},
            "contact": {"restitution": 0.6, "stiffness": stiffness},
            "until": "3 s",
            "predict": {"choice": ["It stops", "It turns back"]},
            "presets": {"foam": foam, "wall": wall},
        }
        described, header, numbers = baked(fence)
        view = baked_values(described, header, numbers)["view"]
        views.append((view["reach"]["F"], view["gives"]))
        assert max(from_wire(header, numbers).F["A-right"]) <= view["reach"]["F"][1] * 1.01
    assert views[0] == views[1]
    assert views[0][0][3] == 0  # no limit by what one run needs
    assert views[0][1] == pytest.approx(0.056, abs=0.001)  # m, of the foam
