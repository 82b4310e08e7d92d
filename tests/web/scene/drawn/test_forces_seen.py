"""Forces that are no contacts can be seen: when to look, on which scale, what is drawn."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.pages.widget.effects_scale import greatest_force
from sim.pages.widget.scale_of import read_scales
from tests import registry
from tests.web.scene.given.seen_run import seen
from tests.web.scene.given.widget_site import baked, in_node

MEET: dict[str, Any] = {
    "carts": {
        "A": {"mass": 0.5, "position": 0.4, "velocity": 0.5},
        "B": {"mass": 1.5, "position": 1.2},
    },
    "track": {"length": 2.4},
    "effects": [{"magnets": {"between": ["A", "B"], "strength": 3e-4}}],
    "until": 3,
}
SPRING = registry.plain("release-by-a-spring")
PUSH: dict[str, Any] = {
    "carts": {"A": {"mass": 0.5, "position": 0.4}},
    "track": {"length": 2.4},
    "effects": [{"push": {"cart": "A", "force": 0.8, "until": 0.5}}],
    "until": 3,
}


def windows(plain: dict[str, Any]) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = seen(
        plain, 'give((await import(view + "/windows.js")).windowsOf(run));'
    )
    return found


def test_a_spring_that_is_let_go_is_watched_from_then_until_it_falls_off() -> None:
    (window,) = windows(SPRING)
    quarter = 0.5 * math.pi * math.sqrt(0.5 / 1.5 / 40)
    assert (window["pair"], window["loose"]) == ("A-B", True)
    assert [window["start"], window["end"]] == pytest.approx([1.0, 1.0 + quarter])


def test_magnets_are_watched_while_they_push_most() -> None:
    """Their force at both ends is some tenth of the greatest one, which lies between."""
    (window,) = windows(MEET)
    assert window["near"] is True
    assert 0.9 < window["start"] < 1.189 < window["end"] < 1.5


def test_magnets_that_are_let_go_are_watched_from_the_start_until_they_are_hardly_felt() -> None:
    """From rest at d0 the push strength/d³ is a tenth at d0 ∛10: when is that, by small steps?"""
    strength, apart, m = 3e-3, 0.1, 0.5 * 1.5 / 2.0
    d, v, t, dt = apart, 0.0, 0.0, 1e-5
    while d < apart * 10 ** (1 / 3):
        v += dt * strength / d**3 / m
        d, t = d + dt * v, t + dt
    carts = {"A": {"mass": 0.5, "position": 1.05, "length": 0.3},
             "B": {"mass": 1.5, "position": 1.45, "length": 0.3}}  # fmt: skip
    effects = [{"magnets": {"between": ["A", "B"], "strength": strength}}]
    (window,) = windows({**MEET, "carts": carts, "effects": effects, "until": 1.4})
    assert (window["near"], window["start"]) == (True, 0)
    assert t <= window["end"] < 1.15 * t  # the next row of the table


@pytest.mark.parametrize("predict", [None, {"choice": ["It stops", "It turns back"]}])
@pytest.mark.parametrize(
    ("plain", "peak"), [(MEET, 1.6794), (SPRING, 2.191)], ids=["magnets", "spring"]
)
def test_the_greatest_force_is_a_good_part_of_the_longest_arrow(
    plain: dict[str, Any], peak: float, predict: Any
) -> None:
    """Also where the run is not known yet: the scale follows from the start alone."""
    fence = {"id": "one", **plain} | ({"predict": predict} if predict else {})
    described, header, _ = baked(fence)
    full = read_scales(header, described.controls, None, 0.0).force
    assert 0.4 <= peak / full <= 1.0
    assert greatest_force(header, described.controls, None) == pytest.approx(1.7 * peak, rel=1e-3)


@pytest.mark.parametrize(("power", "closing"), [(1.0, 0.1), (2.0, 0.5), (4.0, 0.5)])
def test_the_estimate_of_magnets_is_what_two_alone_come_to(power: float, closing: float) -> None:
    plain = {
        **MEET,
        "carts": MEET["carts"] | {"A": MEET["carts"]["A"] | {"velocity": closing}},
        "effects": [{"magnets": {"between": ["A", "B"], "strength": 2e-3, "power": power}}],
        "until": 12,
    }
    _, header, _ = baked({"id": "one", **plain})
    (peak,) = [event for event in header["events"] if event["kind"] == "peak"]
    assert greatest_force(header, (), None) == pytest.approx(1.7 * peak["force"], rel=1e-6)


def test_what_happens_tells_of_spring_and_magnets_and_no_bumpers() -> None:
    script = """const w = await import(view + "/words.js");
    const telling = { decimals: { F: 2, v: 2 }, scale: 1, camera: 0, forces: data.forces };
    give(run.header.events.map((e) => w.eventSentence(e, telling, w.lawsOf(run.header))));"""
    spring = seen(SPRING, script, forces=True)
    assert spring[0] == "The spring between A and B is let go: 2.19\u00a0N on each."
    assert spring[1].startswith("A and B separate. Impulse on each: 0.200\u00a0N\u00a0s.")
    assert seen(MEET, script, forces=True)[0] == "A and B are nearest: 1.68\u00a0N on each."
    assert seen(MEET, script, forces=False)[0] == "A and B are nearest."


PIECES = """const { props } = await import(view + "/effects-props.js");
const layout = { track: 100, scale: 200, kind: "wide" };
const { t: rows, x, v } = run.trajectory;
const place = (name, time) => t.valueAt(rows, x[name], v[name], time);
give(data.times.map((time) => {
  const centre = (name) => 200 * place(name, time);
  const face = (name, side) => centre(name) + (side === "left" ? -20 : 20);
  return props(run, layout, time, face, centre);
}));"""


def span(d: str) -> tuple[float, float]:
    """The least and the greatest x of a path of M and L."""
    xs = [float(part.split()[0]) for part in d.replace("M", "L").split("L") if part]
    return min(xs), max(xs)


def test_the_spring_reaches_from_cart_to_cart_and_lies_there_when_they_are_gone() -> None:
    held, pushing, gone, later = seen(SPRING, PIECES, times=[0.5, 1.08, 1.6, 2.5])
    low, high = span(held[0]["d"])
    assert high - low == pytest.approx(18, abs=0.2)  # squeezed, and its plates
    wide = span(pushing[0]["d"])
    assert wide[1] - wide[0] > 20
    assert "carts-spent" in gone[0]["cls"]
    assert gone == later  # the carts move on, it does not
    lying = span(gone[0]["d"])
    assert lying[1] - lying[0] == pytest.approx(200 * math.sqrt(2 * 0.06 / 40) + 18, abs=0.3)


def test_the_hand_touches_the_cart_while_it_pushes_and_stays_behind_when_it_lets_go() -> None:
    first, last, after, gone = seen(PUSH, PIECES, times=[0.0, 0.499, 1.0, 2.5])
    assert "carts-palm" in first[0]["cls"]
    tip = [float(one[0]["d"].split("L")[1].split()[0]) for one in (first, last, after)]
    ways = 200 * 0.5 * 1.6 * 0.499**2
    assert tip[1] - tip[0] == pytest.approx(ways, abs=0.3)
    assert tip[2] < tip[1]
    assert gone == []


def test_who_is_not_a_hand_is_drawn_as_before() -> None:
    plain = {**PUSH, "effects": [{"push": {"cart": "A", "force": 0.8, "by": "fan", "until": 0.5}}]}
    during, after = seen(plain, PIECES, times=[0.2, 0.6])
    assert during[0]["cls"] == "carts-hand"
    assert after == []


def test_a_spring_that_is_let_go_in_a_contact_has_a_window_of_its_own() -> None:
    """Bumpers part first, then the spring falls off: two separations of one pair."""
    release = {"between": ["A", "B"], "energy": 0.06, "at": 0.12, "stiffness": 30}
    plain = {
        "carts": {
            "A": {"mass": 0.5, "position": 1, "velocity": 0.5},
            "B": {"mass": 1, "position": 1.25},
        },
        "contact": {"stiffness": 400},
        "effects": [{"release": release}],
        "until": 0.6,
    }
    contact, spring = windows(plain)
    assert [contact["start"], spring["start"]] == pytest.approx([0.1, 0.12])
    assert contact["end"] < spring["end"] < 0.6
    assert "loose" not in contact
    assert spring["loose"] is True


ANEW: dict[str, Any] = {
    "carts": {
        "A": {"mass": 0.22, "position": 0.4, "velocity": 1},
        "B": {"mass": 0.61, "position": 0.601},
        "C": {"mass": 0.47, "position": 0.934},
    },
    "contact": {
        "law": "paper",
        "restitution": 0,
        "stiffness": 29881,
        "pairs": {"B-C": {"law": "push-only", "restitution": 0.5, "stiffness": 310}},
    },
    "until": 2,
}


def test_two_that_part_and_touch_anew_at_one_instant_have_touched_twice() -> None:
    """A and B move on together until B meets C: their first hit had no window, so no impulse."""
    assert sorted((one["pair"], one["start"]) for one in windows(ANEW)) == [
        ("A-B", pytest.approx(0.001)),
        ("A-B", pytest.approx(0.50277, abs=1e-5)),
        ("B-C", pytest.approx(0.50277, abs=1e-5)),
    ]


NAMED = """const { Pushes } = await import(`${source}/scene/pushes.js`);
const part = () => ({ kept: {}, getAttribute(name) { return this.kept[name]; },
  setAttribute(name, value) { this.kept[name] = value; } });
const groups = ["A", "B"].map(() => ({ text: part(), arrow: part(),
  querySelector(name) { return name.includes("text") ? this.text : this.arrow; } }));
const root = { querySelector: (name) => groups[name.includes('on="A"') ? 0 : 1] };
const layout = { origin: 12, scale: 100, width: 350, track: 99, rows: [120], force: 58, slots: {} };
const pushes = new Pushes(root, layout, { force: 1.5, decimals: { F: 2 } });
const bodies = ["A", "B"];
const header = { contacts: [{ pair: "A-B", bodies }], track: {}, bodies: [], effects: [] };
const trajectory = { t: [0, 1], F: { "A-B": [0.12, 0.12] }, dF: { "A-B": [0, 0] } };
pushes.show({ header, trajectory }, [{ pair: "A-B", bodies, start: 0, end: 1 }]);
pushes.at(0.5, () => 170);
give(groups.map(({ text }) => [text.textContent, text.kept["text-anchor"], +text.kept.x]));"""


def test_two_names_of_forces_are_two() -> None:
    """“on A by B: 0.12 N on B by A: 0.12 N” read as one."""
    (first, end, left), (second, start, right) = in_node(NAMED, None)
    assert (first, end) == ("on A by B: 0.12 N", "end")
    assert (second, start) == ("on B by A: 0.12 N", "start")
    assert right - left >= 24  # units, about pixels: five blanks
