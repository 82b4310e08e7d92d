"""A `cost` block: what stands in the page before Python starts, and what an author did wrong."""

from __future__ import annotations

import json
import re
from itertools import pairwise
from pathlib import Path

import pytest

from sim.bridge.protocol import answer
from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.cost.block import CostBlock, read_cost_block
from sim.pages.cost.render import MEASURED, render_cost
from sim.pages.findings import AuthorError
from sim.pages.text.fence_scan import scan
from tests import registry
from tests.web.scene.given.widget_site import in_node

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
    methods = in_node('give((await import(view + "/cost/methods.js")).METHODS);', None)
    marks = [one["mark"] for one in methods.values()]
    assert len({*marks}) == len({one["label"] for one in methods.values()}) == len(methods)
    assert {row["method"] for row in rows()} <= set(methods)


def test_an_error_beyond_all_numbers_is_said_and_is_not_a_dash() -> None:
    blown = {"method": "rk4", "step": 0.1, "evaluations": 40, "time_ratio": 9,
             "error_v": None, "error_x": None, "energy_error": None}  # fmt: skip
    exact = {**blown, "method": "exact", "step": None, "evaluations": 0}
    lines = in_node(
        """const { cells } = await import(view + "/cost/words.js");
        give(data.map((row) => cells(row, 1)));""",
        [blown, exact],
    )
    assert lines[0][-2:] == ["beyond all numbers"] * 2
    assert lines[1][-2:] == ["–", "–"]


def test_axes_are_logarithmic_and_nought_has_a_place_below_them() -> None:
    x, y, floor, nought = in_node(
        """const { xAt, yAt } = await import(view + "/cost/figure.js");
        give([data.map(xAt), data.map((k) => yAt(k / 1e6)), yAt(1e-17), yAt(0)]);""",
        [1, 10, 100, 1000, 1e6],
    )
    steps = [b - a for a, b in pairwise(x)]
    assert steps == pytest.approx([steps[0]] * 3 + [3 * steps[0]])
    falls = [a - b for a, b in pairwise(y)]
    assert falls == pytest.approx([falls[0]] * 3 + [3 * falls[0]])
    assert floor == nought > max(y)


def test_the_numbers_beside_a_run_are_those_of_the_run() -> None:
    plain = registry.plain("paper-two-carts")
    header, _ = answer({"id": 1, "kind": "cost", "scene": plain, "method": "rk4", "parts": 61})
    lines = in_node('give((await import(view + "/cost/words.js")).told(data));', header)
    assert lines[0][0] == "velocity of A at the end"
    for line, name in zip(lines, header["v"]["stepped"], strict=False):
        got, exact = (float(text.removesuffix(" m/s").replace("−", "-")) for text in line[1:])
        assert got == pytest.approx(header["v"]["stepped"][name], abs=5e-5)
        assert exact == pytest.approx(header["v"]["exact"][name], abs=5e-5)
    assert lines[-1] == ["times that all forces were computed", str(header["evaluations"]), "0"]
