"""A contact without a formula in a page: numpy and scipy come with it, and with it alone."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, Request, expect

from sim.dynamics.loop.run import run
from sim.pages.blocks.bake import bake
from sim.pages.runtime import default_cache, pack
from sim.scene import apply_changes, read_scene
from tests import registry
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import ROOT, bundle
from tests.web.scene.given.widget_site import MEETING, write_page

pytestmark = pytest.mark.browser

BALLS: dict[str, Any] = {"id": "balls", **registry.plain("hertz-pair")}
AGREES = 1e-9
"""m/s. The adaptive method keeps 1e-12 per step; two math libraries choose other steps."""
SLOW = 120_000  # ms; scipy on a loaded machine


@pytest.fixture(scope="session")
def balls_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    site = tmp_path_factory.mktemp("balls") / "site"
    baked = bake(registry.plain("hertz-pair"))
    assert not isinstance(baked, list)
    (site / "assets" / "carts").mkdir(parents=True)
    pack(site, packages=baked.packages, cache=default_cache(ROOT), report=lambda _: None)
    shutil.copy(ROOT / "sim" / "web" / "css" / "carts.css", site / "assets" / "carts")
    bundle(ROOT / "sim" / "web" / "src" / "main.js", site / "assets" / "carts" / "carts.js")
    write_page(site, "balls", BALLS)
    write_page(site, "springs", MEETING)
    return site


def heavy(page: Page) -> list[str]:
    """From now on: the files of numpy and scipy that the page asks for."""
    asked: list[str] = []

    def note(request: Request) -> None:
        if any(name in request.url for name in ("numpy", "scipy", "python-more")):
            asked.append(request.url)

    page.on("request", note)
    return asked


@pytest.mark.one_browser
def test_balls_collide_in_the_page_as_they_do_natively(
    balls_site: Path, open_page: OpenPage
) -> None:
    page = open_page(balls_site / "balls.html")
    expect(page.locator("#balls")).to_have_attribute("data-state", "live", timeout=SLOW)
    there = page.locator("#balls").evaluate(
        """async (el) => {
            await el.set({ "A.velocity": 0.45 });
            return Object.fromEntries(
              Object.entries(el.trajectory.v).map(([name, v]) => [name, v.at(-1)]));
        }""",
        timeout=SLOW,
    )
    here = run(read_scene(apply_changes(registry.plain("hertz-pair"), {"A.velocity": 0.45})))
    for cart, v in zip(here.scene.carts, here.v, strict=True):
        assert there[cart.name] == pytest.approx(v, abs=AGREES)


@pytest.mark.one_browser
def test_a_page_without_balls_asks_for_neither_numpy_nor_scipy(
    balls_site: Path, open_page: OpenPage
) -> None:
    page = open_page(balls_site / "springs.html")
    expect(page.locator("#meeting")).to_have_attribute("data-state", "live", timeout=SLOW)
    asked = heavy(page)
    page.reload()
    expect(page.locator("#meeting")).to_have_attribute("data-state", "live", timeout=SLOW)
    assert asked == []
