"""Maps in the page: a picture until opened, then numpy, the same values, keyboard and pointer."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from sim.bridge.protocol import answer
from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import LIVE


def facts(site: Path, name: str) -> dict[str, Any]:
    text = (site / "physics" / "map.html").read_text(encoding="utf-8")
    element = re.search(rf'<carts-map[^>]* id="{name}".*?</carts-map>', text, re.DOTALL)
    assert element is not None
    found = re.search(r'carts-map-baked">(.*?)</script>', element[0])
    assert found is not None
    return dict(json.loads(found[1]))


def asked(page: Page) -> list[str]:
    names: list[str] = []
    page.on("request", lambda request: names.append(request.url.rpartition("/")[2]))
    return names


def opened(page: Page, name: str) -> None:
    page.locator(f"#{name} .carts-map-open").click()
    page.wait_for_selector(f'#{name}[data-state="live"]', timeout=LIVE)


# A file that did not come is asked for thrice again, after seven seconds in all.
AT_ONCE = """const later = setTimeout;
  window.setTimeout = (does, ms, ...more) =>
    later(does, [1000, 2000, 4000].includes(ms) ? ms / 20 : ms, ...more);"""


def on_map(page: Page, script: str, name: str = "map-velocity") -> Any:
    return page.locator(f"#{name}").evaluate(f"async (el) => {{ {script} }}")


@pytest.mark.one_browser
@pytest.mark.browser
@pytest.mark.slow
def test_numpy_comes_when_a_map_is_opened_and_not_before(
    site: Path, open_page: OpenPage, site_server: Callable[[Path], str]
) -> None:
    address = site_server(site)  # from a server: of a disk, Firefox tells no requests
    page = open_page(f"{address}/index.html")
    names = asked(page)
    page.goto(f"{address}/physics/map.html")
    page.wait_for_selector('#map-scene[data-state="live"]', timeout=LIVE)
    assert any(name.startswith("python.zip") for name in names)
    assert not [name for name in names if name.startswith(("numpy", "python-more"))]
    opened(page, "map-velocity")
    assert [name for name in names if name.startswith("numpy")]
    expect(page.locator("#map-scene")).to_have_attribute("data-state", "live")
    before = len(names)
    opened(page, "map-energy")  # the second map finds numpy there
    assert len(names) == before


@pytest.mark.one_browser
@pytest.mark.browser
@pytest.mark.slow
def test_a_map_whose_numpy_did_not_come_is_opened_once_more(
    site: Path, open_page: OpenPage, site_server: Callable[[Path], str]
) -> None:
    address = site_server(site)
    page = open_page(f"{address}/404.html")
    page.add_init_script(AT_ONCE)
    page.goto(f"{address}/physics/map.html")
    page.wait_for_selector('#map-scene[data-state="live"]', timeout=LIVE)
    page.route("**/numpy*", lambda route: route.abort())
    one = page.locator("#map-velocity")
    one.locator(".carts-map-open").click()
    page.wait_for_selector('#map-velocity[data-state="failed"]', timeout=60_000)
    expect(one.locator(".carts-note")).to_contain_text("stay as they were prepared")
    page.unroute("**/numpy*")
    opened(page, "map-velocity")
    expect(one.locator(".carts-note")).to_be_hidden()


@pytest.mark.one_browser
@pytest.mark.browser
@pytest.mark.slow
def test_a_map_shows_and_runs_the_values_of_its_points(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "physics" / "map.html", folder=site)
    opened(page, "map-velocity")
    # Every value is that of the same map computed here.
    header, values = answer({"id": 1, "kind": "map", "map": facts(site, "map-velocity")["map"]})
    seen = on_map(page, "return {values: [...el.grid.values], axes: el.grid.axes}")
    assert seen["axes"] == header["axes"]
    assert all(math.isclose(a, b, rel_tol=1e-13, abs_tol=1e-15)
               for a, b in zip(seen["values"], values, strict=True))  # fmt: skip
    # Keyboard: one step of mass; the slider says the value.
    slider = page.locator('#map-velocity [data-set="A.mass"] .carts-slider')
    slider.focus()
    slider.press("ArrowRight")
    box = page.locator('#map-velocity [data-set="A.mass"] .carts-number-box')
    expect(box).to_have_value("1.025")
    text = page.locator("#map-velocity .carts-map-number").text_content() or ""
    assert (slider.get_attribute("aria-valuetext") or "") == f"1.025 kg: {text}"
    box.fill("4.2")  # an answer that comes meanwhile takes nothing from what is being typed
    on_map(page, 'await el.set({"B.mass": 2})')
    expect(box).to_have_value("4.2")
    on_map(page, 'await el.set({"B.mass": 1})')
    # A number box takes the nearest point, and says what is wrong.
    box.fill("2.004")
    box.press("Enter")
    expect(box).to_have_value("2.000")
    box.fill("9")
    box.press("Enter")
    error = page.locator('#map-velocity [data-set="A.mass"] .carts-error')
    expect(error).to_have_text("mass of A: 0.500 to 5.000 kg, please.")
    # Pointer: the upper right corner is the heaviest cart and e = 1.
    figure = page.locator("#map-velocity .carts-map-over")
    size = figure.bounding_box()
    assert size is not None
    figure.click(position={"x": 0.98 * size["width"], "y": 0.02 * size["height"]})
    assert on_map(page, "return el.point") == {"A.mass": 5, "contact.restitution": 1}
    # The point runs in the scene above, with the value that the map told.
    page.locator("#map-velocity .carts-map-run").click()
    scene = page.locator("#map-scene")
    expect(scene.locator(".carts-play")).to_be_focused()
    after = scene.evaluate("(el) => el.trajectory.v.A.at(-1)")
    assert math.isclose(after, on_map(page, "return el.value"), rel_tol=1e-13)
    # All points: another mass of B is another map, and a bad one is refused.
    on_map(page, 'await el.set({"B.mass": 5})')
    assert math.isclose(on_map(page, "return el.value"), 0.0, abs_tol=1e-15)
    expect(page.locator('#map-velocity [data-set="B.mass"] .carts-number-box')).to_have_value("5.0")
    refused = on_map(page, 'return el.set({"B.mass": -1}).then(() => "", (e) => e.message)')
    assert "greater than 0" in refused


@pytest.mark.one_browser
@pytest.mark.browser
@pytest.mark.slow
def test_a_map_of_runs_fills_while_the_reader_watches(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "physics" / "map.html", folder=site)
    opened(page, "map-middle")
    seen = on_map(page, "await el.complete; return [...el.grid.values]", "map-middle")
    best = max(range(len(seen)), key=seen.__getitem__)
    masses = on_map(page, "return el.grid.axes[0]", "map-middle")
    assert masses[best] == 2.0  # the geometric mean of 4 kg and 1 kg
    # A slider that moves on drops the runs that are under way.
    late = on_map(
        page,
        'el.set({"A.mass": 3}); await el.set({"A.mass": 9}); await el.complete;'
        "return [...el.grid.values]",
        "map-middle",
    )
    assert masses[max(range(len(late)), key=late.__getitem__)] == 3.0
    assert not any(map(math.isnan, late))
