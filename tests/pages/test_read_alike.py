"""The key reads the same numbers off a run as the page, on every scene of the registry."""

from __future__ import annotations

import math
from array import array
from base64 import b64encode
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any

from sim.bridge.protocol import answer
from sim.lesson import Common
from sim.lesson.kinds.run import Reading
from sim.pages.question.as_opened import read_off
from tests import registry
from tests.web.scene.given.widget_site import in_node

SCRIPT = """const { fromWire } = await import(`${view}/trajectory.js`);
const { reading } = await import(`${source}/question/marking/own-run.js`);
give(data.map(({ header, base64, mass, asked }) => {
  const bytes = Uint8Array.from(Buffer.from(base64, "base64"));
  const run = fromWire(header, new Float64Array(bytes.buffer));
  return asked.map(([quantity, at]) => reading(run, mass, quantity, at));
}));"""
ALIKE = 1e-12
"""Relative to the largest of its quantity: the same cubic, written in two ways."""

Columns = Mapping[tuple[str, ...], array[float]]
Found = dict[tuple[str, float | str], Any]


def test_the_key_and_the_page_read_the_same_off_every_scene() -> None:
    runs = [answer({"id": 0, "kind": "run", "scene": registry.plain(name)})
            for name in registry.NAMES]  # fmt: skip
    for name, mine, theirs in zip(registry.NAMES, *read_twice(runs), strict=True):
        for one, value in mine.items():
            most = abs(mine[one[0], "largest"])
            close = math.isclose(theirs[one], value, rel_tol=ALIKE, abs_tol=ALIKE * most)
            assert close, (name, *one, value, theirs[one])


def test_a_slope_beyond_all_numbers_is_a_step_to_both() -> None:
    titles: list[list[str]] = [["t"], ["x", "A"], ["v", "A"], ["a", "A"]]
    header = {"rows": 2, "columns": titles, "events": [], "bodies": [{"name": "A", "mass": 1.0}]}
    numbers = array("d", [0.0, 1.0, 0.3, 0.4, math.inf, 0.0, 0.0, 0.0])
    ((mine,), (theirs,)) = read_twice([(header, numbers)])
    assert mine["x.A", 0.5] == theirs["x.A", 0.5] == 0.3


def read_twice(runs: list[tuple[dict[str, Any], array[float]]]) -> tuple[list[Found], list[Found]]:
    """Each run read off by Python, and by the page's own script."""
    given, ours = [], []
    for header, numbers in runs:
        columns = of_wire(header, numbers)
        mass = {body["name"]: body["mass"] for body in header["bodies"]}
        asked = asked_of(columns)
        base64 = b64encode(numbers.tobytes()).decode()
        given.append({"header": header, "base64": base64, "mass": mass, "asked": asked})
        ours.append({one: read_off(reading(*one), columns, mass) for one in asked})
    pairs = zip(ours, in_node(SCRIPT, given), strict=True)
    return ours, [dict(zip(mine, found, strict=True)) for mine, found in pairs]


def of_wire(header: Mapping[str, Any], numbers: array[float]) -> Columns:
    rows = header["rows"]
    return {
        tuple(title): numbers[k * rows : (k + 1) * rows]
        for k, title in enumerate(header["columns"])
    }


def asked_of(columns: Columns) -> list[tuple[str, float | str]]:
    """Every quantity that can be read, at every moment; each once."""
    names = [(what, *rest) for what, *rest in columns if what in ("x", "v", "a", "F")]
    quantities = [f"{what}.{whose}" for what, whose in names]
    quantities += [f"p.{whose}" for what, whose in names if what == "v"]
    every = [(quantity, at) for quantity in quantities for at in moments(columns[("t",)])]
    return list(dict.fromkeys(every))


def moments(times: array[float]) -> Iterator[float | str]:
    """Those that have a name, every row and jump, and three places between any two rows."""
    yield from ("start", "end", "largest")
    yield from times
    for begin, end in pairwise(sorted(set(times))):
        yield from (begin + part * (end - begin) for part in (0.125, 0.5, 0.95))


def reading(quantity: str, at: float | str) -> Reading:
    return Reading(
        common=Common(id="one", ask="?"), scene="s", quantity=quantity, at=at,
        unit="", units={}, per=1.0, tolerance=0.01, relative=False,
    )  # fmt: skip
