"""Sliders, boxes, keys and the element's own functions: what a reader can change."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.widget_site import live, on_scene, widget_site

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture


def test_the_element_keeps_its_promises(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    told = on_scene(
        page,
        """
        await el.ready;
        const heard = [];
        el.addEventListener("carts-update", ({ detail }) => heard.push(detail));
        await el.set({ "A.mass": 2, "contact.restitution": "0.5" });
        const { trajectory, plan } = el;
        const last = trajectory.t.length - 1;
        const out = { heard, v: [trajectory.v.A[last], trajectory.v.B[last]], plan: plan.length };
        out.kinds = [trajectory.t, trajectory.x.A, trajectory.F["A-B"]].map((c) =>
          c instanceof Float64Array);
        out.events = trajectory.events.length;
        el.time = 1.25;
        out.time = el.time;
        out.measures = performance.getEntriesByName("carts:update").length;
        return out;
        """,
    )
    assert told["heard"] == [{"A.mass": 2, "contact.restitution": "0.5"}]
    assert told["kinds"] == [True] * 3
    assert told["plan"] > 1
    assert told["events"] > 3
    assert told["time"] == 1.25
    assert told["measures"] == 1
    assert page.locator("#meeting .carts-clock").inner_text().startswith("1.25")
    # 2 kg at 0.6 m/s meets 1 kg at rest, e = 0.5: 0.3 and 0.6 m/s; then B comes back from the wall
    assert min(told["v"]) < 0.3


def test_a_value_that_makes_no_sense_is_refused_and_the_run_stays(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    told = on_scene(
        page,
        """
        const before = el.trajectory;
        const errors = [];
        for (const changes of [{ "A.mass": -1 }, { "A.mass": "1 s" }, { "Z.mass": 1 },
          { "A.mass": "NaN" }, { "contact.restitution": 2 }]) {
          await el.set(changes).catch((error) => errors.push(error.message));
        }
        const same = el.trajectory === before;
        await el.set({ "A.velocity": 0.7 });
        return { errors, same, after: el.trajectory.v.A[0] };
        """,
    )
    assert len(told["errors"]) == 5
    assert all(told["errors"])
    assert told["same"]
    assert told["after"] == pytest.approx(0.7)


def test_a_slider_and_its_box_are_one(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    control = page.locator('#meeting [data-set="A.mass"]')
    box, slider = control.locator("[type=text]"), control.locator("[type=range]")
    mass = page.locator('#meeting [data-body="A"] [data-quantity="mass"]')
    slider.focus()
    slider.press("ArrowRight")
    expect(mass).to_have_text("0.6")
    expect(box).to_have_value("0.6")
    box.fill("1,5")
    box.press("Enter")
    expect(mass).to_have_text("1.5")
    assert slider.input_value() == "1.5"
    box.fill("750 g")
    box.press("Enter")
    expect(mass).to_have_text("0.75")
    expect(box).to_have_value("0.75")
    box.fill("1.23456")
    box.press("Enter")
    expect(mass).to_have_text("1.23")
    expect(box).to_have_value("1.23456")
    box.blur()
    expect(box).to_have_value("1.23456")
    box.fill("8")  # a value that is being typed is left alone
    on_scene(page, "await el.set({ 'A.velocity': 0.7 })")
    expect(box).to_have_value("8")
    box.press("ControlOrMeta+a")
    box.press_sequentially("1,5 kg")
    box.press("Tab")
    expect(box).to_have_value("1.5")
    page.locator("#meeting .carts-reset").click()
    expect(mass).to_have_text("0.5")
    expect(box).to_have_value("0.5")


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("1,000", "1,000 can mean 1 or 1000"),
        ("one", "not a number"),
        ("99", "mass of A: 0.5 to 4.0 kg"),
        ("1e309", "too large"),
        ("2 s", "kg"),
        ("-1 kg", "greater than 0 kg"),
    ],
)
def test_a_wrong_number_is_explained_beside_its_box(
    open_page: OpenPage, widget_site: Path, typed: str, said: str
) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    control = page.locator('#meeting [data-set="A.mass"]')
    control.locator("[type=text]").fill(typed)
    control.locator("[type=text]").press("Enter")
    error = control.locator(".carts-error")
    expect(error).to_be_visible()
    assert said in error.inner_text()
    expect(page.locator('#meeting [data-body="A"] [data-quantity="mass"]')).to_have_text("0.5")


def test_everything_is_reached_by_keyboard(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    world, clock = page.locator("#meeting .carts-world"), page.locator("#meeting .carts-clock")
    world.focus()
    page.keyboard.press("ArrowRight")
    expect(clock).to_have_text("0.040")
    page.keyboard.press("ArrowLeft")
    expect(clock).to_have_text("0.000")
    page.keyboard.press("End")
    expect(clock).to_have_text("6.000")
    page.keyboard.press("Home")
    page.keyboard.press(" ")
    expect(page.locator("#meeting .carts-play")).to_have_text("Pause")
    page.wait_for_timeout(300)
    page.keyboard.press(" ")
    expect(page.locator("#meeting .carts-play")).to_have_text("Play")
    assert on_scene(page, "return el.time") > 0.1
    reached = set()
    for _ in range(30):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("document.activeElement.className.split(' ').at(-1)"))
    assert {"carts-scrub", "carts-play", "carts-speed", "carts-slow", "carts-slider"} <= reached
    assert {"carts-number-box", "carts-reset", "carts-window", "carts-sign"} <= reached


def test_a_table_is_filled_when_it_is_opened(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    on_scene(page, "await el.set({ 'A.velocity': 1 })")
    table = page.locator('#meeting [data-quantity="v"] details')
    table.locator("summary").click()
    expect(table.locator("tbody tr").first.locator("td").nth(1)).to_have_text("1.00")
