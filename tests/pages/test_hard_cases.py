"""The page of hard cases is the suite: all of it, with what comes out, and files that run."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from sim.bridge.end_state import read
from sim.bridge.hard_answer import METHODS as TRIED
from sim.bridge.protocol import answer
from sim.cli import main
from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.findings import AuthorError
from sim.pages.hard_cases import ALL, HardCase
from sim.pages.hard_cases.block import HardCasesBlock, read_hard_cases_block
from sim.pages.hard_cases.measured import measure, measured
from sim.pages.hard_cases.render import render_hard_cases, yaml_text
from sim.pages.text.fence_scan import scan
from sim.pages.text.yaml.source import load
from sim.scene import read_scene
from tests import registry
from tests.web.scene.given.widget_site import in_node

ROOT = Path(__file__).parents[2]
KNOWN = measured()
MADE = render_hard_cases(HardCasesBlock("hard"))


def test_the_page_has_a_row_for_every_case_of_the_suite() -> None:
    assert re.findall(r'<tr data-case="([^"]+)"', MADE) == [case.name for case in ALL]
    assert list(KNOWN) == [case.name for case in ALL]
    found = re.search(r'carts-hard-baked">(.*?)</script>', MADE, re.DOTALL)
    assert found is not None
    for case in ALL:
        asked = json.loads(found[1])[case.name]
        assert asked["within"] == [one.tolerance for one in case.expected]
        assert read_scene(asked["scene"]) == read_scene(case.plain)


def test_the_prose_of_the_page_writes_numbers_as_its_table_does() -> None:
    """“31 415” in a sentence and “31415” in the row that it speaks of were two ways of writing."""
    prose = (ROOT / "docs/accuracy/hard-cases.md").read_text(encoding="utf-8")
    assert re.findall(r"\d[ \u00a0\u202f]\d{3}\b", prose + MADE) == []


def test_a_cart_that_comes_to_rest_within_a_rounding_is_right() -> None:
    """RK4 was wrong by 5e-16 m/s: nothing moves at the start, and 1 % was taken of nought."""
    tried = KNOWN["rest-on-a-soft-wall"]["stepped"]
    assert all(abs(one["got"][1]) < 1e-14 for one in tried)
    assert {one["verdict"] for one in tried} == {"right"}


@pytest.mark.parametrize("case", ALL, ids=lambda case: case.name)
def test_what_stands_there_is_what_comes_out(case: HardCase) -> None:
    """To the last bit where it can be: rows within their tolerance stayed as an older solver had
    left them."""
    now, kept = measure(case), KNOWN[case.name]
    if case.plain.get("contact", {}).get("law") == "instant" and not case.plain["effects"]:
        assert now == kept  # sums, products and quotients are the same on every computer
    for one, got, before in zip(
        case.expected, *(r["exact"]["got"] for r in (now, kept)), strict=True
    ):
        assert abs(got - one.value) <= one.tolerance
        assert abs(before - one.value) <= one.tolerance
    for new, old in zip(now["stepped"], kept["stepped"], strict=True):
        assert (new["method"], new["step"], new["verdict"]) == tuple(
            old[key] for key in ("method", "step", "verdict")
        )
        if new["verdict"] != "blows-up":  # those differ between two libraries of sines
            assert new["got"] == pytest.approx(old["got"], rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("name", ["collapse-just-above", "collapse-below"])
def test_a_collapse_is_hard(name: str) -> None:
    """Only the momentum was asked for, which every method keeps."""
    assert {one["verdict"] for one in KNOWN[name]["stepped"]} == {"wrong"}


RULES = {
    "v": "the closing speed",
    "v-": "the difference of two velocities",
    "x": "the place",
    "energy": "the energy",
    "warmed": "the energy",
    "work": "the energy",
    "count": "A count has to be right exactly",
    "last": "when the last contact comes",
}
"""By what is asked for, in the words of the page: what 1 % is taken of (`_scale`)."""


def test_the_page_says_what_right_means_for_every_number_that_is_asked_for() -> None:
    prose = " ".join((ROOT / "docs/accuracy/hard-cases.md").read_text(encoding="utf-8").split())
    told = prose.partition("*Right* means:")[2].partition("| word |")[0]
    for case in ALL:
        for one in case.expected:
            kind, _, whose = one.what.partition(".")
            rule = "v-" if kind == "v" and "-" in whose and one.value else kind
            assert RULES[rule] in told, one.what


@pytest.mark.parametrize("case", ALL, ids=lambda case: case.name)
def test_the_file_of_a_row_is_its_scene(case: HardCase) -> None:
    assert read_scene(load(yaml_text(case.plain)).plain) == read_scene(case.plain)


def test_the_command_of_a_row_gives_what_the_row_says(tmp_path: Path) -> None:
    case = next(case for case in ALL if case.name == "triple-hit-bumper")
    file = tmp_path / f"{case.name}.yml"
    file.write_text(yaml_text(case.plain), encoding="utf-8")
    step = KNOWN[case.name]["stepped"][0]["step"]
    for told, more in (
        (KNOWN[case.name]["exact"]["got"], []),
        (KNOWN[case.name]["stepped"][0]["got"], ["--method", "euler", "--step", repr(step)]),
    ):
        done = CliRunner().invoke(main, ["run", str(file), "--json", *more])
        assert done.exit_code == 0, done.output
        got = [read(json.loads(done.output), one.what) for one in case.expected]
        assert got == pytest.approx(told, rel=1e-8)


def ask(plain: dict[str, Any], *expected: tuple[str, float]) -> dict[str, str]:
    asked = {"id": 2, "kind": "hard", "scene": plain, "expected": [list(one) for one in expected]}
    header, _ = answer(asked)
    assert header["ok"], header
    json.dumps(header, allow_nan=False)
    return {one["method"]: one["verdict"] for one in header["stepped"]}


def test_verdicts_name_what_went_wrong() -> None:
    hard = registry.two_carts(law="bumper", restitution=1, stiffness=2e4)
    assert ask(hard, ("v.A", -1.0))["euler"] in ("makes-energy", "blows-up")
    free = {"carts": {"A": {"mass": 1, "position": 0, "velocity": 1}}, "until": 3}
    assert set(ask(free, ("x.A", 3.0)).values()) == {"right"}
    assert set(ask(free, ("x.A", 4.0)).values()) == {"wrong"}
    assert set(ask(free, ("count.contact", 1)).values()) == {"misses"}


def test_every_verdict_and_every_method_has_words() -> None:
    told = sorted({one["verdict"] for known in KNOWN.values() for one in known["stepped"]})
    methods, words = in_node(
        """const w = await import(view + "/hard/words.js");
        give([Object.keys(w.METHODS),
          data.map((verdict) => w.steppedCell([], { verdict, got: [] })[0])]);""",
        told,
    )
    assert tuple(methods) == TRIED
    page = (ROOT / "docs" / "accuracy" / "hard-cases.md").read_text(encoding="utf-8")
    for verdict, said in zip(told, words, strict=True):
        assert said != verdict or said in ("right", "wrong", "misses")
        assert said.removeprefix("carts ") in page or said == "right"


def test_a_cell_tells_the_number_that_is_farthest_off() -> None:
    wanted = [["v.A", 1.0], ["x.B-A", 0.25], ["count.contact", 3]]
    exact, stepped, blown = in_node(
        """const { exactCell, steppedCell } = await import(view + "/hard/words.js");
        give([exactCell(data, { got: [1, 0.25, 3] }),
          steppedCell(data, { verdict: "wrong", got: [1.001, 0.5, 3] }),
          steppedCell(data, { verdict: "blows-up", got: [null, 0.5, 3] })]);""",
        wanted,
    )
    assert exact == "v of A: 1\u00a0m/s, no error"  # no number is torn from its unit
    assert stepped == ["wrong", "x of B − x of A: 0.5\u00a0m, off by 0.25\u00a0m"]
    assert blown == ["blows up", ""]


@pytest.mark.parametrize(
    ("text", "said"),
    [("title: no id", "an id is needed"), ("id: h\nrows: 3", "unknown key “rows”")],
)
def test_an_author_is_told_what_is_wrong(text: str, said: str) -> None:
    (block,) = scan(f"```hard-cases\n{text}\n```".splitlines())
    with pytest.raises(AuthorError, match=said):
        read_hard_cases_block(block, Lesson("page.md"), SiteIds(), first_line=1)


A_PROGRAMS_SIGNS = re.compile(r"\de[+-]?\d|\^-?\d|\b(sqrt|pi|mu|beta|zeta)\b|(?<![.\d])\d{5}")


@pytest.mark.parametrize("case", ALL, ids=lambda case: case.name)
def test_what_is_hard_is_told_in_a_readers_signs(case: HardCase) -> None:
    assert not A_PROGRAMS_SIGNS.findall(f"{case.sentence} {case.why}")
