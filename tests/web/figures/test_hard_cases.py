"""The hard cases run in the reader's browser; a run can be stopped, and what was prepared stays."""

from __future__ import annotations

import html
import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

from sim.pages.hard_cases import GROUPS
from sim.pages.hard_cases.block import HardCasesBlock
from sim.pages.hard_cases.render import render_hard_cases
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import STRICT
from tests.web.scene.given.widget_site import PAGE, widget_site

pytestmark = [pytest.mark.browser, pytest.mark.slow]

__all__ = ["widget_site"]  # a fixture

RUNNING = 120_000
"""ms, for all cases that need no packages on a machine that others use too."""


FEW = tuple(
    (name, tuple(case for k, case in enumerate(cases, 1) if k < 3 or k % 6 == 0))
    for name, cases in GROUPS
)
"""A few of each group, one of them for scipy. All of them run in test_same_physics.py."""
CASES = [case for _, group in FEW for case in group]


@pytest.fixture
def hard_page(widget_site: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr("sim.pages.hard_cases.render.GROUPS", FEW)
    page = widget_site / "hard.html"
    made = render_hard_cases(HardCasesBlock("hard"))
    page.write_text(PAGE.format(csp=html.escape(STRICT), body=made), encoding="utf-8")
    return page


@pytest.mark.one_browser
def test_cases_come_out_in_the_browser_as_their_sources_say(
    hard_page: Path, open_page: OpenPage
) -> None:
    page = open_page(hard_page)
    hard = page.locator("#hard")
    row = hard.locator('[data-case="mass-ratio-1e+09"]')
    expect(row.locator('[data-verdict="wrong"]')).to_have_count(3)  # without Python
    hard.locator(".carts-hard-go").click()
    # This site carries no scipy: a cradle of balls is told of.
    expect(hard.locator(".carts-note")).to_contain_text("as it is", timeout=RUNNING)
    answers = hard.evaluate("(el) => el.answers")
    here = [case for case in CASES if case.plain.get("contact", {}).get("law") != "hertz"]
    assert set(answers) == {case.name for case in here}
    for case in here:
        for expected, got in zip(case.expected, answers[case.name]["exact"]["got"], strict=True):
            assert abs(got - expected.value) <= expected.tolerance, case.name
    assert hard.locator(".carts-hard-fresh").count() == len(here)
    expect(row).to_have_class(re.compile("carts-hard-fresh"))


@pytest.mark.one_browser
def test_a_run_can_be_stopped(hard_page: Path, open_page: OpenPage) -> None:
    page = open_page(hard_page)
    hard = page.locator("#hard")
    before = hard.locator("[data-part]").all_inner_texts()
    hard.locator(".carts-hard-go").focus()
    page.keyboard.down("Enter")
    page.keyboard.down("Enter")  # held: it begins once, and does not stop what it began
    page.keyboard.up("Enter")
    expect(hard.locator(".carts-hard-stop")).to_be_focused()
    said = hard.locator(".carts-hard-say")
    expect(said).to_have_text(re.compile(r"^([3-9]|\d\d) of \d+$"), timeout=RUNNING)
    hard.locator(".carts-hard-stop").click()
    expect(said).to_contain_text("Stopped after")
    expect(hard.locator(".carts-hard-go")).to_be_visible()
    assert len(hard.evaluate("(el) => Object.keys(el.answers)")) < len(CASES)
    assert hard.locator("[data-part]").count() == len(before)
