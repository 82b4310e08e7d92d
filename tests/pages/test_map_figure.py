"""The figure of a map holds the values of its runs, in colours that anyone can tell apart."""

from __future__ import annotations

import itertools
import json
import math
import re
import struct
import zlib
from base64 import b64decode

import pytest

from sim.pages.blocks.extension import CartsExtension, Page, set_page
from sim.pages.blocks.scene_block import Lesson
from sim.pages.findings import Finding
from sim.pages.map.bake import MapRun, bake_map
from sim.scene.fence.map import read_map
from tests.pages.given.map_views import MAP, pixels, rendered, scale_of, view

NONE, ZERO = [176, 176, 176], [32, 32, 32]


def decoded(html: str) -> tuple[int, int, list[tuple[int, ...]]]:
    """Width, height and colours of the picture in a map, read by hand."""
    match = re.search(r"data:image/png;base64,([\w+/=]+)", html)
    assert match is not None
    file, chunks, at = b64decode(match[1]), {}, 8
    while at < len(file):
        (length,) = struct.unpack(">I", file[at : at + 4])
        kind, data = file[at + 4 : at + 8], file[at + 8 : at + 8 + length]
        (check,) = struct.unpack(">I", file[at + 8 + length : at + 12 + length])
        assert check == zlib.crc32(kind + data)
        chunks[kind], at = data, at + 12 + length
    width, height = struct.unpack(">II", chunks[b"IHDR"][:8])
    rows = zlib.decompress(chunks[b"IDAT"])
    colours = [tuple(chunks[b"PLTE"][k : k + 3]) for k in range(0, len(chunks[b"PLTE"]), 3)]
    return width, height, [colours[rows[k]] for k in range(len(rows)) if k % (width + 1)]


def luminance(colour: tuple[int, ...]) -> float:
    linear = [
        c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
        for c in (part / 255 for part in colour)
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def test_the_picture_has_the_colour_of_each_value() -> None:
    html = rendered()
    width, height, picture = decoded(html)
    described = read_map(MAP)
    run = bake_map(described, MAP)
    assert isinstance(run, MapRun)
    scale = scale_of(run.low, run.high)
    shades = [tuple(c) for c in view("give(pixels.palette(data));", scale)]
    step = (width - 1) // 20
    assert width == height == 20 * step + 1 >= 401
    for row in range(0, 21, 5):
        for column in range(0, 21, 5):
            value = run.values[row * 21 + column]
            place = (value - scale["low"]) / scale["step"] + 1e-9  # rounding below an edge is on it
            own = min(scale["count"] - 1, math.floor(place))
            seen = picture[(height - 1 - row * step) * width + column * step]
            edge = shades[scale["count"] + 1 + own]
            assert seen in (shades[own], edge, tuple(ZERO)), (row, column, value)


def test_lightness_alone_tells_the_order_of_the_colours() -> None:
    counts = range(2, 14)
    for colours in view("give(data.map((n) => palette.sequential(n)));", list(counts)):
        light = [luminance(colour) for colour in colours]
        assert light == sorted(light)
        assert all(b > 1.12 * a for a, b in itertools.pairwise(light))
    colours = view("give(palette.diverging(data));", [-5.0, -3.0, -1.0, 1.0, 3.0, 5.0])
    light = [luminance(colour) for colour in colours]
    assert light[0] < light[1] < light[2] and light[3] > light[4] > light[5]
    assert all(red > blue for red, _, blue in colours[3:])  # orange is to the right
    assert all(red < blue for red, _, blue in colours[:3])


def test_bands_begin_and_end_at_round_numbers_and_zero_is_between_two() -> None:
    edges = view("give(bands.edges(bands.scaleFor(-0.34, 0.83)));")
    assert edges == pytest.approx([-0.4 + 0.1 * k for k in range(14)], abs=1e-12)
    assert 0.0 in edges
    assert scale_of(0.0, 18.3)["low"] == 0.0
    for flat in (0.0, 1.0, -2.0):
        assert scale_of(flat, flat)["count"] >= 1


def test_where_there_is_no_value_there_is_no_band() -> None:
    scale = scale_of(0.0, 1.0)
    nothing = pixels([0.1, None, 0.2, 0.3], 2, scale)
    assert any(scale["count"] in row for row in nothing)
    assert nothing[-1][0] in (1, scale["count"] + 2)
    assert NONE not in scale["colours"]


def test_the_line_of_zero_is_drawn_where_the_sign_changes() -> None:
    scale = scale_of(-1.0, 1.0)
    drawn = pixels([x / 10 for x in range(-9, 10)] * 2, 19, scale)
    line = 2 * scale["count"] + 1
    places = sorted({x for row in drawn for x, place in enumerate(row) if place == line})
    zero = (len(drawn[0]) - 1) // 2
    assert places == [zero - 1, zero]
    one_sign = scale_of(0.0, 1.0)
    last = 2 * one_sign["count"] + 1
    assert not any(last in row for row in pixels([0.0, 0.5, 1.0, 0.2], 2, one_sign))


def test_the_scale_reaches_as_far_as_the_sliders() -> None:
    slider = {"set": "A.velocity", "from": "0.1 m/s", "to": "3 m/s", "step": "0.1 m/s"}
    ends = []
    for html in (rendered(), rendered(controls=[slider])):
        facts = json.loads(re.findall(r'carts-map-baked">(.*?)</script>', html)[0])
        scale = scale_of(facts["low"], facts["high"])
        ends.append(scale["low"] + scale["count"] * scale["step"])
    assert ends[0] < 0.7
    assert ends[1] > 2.0


def test_the_scale_holds_what_lies_between_the_ends_of_a_slider() -> None:
    """A cart in the middle hands on most when its mass is the geometric mean of both others."""
    row = {
        "carts": {
            "A": {"mass": "4 kg", "position": 0.3, "velocity": "0.5 m/s"},
            "B": {"mass": "8 kg", "position": 1.0},
            "C": {"mass": "1 kg", "position": 1.7},
        },
        "track": {"length": 6}, "contact": {"law": "instant"}, "until": 3, "id": "middle",
        "over": [{"set": "A.velocity", "from": "0.1 m/s", "to": "0.5 m/s"}], "show": "v.C",
        "points": 5,
        "controls": [{"set": "B.mass", "from": "0.5 kg", "to": "8 kg", "step": "0.5 kg"}],
    }  # fmt: skip
    run = bake_map(read_map(row), row)
    assert isinstance(run, MapRun)
    assert run.high > 0.99 * 0.5 * (2 * 4 / 6) * (2 * 2 / 3)


def test_where_values_jump_no_band_between_is_drawn_and_no_line_of_zero() -> None:
    """A second hit throws a cart back: in between it has no velocity."""
    scale = scale_of(-1.0, 1.0)
    steps = [0.10, 0.12, 0.14, 0.16, -0.90, -0.88, -0.86, -0.84]
    drawn = pixels(steps * 3 + [0.08, *steps[:-1]] * 3, 8, scale)
    line, count = 2 * scale["count"] + 1, scale["count"]
    plain = {place if place < count else place - count - 1 for row in drawn for place in row}
    assert line not in {place for row in drawn for place in row}
    assert plain == {int((v - scale["low"]) / scale["step"] + 1e-9) for v in steps}


def test_a_curve_breaks_at_a_jump_and_beyond_its_axis() -> None:
    paths = view(
        """const { curve } = await import(view + "/map/figure.js");
        const axes = [{ set: "A.mass", low: 0, high: 5, scale: 1, unit: "kg", values: [] }];
        const at = [0, 1, 2, 3, 4, 5];
        give(data.map((values) => curve({ axes, low: 0, high: 1 }, at, values)));""",
        [
            [0, 0.1, 0.2, 0.3, 0.4, 0.5],
            [0, 0.02, 0.04, 0.9, 0.92, 0.94],
            [0, 0.4, 0.8, 1.6, 0.8, 0.4],
            [0.98, 0.3, 0.05, 0.02, 0.01, 0.0],
        ],
    )
    assert [path.count("M") for path in paths] == [1, 2, 2, 1]
    assert [path.count("L") for path in paths] == [5, 4, 3, 5]


def test_a_map_over_one_number_is_a_curve() -> None:
    html = rendered(over=[{"set": "contact.restitution", "from": 0, "to": 1}], show="warmed")
    assert "data:image" not in html
    (path,) = re.findall(r'class="carts-curve" d="(M[^"]+)"', html)
    points = [tuple(map(float, pair.split())) for pair in re.split("[ML]", path)[1:]]
    assert len(points) == 21
    assert [y for _, y in points] == sorted(y for _, y in points)  # warmed falls as e grows


def test_the_table_holds_values_of_runs() -> None:
    html = rendered()
    assert html.count("<tr>") == 2 + 11
    assert "−0.120" in html  # at 0.5 kg and e = 0.8, as in the scene
    spread = view(
        "give(data.map(([count, most]) => table.spread(count, most)));", [[21, 11], [4, 11]]
    )
    assert spread == [list(range(0, 21, 2)), [0, 1, 2, 3]]


def test_values_have_three_figures_and_rounding_is_nought() -> None:
    texts = view(
        """give(data.map((v) => words.valueText(v ?? NaN, { low: -3, high: 6.93 })));""",
        [6.928, 0.0346, -1e-17, None, -2.5],
    )
    assert texts == ["6.93", "0.0346", "0.00", "no value", "−2.50"]


def test_a_map_takes_its_scene_from_the_page_and_makes_it_carry_numpy() -> None:
    from markdown import Markdown

    found: list[Finding] = []
    page = Page(Lesson("lesson.md"), report=found.append)
    set_page(page)
    text = (
        "```map\nid: two\nof: one\nover: [{set: A.mass, from: 1, to: 2}]\nshow: v.A\npoints: 9\n"
        "```\n\n```scene\nid: one\ntitle: A crash\ncarts:\n  A: {mass: 1, position: 0, velocity: 1}"
        "\n  B: {mass: 1, position: 1}\n```\n"
    )
    try:
        html = Markdown(extensions=[CartsExtension()]).convert(text)
    finally:
        set_page(None)
    assert found == []
    assert html.index("<carts-map") < html.index("<carts-scene")
    assert 'href="#one"' in html
    assert "Velocity of A at the end" in html
    assert page.packages == {"numpy"}
    assert page.scenes == 2
    assert 'data-packages=""' in html  # the scene itself starts without numpy


def test_a_map_carries_the_packages_that_its_runs_need() -> None:
    plain = {**MAP, "contact": {"law": "hertz", "stiffness": 1e5}, "points": 2}
    plain["over"] = [{"set": "A.mass", "from": 0.4, "to": 0.6}]
    run = bake_map(read_map(plain), plain)
    assert isinstance(run, MapRun)
    assert run.packages == ("numpy", "scipy")
    assert not any(math.isnan(value) for value in run.values)
    assert "a run of its own" in run.why


def test_a_map_without_any_value_is_an_error() -> None:
    over = [{"set": "A.position", "from": "1 m", "to": "1.2 m"}]
    carts = {**MAP["carts"], "A": {"mass": 1, "position": "1.1 m"}}
    plain = {**MAP, "carts": carts, "over": over, "start": {"overlap": True}, "points": 3}
    assert isinstance(bake_map(read_map(plain), plain), MapRun)
    many = {**MAP, "track": {"length": "2.4 m", "left": "wall", "right": "wall"}, "points": 3}
    many |= {"contact": {"law": "instant", "restitution": 1}, "until": "3 h"}
    many["over"] = [{"set": "A.mass", "from": 0.4, "to": 0.6}]
    problems = bake_map(read_map(many), many)
    assert isinstance(problems, list)
    assert problems[0].code == "no-value"
    assert problems[0].hint
