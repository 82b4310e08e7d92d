"""Views beside the picture: forces on each cart, lens, momentum, ledger; chosen by the reader."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.scene.given.third_site import third
from tests.web.scene.given.widget_site import MEETING, live, on_scene, widget_site, write_page

pytestmark = pytest.mark.browser

__all__ = ["third", "widget_site"]  # fixtures


def number(page: Page, body: str, quantity: str) -> float:
    cell = page.locator(f'#third .carts-pairs td[data-body="{body}"][data-quantity="{quantity}"]')
    return float(cell.inner_text().replace("−", "-"))


@pytest.mark.one_browser
def test_forces_are_equal_and_what_they_do_is_not(third: Page) -> None:
    assert number(third, "A", "F") == -number(third, "B", "F") < 0
    for quantity in ("a", "dv"):  # masses are 0.5 kg and 1 kg
        assert number(third, "A", quantity) == pytest.approx(
            -2 * number(third, "B", quantity), abs=0.16
        )
    names = third.locator('#third .carts-alone[data-body="A"] li')
    expect(names).to_have_text([re.compile(r"^force on A by B: 6.9.N to the left$")])
    third.locator("#third .carts-vertical").check()
    expect(names).to_have_count(3)
    expect(names.nth(1)).to_have_text(re.compile("on A by the Earth: 4.9.N down"))
    boxes = third.locator("#third .carts-alone svg")
    assert len({boxes.nth(i).get_attribute("viewBox") for i in range(2)}) == 1  # one scale


@pytest.mark.one_browser
def test_the_lens_is_ten_times_the_picture(third: Page) -> None:
    wide, bar = on_scene(
        third,
        """const box = el.querySelector('.carts-stage-wide .carts-cart [data-part="box"]');
        const width = (part) => part.getBBox().width * part.getScreenCTM().a;
        const metre = width(box) / 0.12;
        const shown = width(el.querySelector('.carts-lens [data-part="bar"]'));
        const text = el.querySelector('.carts-lens [data-part="bar-text"]').textContent;
        const length = parseFloat(text) * (text.endsWith("mm") ? 0.001 : 0.01);
        return [metre, shown / length];""",
        name="third",
    )
    assert bar == pytest.approx(10 * wide, rel=0.01)
    expect(third.locator("#third .carts-lens-note")).to_contain_text("squeezed by 17.")


@pytest.mark.one_browser
def test_the_reader_chooses_graphs_and_views(third: Page) -> None:
    scene = third.locator("#third")
    scene.locator(".carts-choose summary").click()
    for quantity in ("p", "energy"):
        scene.locator(f'[data-choice="{quantity}"]').check()
        expect(scene.locator(f'.carts-graph[data-quantity="{quantity}"] .carts-curve').first)\
            .to_be_attached()  # fmt: skip
    scene.locator('[data-choice="F"]').uncheck()
    expect(scene.locator('.carts-graph[data-quantity="F"]')).to_have_count(0)
    scene.locator('[data-choice="lens"]').uncheck()
    expect(scene.locator(".carts-lens")).to_be_hidden()
    scene.locator(".carts-stack").click()
    bands = scene.locator('.carts-graph[data-quantity="energy"] .carts-key span')
    expect(bands).to_have_count(4)
    joules = [float(text.split(": ")[1].removesuffix(" J")) for text in bands.all_inner_texts()]
    assert sum(joules) == pytest.approx(0.09, abs=0.002)  # 0.5 kg at 0.6 m/s
    ids = on_scene(third, "return [...document.querySelectorAll('[id]')].map((e) => e.id)",
                   name="third")  # fmt: skip
    assert len(ids) == len(set(ids))


@pytest.mark.one_browser
def test_the_impulse_is_shaded_and_told(third: Page) -> None:
    note = third.locator("#third .carts-area-note")
    expect(note).to_contain_text(re.compile(r"A–B, shaded area so far: 0\.\d+"))
    on_scene(third, "el.time = 2;", name="third")
    expect(note).to_contain_text("shaded area: 0.360; m Δv of A: −0.360; m Δv of B: 0.360")


@pytest.mark.one_browser
def test_before_and_now_of_momentum_add_up(third: Page) -> None:
    on_scene(third, "el.time = 5;", name="third")  # after the wall
    rows = third.locator('#third [data-view="bars"] tbody tr')
    expect(rows).to_have_count(4)
    now = [
        float(rows.nth(i).locator('[data-when="now"]').inner_text().replace("−", "-"))
        for i in range(4)
    ]
    assert sum(now[:3]) == pytest.approx(now[3], abs=0.011)
    assert now[3] == pytest.approx(0.30, abs=0.001)


@pytest.mark.one_browser
def test_playing_stops_at_touch_greatest_force_and_parting(third: Page) -> None:
    scene = third.locator("#third")
    scene.locator(".carts-choose summary").click()
    scene.locator('[data-choice="stops"]').check()
    scene.locator(".carts-speed").select_option("10")
    scene.locator(".carts-slow").uncheck()
    on_scene(third, "el.time = 0;", name="third")
    events = on_scene(third, "return el.trajectory.events.slice(0, 3).map((e) => e.t)",
                      name="third")  # fmt: skip
    for t in events:
        scene.locator(".carts-play").click()
        expect(scene.locator(".carts-play")).to_have_text("Play")  # it has stopped by itself
        assert on_scene(third, "return el.time", name="third") == t


@pytest.mark.one_browser
def test_boxes_are_as_large_as_the_masses_or_all_alike(
    open_page: OpenPage, widget_site: Path
) -> None:
    alike = {**MEETING, "id": "alike", "boxes": "alike"}
    page = live(open_page(write_page(widget_site, "alike", MEETING, alike)))
    heights = """(id) => [...document.querySelectorAll(`#${id} .carts-stage:not([hidden])`)]
        .filter((stage) => stage.getBoundingClientRect().height > 0)
        .flatMap((stage) => [...stage.querySelectorAll('[data-part="box"]')])
        .map((box) => Number(box.getAttribute("height")))"""
    a, b = page.evaluate(heights, "meeting")
    assert b == pytest.approx(2 * a)
    a, b = page.evaluate(heights, "alike")
    assert a == b > 0
    for name, says in (("meeting", "alike"), ("alike", "mass")):
        page.locator(f"#{name} .carts-choose summary").click()
        page.locator(f'#{name} [data-choice="areas"]').click()
        a, b = page.evaluate(heights, name)
        assert (b == pytest.approx(2 * a)) == (says == "mass")


ROUGH: dict[str, Any] = {
    **MEETING,
    "id": "rough",
    "effects": [
        {"friction": {"coefficient": "0.01"}},
        {"push": {"cart": "A", "force": "0.2 N", "until": "1 s"}},
    ],
    "show": ["energy"],
}


@pytest.mark.one_browser
def test_the_ledger_with_effects_adds_up_to_what_was_there_and_what_was_given(
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(write_page(widget_site, "rough", ROUGH)), "rough")
    graph = page.locator('#rough .carts-graph[data-quantity="energy"]')
    key = graph.locator(".carts-key")
    name = graph.locator(".carts-graph-name")
    expect(name).to_contain_text("Kinetic energy")
    graph.locator(".carts-sign").click()
    expect(key).to_contain_text("has warmed the bumpers and track")
    expect(name).to_have_text("Energy E in J")
    parts = """(key) => [...key.querySelectorAll("b")].map((b) => [b.textContent.split(": ")[0],
        parseFloat(b.textContent.split(": ")[1].replace("−", "-"))])"""
    on_scene(page, "el.time = 0;", name="rough")
    start = sum(value for _, value in key.evaluate(parts))
    on_scene(page, "el.time = 3;", name="rough")
    now = dict(key.evaluate(parts))
    x = on_scene(
        page,
        """const { t, x } = el.trajectory; const k = [...t].indexOf(1);
        return k < 0 ? null : x.A[k] - x.A[0];""",
        name="rough",
    )
    assert x is not None
    assert sum(now.values()) == pytest.approx(start + 0.2 * x, abs=0.005)
    assert now["has warmed the bumpers and track"] > 0
    assert list(now) == [
        "motion of A", "motion of B", "in squeezed bumpers", "has warmed the bumpers and track"
    ]  # fmt: skip
    on_scene(page, "await el.set({ 'A.mass': 2 }); el.time = 0;", name="rough")
    expect(key).to_contain_text("motion of A: 0.36")
