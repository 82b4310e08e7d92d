"""A seeded reader who does anything, quickly: nothing throws, and the scene still answers."""

from __future__ import annotations

import os
import random
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import MEETING, live, on_scene, widget_site, write_page

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture

STEPS = {"chromium": 60, "firefox": 25}
"""In CI, from each of two seeds (in Firefox from one): two short ways lead to more than a long one.
`make fuzz` takes new seeds, and goes farther."""
NONSENSE = ["", "abc", "1e309", "-1e309", "NaN", "١٢٣", "1,000", "0x10", "9" * 2000, "１",
            "2 furlong", "<b>1</b>", "−0,5", "1.5 kg", "3 km/h", "💥", "1e-300"]  # fmt: skip

# What a reader can do, chosen and valued by the numbers of the test's own generator.
ACT = """
  const [kind, which, part, text] = argument;
  const pick = (selector) => {
    const all = [...el.querySelectorAll(selector)].filter((one) => !one.disabled);
    return all[Math.floor(which * all.length)];
  };
  const send = (one, type) => one.dispatchEvent(new Event(type, { bubbles: true }));
  if (kind === "slide") {
    const slider = pick("input[type=range]");
    if (slider) {
      slider.valueAsNumber = Number(slider.min) + part * (Number(slider.max) - Number(slider.min));
      send(slider, "input");
    }
  } else if (kind === "type") {
    const box = pick(".carts-number-box");
    if (box) { box.value = text; send(box, "input"); send(box, "change"); }
  } else if (kind === "press") {
    pick(`button:not([data-take], .carts-project)`)?.click();
  } else if (kind === "tick") {
    const box = pick("input[type=checkbox]");
    if (box) { box.checked = part > 0.5; send(box, "change"); }
  } else if (kind === "choose") {
    const list = pick("select");
    if (list) { list.selectedIndex = Math.floor(part * list.options.length); send(list, "change"); }
  } else if (kind === "key") {
    const keys = [" ", "ArrowLeft", "ArrowRight", "PageUp", "PageDown", "Home", "End"];
    el.querySelector(".carts-world").dispatchEvent(
      new KeyboardEvent("keydown", { key: keys[Math.floor(part * keys.length)], bubbles: true }));
  } else if (kind === "set") {
    await el.set({ [["A.mass", "B.velocity", "nothing.at"][Math.floor(which * 3)]]:
      part > 0.5 ? text : 10 ** (8 * part - 4) }).catch(() => {});
  } else el.time = (part * 4 - 1) * 10 ** (which * 3);
"""
KINDS = ["slide", "type", "press", "tick", "choose", "key", "set", "time"]


@pytest.mark.parametrize("reader", [0, pytest.param(1, marks=pytest.mark.one_browser)])
def test_a_reader_who_does_anything_breaks_nothing(
    reader: int,
    browser_name: str,
    open_page: OpenPage,
    widget_site: Path,
    request: pytest.FixtureRequest,
) -> None:
    fuzz = bool(request.config.getoption("--fuzz"))
    seed = int.from_bytes(os.urandom(4)) if fuzz else int(os.environ.get("SEED", "5")) + reader
    chance = random.Random(seed)
    print("seed", seed)  # pytest shows it with a failure
    scene = {
        **MEETING,
        "id": "any",
        "show": ["x", "v", "a", "F", "p", "energy"],
        "with": ["free-body", "lens", "bars"],
        "presets": {"heavy hits light": {"A.mass": "4 kg"}},
    }
    page = live(open_page(write_page(widget_site, "any", scene)), "any")
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda m: errors.append(m.text) if m.type == "error" else None)
    for _ in range(STEPS[browser_name] * (20 if fuzz or "SEED" in os.environ else 1)):
        act = [chance.choice(KINDS), chance.random(), chance.random(), chance.choice(NONSENSE)]
        on_scene(page, ACT, act, name="any")
        assert errors == [], f"seed {seed}, after {act}"
    on_scene(page, "el.querySelector('.carts-reset').click(); await el.set({ 'A.mass': 2 });",
             name="any")  # fmt: skip
    expect(page.locator("#any")).to_have_attribute("data-state", "live")
    box = page.locator('#any [data-set="A.mass"] .carts-number-box')
    expect(box).to_have_value("2.0")
    bad = on_scene(
        page, "return /NaN|undefined|Infinity/.exec(el.outerHTML)?.[0] ?? ''", name="any"
    )
    assert bad == "", f"seed {seed}"
