"""“What accuracy costs” in the page: another method, a measurement that fills, and stopping it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

from sim.bridge.protocol import answer
from sim.dynamics.cost.breaks import MAPS, parts, scene_at
from tests import registry
from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import LIVE

LOADED = 90_000
"""ms. numpy and scipy on a machine that others use too, and the first rows."""


@pytest.mark.one_browser
@pytest.mark.browser
@pytest.mark.slow
def test_methods_run_and_are_measured_in_the_readers_browser(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "accuracy" / "index.html", folder=site)
    cost = page.locator("#cost-two-runs")
    expect(cost.locator(".carts-cost-told")).to_contain_text("145.4 %")  # without Python
    # The figure waits for a guess, or for a reader who wants none.
    expect(cost.locator(".carts-cost-figure")).to_be_hidden()
    cost.locator(".carts-cost-show").click()
    expect(cost.locator(".carts-cost-verdict")).to_contain_text("Choose a method first")
    expect(cost.locator(".carts-cost-figure")).to_be_hidden()
    cost.locator(".carts-cost-bet").select_option("euler")
    cost.locator(".carts-cost-times").fill("50")
    cost.locator(".carts-cost-show").click()
    expect(cost.locator(".carts-cost-figure")).to_be_visible()
    verdict = cost.locator(".carts-cost-verdict")
    expect(verdict).to_contain_text("For 10⁻⁶ m/s: adaptive DOP853 + located touches")
    expect(verdict).to_contain_text("Euler, does not get there")
    expect(verdict).to_contain_text("You said 50 times.")
    assert cost.locator("[data-of=rk4-events]").text_content() == "one more digit: × 1.6"
    baked = cost.locator(".carts-cost-figure [transform].carts-cost-point").count()
    cost.locator(".carts-cost-method").select_option("semi-implicit")
    expect(cost).to_have_attribute("data-state", "live", timeout=LIVE)
    # Both runs are those that are computed here.
    request = {"id": 1, "kind": "cost", "scene": registry.plain("paper-two-carts")}
    header, numbers = answer(request | {"method": "semi-implicit", "parts": 103})
    seen = cost.evaluate("(el) => ({v: el.run.header.v, numbers: [...el.run.numbers]})")
    assert seen["v"]["exact"] == header["v"]["exact"]
    assert seen["numbers"] == pytest.approx(list(numbers), abs=1e-12)
    # A point of the map says what came out there, and runs above as it does anywhere.
    cost.locator(".carts-breaks-method").select_option("rk4")
    cost.locator(".carts-breaks-map").select_option("1")
    cost.locator(".carts-breaks-value").select_option("0")
    cost.locator(".carts-breaks-step").select_option("20")
    expect(cost.locator(".carts-breaks-found")).to_contain_text("energy was made")
    cost.locator(".carts-breaks-run").click()
    one, count = MAPS[1], parts()[20]
    point = {"kind": "cost", "scene": scene_at(one, one.values()[0]), "method": "rk4"}
    made = answer(request | point | {"parts": count})[0]["energy"]["stepped"]
    page.wait_for_function(
        "(made) => document.getElementById('cost-two-runs').run.header.energy.stepped === made",
        arg=made,
    )
    told = cost.locator(".carts-breaks-command").text_content() or ""
    assert json.loads(told.split("'")[1]) == point["scene"]
    assert told.endswith(f"--method rk4 --step {1 / count}")
    # A measurement shows row after row; stopped, it keeps them.
    cost.locator(".carts-cost-go").click()
    said = cost.locator(".carts-cost-say")
    expect(said).to_have_text(re.compile(r"^([3-9]|\d\d) of \d+ runs measured$"), timeout=LOADED)
    cost.locator(".carts-cost-stop").click()
    expect(cost.locator(".carts-cost-go")).to_be_visible()
    expect(said).to_contain_text("Stopped after")
    assert cost.locator(".carts-cost-figure [transform].carts-cost-point").count() < baked
    first, _, euler, *_ = cost.evaluate("(el) => el.rows")
    assert (first["method"], first["time_ratio"], euler["evaluations"]) == ("exact", 1, 103)
    assert first["error_v"] <= 4e-16


@pytest.mark.one_browser
@pytest.mark.browser
def test_the_table_of_another_scene_has_its_own_steps(site: Path, open_page: OpenPage) -> None:
    """What was measured beforehand, also before Python has run the scene that was chosen."""
    page = open_page(site / "accuracy" / "index.html", folder=site)
    cost = page.locator("#cost-two-runs")
    rows = cost.locator(".carts-cost-table tbody tr")
    assert any("1 s / 103" in text for text in rows.all_text_contents())
    cost.locator(".carts-cost-bet").select_option("euler")
    cost.locator(".carts-cost-times").fill("2,000")
    cost.locator(".carts-cost-show").click()
    expect(cost.locator(".carts-cost-guess .carts-error")).to_contain_text("2 or 2000")
    expect(cost.locator(".carts-cost-times")).to_be_focused()
    cost.locator(".carts-cost-times").fill("2000")
    cost.locator(".carts-cost-show").click()
    expect(cost.locator(".carts-cost-verdict")).to_contain_text("You said 2000 times.")
    cost.locator(".carts-cost-scene").select_option("spring-pair")
    expect(cost.locator(".carts-cost-verdict")).to_be_empty()  # it was of the other scene
    texts = rows.all_text_contents()
    assert any("6 s / 103" in text for text in texts)
    assert not any("1 s / " in text for text in texts)
    page.reload()  # a browser that keeps what was chosen would name a scene that is not drawn
    expect(cost.locator(".carts-cost-scene")).to_have_value("paper-two-carts")
    assert not page.locator("select:not([autocomplete=off])").count()
