"""“How is this computed?”: nothing before it is opened; then plan and cost, and step by step."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from sim.bridge.protocol import answer
from sim.scene import read_fence
from sim.scene.said import said
from tests.web.conftest import OpenPage, SharePage
from tests.web.scene.given.counted_requests import COUNT, asked
from tests.web.scene.given.widget_site import (
    FENCES,
    LIVE,
    MEETING,
    live,
    on_scene,
    widget_site,
    write_page,
)

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture


FINAL = """const { x, v } = el.trajectory;
    return Object.keys(v).map((name) => [x[name].at(-1), v[name].at(-1)]);"""


def natively(name: str = "meeting", **more: Any) -> dict[str, Any]:
    """The header of the same run as Python computes it here."""
    scene = dict(read_fence(FENCES[name]).plain)
    header, _ = answer({"id": 1, "kind": "how" if more else "run", "scene": scene, **more})
    assert header["ok"], header
    return header


def ends(header: dict[str, Any]) -> list[list[float]]:
    final = header["final"]
    return [[final["x"][name], final["v"][name]] for name in final["v"]]


def english(wire: Any) -> str:
    """A sentence as it went to the page, {code, values} or plain text, told in English."""
    if isinstance(wire, str):
        return wire
    return said(wire["code"], **{name: english(value) for name, value in wire["values"].items()})


def opened(page: Page, name: str = "meeting") -> Page:
    page.locator(f"#{name} .carts-how > summary").click()
    return page


def choose(page: Page, method: str) -> None:
    page.locator("#meeting .carts-how-method").select_option(method)
    expect(page.locator("#meeting .carts-how-sign")).to_be_visible(timeout=LIVE)


@pytest.mark.one_browser
def test_nothing_is_made_or_asked_before_a_reader_opens_it(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    page.evaluate(COUNT)
    on_scene(page, 'await el.set({ "A.mass": 2 })')
    page.locator("#meeting .carts-play").click()
    page.wait_for_function("() => document.getElementById('meeting').time > 0.3")
    assert asked(page) == ["run"]
    assert page.locator("#meeting .carts-how-body > *").count() == 0
    opened(page)
    expect(page.locator("#meeting .carts-how-cost")).to_contain_text("just now", timeout=LIVE)
    assert asked(page) == ["run", "how"]


@pytest.mark.one_browser
def test_the_plan_and_its_cost_stand_there(shared_page: SharePage, widget_site: Path) -> None:
    page = opened(live(shared_page(widget_site / "meeting.html")))
    phases = natively()["plan"]
    lines = page.locator("#meeting .carts-how-plan li")
    expect(lines).to_have_count(len(phases))
    for line, phase in zip(lines.all_inner_texts(), phases, strict=True):
        assert english(phase["why"])[1:] in line
    cost = page.locator("#meeting .carts-how-cost")
    expect(cost).to_have_text(
        re.compile(r"contacts: 2\..*just now: [\d.]+ (ms|µs), of which .* for the motion"),
        timeout=LIVE,
    )
    expect(page.locator("#meeting .carts-how-method")).to_have_value("exact")
    offered = page.locator("#meeting .carts-how-method option").all_inner_texts()
    assert len(offered) == 6 and not any("adaptive" in text for text in offered)  # no scipy here


@pytest.mark.one_browser
def test_a_stepping_method_plays_and_the_exact_run_stays_behind(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = opened(live(shared_page(widget_site / "meeting.html")))
    exact = on_scene(page, FINAL)
    choose(page, "semi-implicit")
    stepped = natively(method="semi-implicit", parts=103)
    for got, true in zip(on_scene(page, FINAL), ends(stepped), strict=True):
        assert got == pytest.approx(true, rel=1e-12)
    assert on_scene(page, FINAL) != exact
    told = page.locator("#meeting .carts-how-told").inner_text()
    assert "error of a velocity" in told and "103" in told and "energy made" in told
    # Outlines stand where the exact run has the carts, and behind every curve there is a pale one.
    on_scene(page, "el.time = 3")
    places = page.evaluate(
        """() => [...document.querySelectorAll(".carts-stage-wide .carts-ghost")].map((ghost) => {
            const { x, width } = ghost.getBoundingClientRect();
            return x + width / 2;
        })"""
    )
    choose_exact(page)
    on_scene(page, "el.time = 3")
    carts = page.evaluate(
        """() => [...document.querySelectorAll(".carts-stage-wide .carts-cart")].map((cart) =>
            new DOMMatrix(getComputedStyle(cart).transform).e)"""
    )
    scale = page.evaluate(
        "document.querySelector('.carts-stage-wide').getBoundingClientRect().width / "
        "document.querySelector('.carts-stage-wide').viewBox.baseVal.width"
    )
    left = page.locator(".carts-stage-wide").bounding_box()
    assert left is not None
    assert places == pytest.approx([left["x"] + scale * x for x in carts], abs=0.5)
    assert on_scene(page, FINAL) == exact


@pytest.mark.one_browser
def test_a_table_ends_where_the_numbers_blow_up_and_the_plan_prints_whole(
    open_page: OpenPage, widget_site: Path
) -> None:
    stiff = {**MEETING, "id": "stiff", "contact": {"restitution": 1, "stiffness": "9000 N/m"}}
    page = live(open_page(write_page(widget_site, "stiff", stiff)), "stiff")
    page.locator("#stiff .carts-how > summary").click()
    page.locator("#stiff .carts-how-method").select_option("euler")
    told = page.locator("#stiff .carts-how-told")
    expect(told).to_contain_text("the numbers blow up")
    page.locator("#stiff .carts-graph summary").first.click()
    last = page.locator("#stiff .carts-graph table").first.locator("tbody tr").last
    expect(last.locator("td").first).not_to_have_text("6.000")  # it is filled when it is open
    blown = float(re.findall(r"at ([\d.]+) s", told.inner_text())[0])
    assert float(last.locator("td").first.inner_text()) <= blown + 0.01
    page.emulate_media(media="print")
    plan = page.locator("#stiff .carts-how-plan")
    assert plan.evaluate("(el) => el.scrollHeight <= el.clientHeight + 1")


def choose_exact(page: Page) -> None:
    page.locator("#meeting .carts-how-method").select_option("exact")
    expect(page.locator("#meeting .carts-ghost")).to_have_count(0)
    expect(page.locator("#meeting .carts-how-sign")).to_have_count(0)


@pytest.mark.one_browser
def test_sliders_and_the_step_go_on_working_and_reset_is_exact(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = opened(live(shared_page(widget_site / "meeting.html")))
    exact = on_scene(page, FINAL)
    choose(page, "euler")
    sign = page.locator("#meeting .carts-how-sign")
    expect(sign).to_contain_text("Euler, 103 steps")
    page.locator("#meeting .carts-how-step").press("End")
    expect(sign).to_contain_text("4999 steps", timeout=LIVE)
    on_scene(page, 'await el.set({ "A.mass": 2 })')
    stepped = natively(method="euler", parts=4999, set={"A.mass": 2})
    for got, true in zip(on_scene(page, FINAL), ends(stepped), strict=True):
        assert got == pytest.approx(true, rel=1e-9)
    assert page.locator("#meeting .carts-graph").first.locator(".carts-pale").count() == 2
    page.locator("#meeting .carts-reset").click()
    expect(sign).to_have_count(0)
    for got, true in zip(on_scene(page, FINAL), exact, strict=True):
        assert got == pytest.approx(true, rel=1e-9)  # the baked run has fewer digits
    expect(page.locator("#meeting .carts-how-method")).to_have_value("exact")


@pytest.mark.one_browser
def test_before_the_lock_it_tells_nothing(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "guessed.html"), "guessed")
    page.evaluate(COUNT)
    opened(page, "guessed")
    body = page.locator("#guessed .carts-how-body")
    expect(body).to_have_text(re.compile("^Make your prediction and lock it first"))
    assert page.locator("#guessed .carts-how-method").count() == 0
    assert "how" not in asked(page)
    page.locator("#guessed .carts-options input").first.check()
    page.locator("#guessed .carts-lock").click()
    expect(body).to_have_text(re.compile("^Watch the run to its end first"))
    assert "how" not in asked(page)
    page.locator("#guessed .carts-end").click()
    expect(page.locator("#guessed .carts-how-plan li").first).to_be_visible(timeout=LIVE)
    expect(page.locator("#guessed .carts-how-method")).to_have_value("exact")
