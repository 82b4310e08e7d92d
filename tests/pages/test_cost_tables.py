"""The tables of what accuracy costs are files: all but the times in them is what comes out now."""

from __future__ import annotations

import json
import re
from datetime import date
from pathlib import Path
from typing import Any

import pytest

from sim.cli.proved import proved
from sim.dynamics.cost import measure
from sim.dynamics.cost.exact import exact
from sim.dynamics.cost.report import digits_of, floor_of
from sim.pages.cost.render import MEASURED
from sim.pages.cost.write_measured import text_of
from tests import registry
from tests.web.scene.given.widget_site import in_node

ROOT = Path(__file__).parents[2]
NAMES = sorted(file.stem for file in MEASURED.glob("*.json") if file.stem != "breaks")
FINEST = 110
"""Steps of the rows that are run again."""


def kept(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((MEASURED / f"{name}.json").read_text(encoding="utf-8"))
    return found


@pytest.fixture(autouse=True)
def untimed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measure, "ratio", lambda *_: 1.0)
    monkeypatch.setattr("sim.cli.proved.ratio", lambda *_: 1.0)


@pytest.mark.parametrize("name", NAMES)
def test_a_table_has_the_certificate_that_there_is(name: str) -> None:
    """The springs had none, and their errors were those against a run, after a proof was found."""
    scene, table = registry.scene(name), kept(name)
    pytest.importorskip("flint")
    found = proved(scene, exact(scene))
    assert table["proved"] == bool(found)
    assert found is not None
    (row,) = (row for row in table["rows"] if row["method"] == "certified")
    assert row["error_v"] == pytest.approx(found[1].error_v, rel=1e-3)


@pytest.mark.parametrize("name", NAMES)
def test_what_follows_from_the_rows_of_a_table_stands_in_it(name: str) -> None:
    table, truth = kept(name), exact(registry.scene(name))
    assert table["floor"] == pytest.approx(floor_of(truth), rel=1e-3)
    digits = digits_of(table["rows"], truth)["digits"]
    assert table["digits"] == pytest.approx(digits, rel=5e-3)  # of rows that were not yet rounded


@pytest.mark.parametrize("name", NAMES)
def test_the_errors_of_a_table_are_those_of_now(name: str) -> None:
    """Located touches had come to cost nearly three times as many forces as the springs' told."""
    scene, table = registry.scene(name), kept(name)
    rows = {(row["method"], row.get("step"), row.get("rtol")): row for row in table["rows"]}
    truth = exact(scene)
    for choice in measure.choices(scene, finest=FINEST):
        before = rows[choice.method, choice.step, choice.rtol]
        now = measure.row(scene, truth, choice)
        assert now.evaluations == pytest.approx(before["evaluations"], rel=0.05), choice
        if before["error_v"] is not None and 1e-10 < before["error_v"] < 1.0:
            assert now.error_v == pytest.approx(before["error_v"], rel=0.01), choice


def test_the_page_tells_what_its_tables_have() -> None:
    """Euler’s 14 times for a digit was noise of a clock, and explained."""
    page = (ROOT / "docs/accuracy/index.md").read_text(encoding="utf-8")
    labels = {
        "Euler, order 1": "euler",
        "velocity Verlet, order 2": "verlet",
        "RK4, order 4": "rk4",
        "Yoshida, order 4, symplectic": "yoshida",
        "Verlet + Richardson, order 4": "richardson",
        "RK4 + located touches": "rk4-events",
        "adaptive RK45 + located touches": "rk45",
        "adaptive DOP853 + located touches": "adaptive",
    }
    for label, method in labels.items():
        line = re.search(rf"\| {re.escape(label)} \| ([\d.]+)[^|]* \| ([\d.]+) \|", page)
        assert line is not None, label
        for told, name in zip(line.groups(), ("spring-pair", "paper-two-carts"), strict=True):
            assert float(told) == pytest.approx(kept(name)["digits"][method], rel=0.06), label
    for name in NAMES:  # “between half of it and twice”
        table = kept(name)
        (proof,) = (row["error_v"] for row in table["rows"] if row["method"] == "certified")
        assert 0.499 < proof / table["floor"] < 2.001, name


def test_an_error_stands_where_it_is_and_only_nought_on_the_line_of_rounding() -> None:
    """One that is less than half a step of the greatest speed was drawn as if it were that."""
    rows = [
        {"method": "exact", "time_ratio": 1, "error_v": error} for error in (0.0, 2.8e-17, 1e-9)
    ]
    points, level, places = in_node(
        """const { lineOf, yAt } = await import(view + "/cost/figure.js");
        give([lineOf(data, "exact", 5.6e-17).points, yAt(5.6e-17),
          data.map((row) => yAt(row.error_v))]);""",
        rows,
    )
    drawn = [float(y) for _, y in points]
    assert drawn == pytest.approx([level, *places[1:]], abs=0.1)


def test_a_table_is_written_as_it_is_read() -> None:
    table = kept("spring-pair")
    text = text_of(table, date(2026, 11, 30))
    found = json.loads(text)
    assert {**found, "measured": None} == {**table, "measured": None}
    assert found["measured"]["values"]["day"] == "30 November 2026"
    assert text.count("\n") == len(table["rows"]) + 2
