"""What Python bakes and what the page computes are the same: module by module, in Node.js."""

from __future__ import annotations

import json
import math
from itertools import pairwise
from typing import Any

import pytest

from sim.pages.widget import graph as g
from sim.pages.widget.contacts import touches
from sim.pages.widget.exits import exits
from sim.pages.widget.numbers import decimals_for, decimals_of, fixed, px, short
from sim.pages.widget.run import from_wire, value_at
from sim.pages.widget.scales import axis, span
from sim.pages.widget.series import series_of
from sim.pages.widget.words import (
    event_sentence,
    exit_sentence,
    graph_note,
    laws_of,
    model_sentences,
)
from tests import registry
from tests.web.widget_site import MEETING, STRUCK, baked, in_node

NUMBERS = [
    0.0, -0.0, 1.0, -1.0, 0.5, 0.25, 0.125, 2.5, 0.0005, -0.00049, 1e-13, 12345.678, 999.95, 0.9996,
    1e9, -3e-7, 1 / 3, 2 / 3, 1e5, 1e6, 0.15, 0.35, 8.5, 1234.5, math.pi * 1e4, -math.e,
]  # fmt: skip
SCENES = [name for name in registry.NAMES if name != "slow-and-long"]


def test_numbers_read_the_same() -> None:
    here = [
        [fixed(v, 0), fixed(v, 2), fixed(v, 5), short(v), short(v, 5), px(v), px(v, 3)]
        for v in NUMBERS
    ]
    here.append([decimals_for(abs(v)) for v in NUMBERS])  # type: ignore[arg-type]
    here.append([decimals_of(v) for v in NUMBERS])  # type: ignore[arg-type]
    there = in_node(
        """const n = await import(source + "/numbers.js");
        give([...data.map((v) => [n.fixed(v, 0), n.fixed(v, 2), n.fixed(v, 5), n.short(v),
          n.short(v, 5), n.px(v), n.px(v, 3)]), data.map((v) => n.decimalsFor(Math.abs(v))),
          data.map((v) => n.decimalsOf(v))]);""",
        NUMBERS,
    )
    assert there == here


@pytest.mark.parametrize("value", [v for v in NUMBERS if v])
def test_a_small_number_is_never_minus_zero(value: float) -> None:
    for decimals in range(6):
        text = fixed(value, decimals)
        assert text.startswith("−") == (value < 0 and any(c in "123456789" for c in text))


def test_axes_have_the_same_ticks() -> None:
    spans = [(-0.3, 2.4), (0, 0.6), (0, 7.2), (-1e-7, 3e-7), (0, 0), (-5, -1), (0, 1e9), (0.1, 0.3)]
    here = [[vars_of(axis(*s, 4)), vars_of(span(s[0], s[1] + 1, 6))] for s in spans]
    there = in_node(
        """const s = await import(source + "/scales.js");
        const all = (axis) => [axis.low, axis.high, axis.step, s.axisDecimals(axis), s.ticks(axis)];
        give(data.map(([a, b]) => [all(s.axis(a, b, 4)), all(s.span(a, b + 1, 6))]));""",
        spans,
    )
    assert there == here


def vars_of(made: Any) -> list[Any]:
    return [made.low, made.high, made.step, made.decimals, made.ticks()]


def told(fence: dict[str, Any]) -> dict[str, Any]:
    _, header, numbers = baked(fence)
    return {"header": header, "numbers": numbers.tolist()}


@pytest.mark.parametrize("name", SCENES)
def test_curves_events_and_words_are_the_same(name: str) -> None:
    fence = {"id": "scene", **json.loads(json.dumps(registry.plain(name)))}
    _, header, numbers = baked(fence)
    run = from_wire(header, numbers)
    decimals = {"v": 2, "F": 1}
    here: dict[str, Any] = {"paths": [], "words": [], "touches": [], "exits": []}
    for quantity in ("x", "v", "a", "F", "p", "energy"):
        for signed in (False, True):
            curves = series_of(quantity, header, run, 0.1, signed=signed)
            plane = g.plane_for(curves, header["until"])
            here["paths"].append(
                [[c.label, c.style, c.over, g.path(c, run.t, plane)] for c in curves]
            )
    here["words"] = [
        event_sentence(
            e,
            decimals=decimals,
            scale=1.0,
            camera=0.1,
            forces=forces,
            laws=laws_of(header["contacts"]),
        )
        for forces in (False, True)
        for e in header["events"]
    ]
    here["words"] += model_sentences(header, told=True)
    here["words"] += [graph_note(q, header["events"], n) for q in ("x", "a", "F") for n in (0, 2)]
    here["touches"] = [[w.start, w.end] for w in touches(header["events"], header["until"])]
    gone = exits(header, run, 0.2, 1.5, 0.1)
    here["exits"] = [exit_sentence(e.name, e.side, e.velocity, 2, 1.0) for e in gone]
    there = in_node(
        """const [t, s, g, w, k, x] = await Promise.all(["trajectory", "series", "graph", "words",
          "windows", "exits"].map((name) => import(`${source}/${name}.js`)));
        const { header } = data;
        const run = t.fromWire(header, Float64Array.from(data.numbers));
        const out = { paths: [], words: [], touches: [], exits: [] };
        for (const quantity of ["x", "v", "a", "F", "p", "energy"]) {
          for (const signed of [false, true]) {
            const curves = s.seriesOf(quantity, header, run, 0.1, signed);
            const plane = g.planeFor(g.extent(curves), [0, header.until]);
            out.paths.push(curves.map((c) => [c.label, c.style, c.over, g.path(c, run.t, plane)]));
          }
        }
        for (const forces of [false, true]) {
          const telling = { decimals: { v: 2, F: 1 }, scale: 1, camera: 0.1, forces };
          const laws = w.lawsOf(header.contacts);
          out.words.push(...header.events.map((event) => w.eventSentence(event, telling, laws)));
        }
        out.words.push(...w.modelSentences(header));
        out.words.push(...["x", "a", "F"].flatMap((q) =>
          [0, 2].map((n) => w.graphNote(q, header.events, n))));
        out.touches = k.touches(header.events, header.until).map(({ start, end }) => [start, end]);
        out.exits = x.exits({ header, trajectory: run }, { low: 0.2, high: 1.5 }, 0.1)
          .map((exit) => w.exitSentence(exit, 2, 1));
        give(out);""",
        {"header": header, "numbers": numbers.tolist()},
    )
    assert there == here


def test_between_rows_a_cubic_is_met_exactly_and_a_jump_is_not_smoothed() -> None:
    times = [0.0, 1.0, 2.0, 2.0, 5.0]
    cubic = [0.0, 1.0, 8.0, -3.0, -9.0]  # t³ up to 2, then a jump and a straight line
    slopes = [0.0, 3.0, 12.0, -2.0, -2.0]
    asked = [-1.0, 0.0, 0.25, 0.5, 1.0, 1.9999999, 2.0, 3.5, 5.0, 6.0]
    wanted = [0, 0, 0.25**3, 0.125, 1.0, 1.9999999**3, -3.0, -6.0, -9.0, -9.0]
    here = [value_at(times, cubic, slopes, t) for t in asked]
    assert here == pytest.approx(wanted, abs=1e-12)
    there = in_node(
        """const { valueAt } = await import(source + "/trajectory.js");
        const [times, values, slopes, asked] = data;
        give(asked.map((t) => valueAt(times, values, slopes, t)));""",
        [times, cubic, slopes, asked],
    )
    assert there == here


def test_the_area_under_the_drawn_force_is_the_impulse() -> None:
    """What students see as area is what the ledger says, within half a percent."""
    _, header, numbers = baked(MEETING)
    run = from_wire(header, numbers)
    curves = series_of("F", header, run, 0.0)
    plane = g.plane_for(curves, header["until"])
    separate = [e for e in header["events"] if e["kind"] == "separate"]
    for curve, event in zip(curves[::2], separate, strict=True):
        points = drawn_points(g.path(curve, run.t, plane))
        area = sum(
            (x1 - x0) * (2 * plane.y(0) - y0 - y1) / 2 for (x0, y0), (x1, y1) in pairwise(points)
        )
        per_unit = (plane.x(1) - plane.x(0)) * (plane.y(0) - plane.y(1))
        # One tenth of a unit is the finest the picture draws; the contact is five units wide.
        assert area / per_unit == pytest.approx(event["impulse"], rel=0.03)


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


def test_a_jump_is_drawn_upright() -> None:
    """An instant impact changes the velocity at one time, not along a ramp."""
    _, header, numbers = baked(STRUCK)
    run = from_wire(header, numbers)
    curves = series_of("v", header, run, 0.0)
    plane = g.plane_for(curves, header["until"])
    points = drawn_points(g.path(curves[0], run.t, plane))
    assert len({x for x, _ in points}) == len(points) - 1


def test_typed_numbers_are_read_as_people_mean_them() -> None:
    read = in_node(
        """const { readTyped } = await import(source + "/typed.js");
        give(data.map(readTyped));""",
        ["1.5", "1,5", " 2 ", "−0,25", "1e-3", ".5", "1,000", "12,500", "1,000,000", "0,500",
         "500 g", "1,5 kg", "1e309", "NaN", "0x10", "", "one", "1.2.3", "٣", "9" * 100, "1 000"],
    )  # fmt: skip
    values = [r.get("value", r.get("text", "problem")) for r in read]
    assert values[:6] == [1.5, 1.5, 2, -0.25, 0.001, 0.5]
    assert values[9] == 0.5
    assert values[10:12] == ["500 g", "1.5 kg"]
    assert [v for k, v in enumerate(values) if k in {6, 7, 8} or k >= 12] == ["problem"] * 12
    assert read[6]["problem"] == "1,000 can mean 1 or 1000: type 1 or 1000"
    assert read[7]["problem"] == "12,500 can mean 12.5 or 12500: type 12.5 or 12500"


def test_slow_motion_makes_a_contact_last_and_misses_none() -> None:
    parts, ends = in_node(
        """const { slowParts, advance } = await import(source + "/slow.js");
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


def test_the_client_keeps_the_newest_request_and_survives_three_deaths() -> None:
    log = in_node(
        """const { Client } = await import(source + "/client.js");
        const log = [];
        let runtimes = 0;
        const start = async () => {
          runtimes += 1;
          const mine = runtimes;
          const runtime = { onlost: () => {}, stop: () => {}, request: (message) => {
            log.push(`${mine}:${message.set}`);
            if (message.set === "kill") { setTimeout(() => runtime.onlost("gone"), 1);
              return new Promise(() => {}); }
            return new Promise((resolve) => setTimeout(() => resolve({ header: { ok: true },
              numbers: new Float64Array(0) }), 2));
          } };
          return runtime;
        };
        const client = new Client(start);
        const [a, b] = [{}, {}];
        const ask = (owner, set) => client.ask(owner, () => ({ set }));
        const answers = await Promise.all([ask(a, 1), ask(a, 2), ask(a, 3), ask(b, 9)]);
        log.push(answers.map((answer) => answer.sent.set).join());
        const error = await ask(a, "kill").catch((reason) => reason);
        log.push(`${error.message} ${client.state} ${runtimes}`);
        give(log);""",
        None,
    )
    assert log == ["1:3", "1:9", "3,3,3,9", *[f"{k}:kill" for k in (1, 2, 3, 4)], "gone failed 4"]
