"""A `cost` block: what stands in the page before Python starts, and what an author did wrong."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from sim.bridge.protocol import answer
from sim.pages.cost.block import CostBlock, read_cost_block
from sim.pages.cost.figure import LABELS, METHODS, figure, x_at, y_at
from sim.pages.cost.render import MEASURED, cells, render_cost, told
from sim.pages.fence_scan import scan
from sim.pages.findings import AuthorError
from sim.pages.scene_block import Lesson, SiteIds
from tests import registry
from tests.web.widget_site import in_node

SCENES = Path(__file__).parents[1] / "scenes"


def read(text: str) -> CostBlock:
    (block,) = scan(f"```cost\n{text}\n```".splitlines())
    return read_cost_block(block, Lesson("page.md", (SCENES,)), SiteIds(), first_line=1)


def rows() -> list[dict]:  # type: ignore[type-arg]
    text = (MEASURED / "paper-two-carts.json").read_text(encoding="utf-8")
    return list(json.loads(text)["rows"])


def test_figure_numbers_and_run_stand_in_the_page() -> None:
    made = render_cost(read("id: c\nscenes: [paper-two-carts.yml, off-the-wall.yml]"))
    assert made.count('class="carts-cost-point" transform') == len(rows())
    assert "145.4 %" in made and "64.0 %" in made  # Euler with 103 steps, and exactly
    found = re.search(r'carts-cost-baked">(.*?)</script>', made, re.DOTALL)
    assert found is not None
    facts = json.loads(found[1])
    assert list(facts["scenes"]) == ["paper-two-carts", "off-the-wall"]
    assert len(facts["run"]["numbers"]) == 7 * facts["run"]["header"]["rows"]


def test_the_measured_table_is_still_true() -> None:
    # Times are of another day; errors and evaluations are not allowed to be.
    plain = registry.plain("paper-two-carts")
    known = {(row["method"], row.get("step"), row.get("rtol")): row for row in rows()}
    for number in (2, 4, 9, 19):
        header, _ = answer({"id": 1, "kind": "cost", "scene": plain, "row": number})
        (row,) = header["rows"]
        kept = known[row["method"], row.get("step"), row.get("rtol")]
        assert row["evaluations"] == kept["evaluations"]
        assert row["error_v"] == pytest.approx(kept["error_v"], rel=1e-3)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("scenes: [paper-two-carts.yml]", "id and scenes are needed"),
        ("id: c\nscenes: [no-such.yml]", "there is no scene file"),
        ("id: c\nscenes: [paper-two-carts.yml]\nmethod: rk4", "unknown key “method”"),
    ],
)
def test_an_author_is_told_what_is_wrong(text: str, said: str) -> None:
    with pytest.raises(AuthorError, match=said):
        read(text)


def test_every_method_has_a_name_a_mark_and_a_place() -> None:
    assert set(LABELS) == set(METHODS)
    marks = [one["mark"] for one in figure(rows())["series"]]
    assert len(set(marks)) == len(METHODS)


def test_the_page_writes_and_draws_what_the_generator_does() -> None:
    plain = registry.plain("paper-two-carts")
    header, _ = answer({"id": 1, "kind": "cost", "scene": plain, "method": "rk4", "parts": 61})
    numbers = [0.3, 1.0, 208.6, 3e4, 1e9]
    errors = [0.0, 3e-16, 0.0141, 40.0]
    seen = in_node(
        "const { xAt, yAt } = await import(`${source}/cost/figure.js`);\n"
        "const { cells, told } = await import(`${source}/cost/table.js`);\n"
        "give({ x: data.numbers.map(xAt), y: data.errors.map(yAt), told: told(data.header),\n"
        "  cells: data.rows.map((row) => cells(row, 1, data.labels)) });",
        {"numbers": numbers, "errors": errors, "header": header, "rows": rows(), "labels": LABELS},
    )
    assert seen["x"] == pytest.approx([x_at(n) for n in numbers])
    assert seen["y"] == pytest.approx([y_at(e) for e in errors])
    assert seen["told"] == [list(line) for line in told(header)]
    assert seen["cells"] == [cells(row, 1.0) for row in rows()]
