"""One page “Class results” for all of these tests, made anew for each."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from sim.pages.classroom.practice_keys import keys_script
from sim.pages.runtime import CLASSROOM, default_cache, pack
from tests.classroom.given.everything import Blanked
from tests.web.classroom.class_site import PAGE
from tests.web.conftest import SharePage
from tests.web.runtime.boot_site import ROOT, bundle


@pytest.fixture(scope="session")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    site = tmp_path_factory.mktemp("class")
    assets = site / "assets" / "carts"
    assets.mkdir(parents=True)
    packages = frozenset({"numpy", "scipy", CLASSROOM})
    pack(site, packages=packages, cache=default_cache(ROOT), report=lambda _: None)
    web = ROOT / "sim" / "web"
    sheets = [web / "css" / "carts.css", web / "css" / "class.css"]
    sheets.append(ROOT / "sim" / "classroom" / "show" / "report.css")
    sheets.append(ROOT / "sim" / "classroom" / "handouts" / "paper.css")
    (assets / "class-keys.js").write_bytes(keys_script([]))
    (assets / "carts.css").write_bytes(b"\n".join(sheet.read_bytes() for sheet in sheets))
    bundle(web / "src" / "class-main.js", assets / "class.js")
    (site / "class.html").write_text(PAGE, encoding="utf-8")
    blanked = json.dumps(Blanked())
    (assets / "blanked.js").write_text(
        f"globalThis.cartsWords = {blanked};\n"
        f'globalThis.__cartsPapers = {{"ms": {{"name": "·", "words": {blanked}}}}};\n',
        encoding="utf-8",
    )
    (site / "blanked.html").write_text(
        PAGE.replace('lang="en"', 'lang="ms"').replace("class-keys.js", "blanked.js"),
        encoding="utf-8",
    )
    return site / "class.html"


@pytest.fixture
def page(place: Path, shared_page: SharePage) -> Page:
    opened = shared_page(place)
    expect(opened.locator("carts-class[data-state=ready]")).to_have_count(1)
    return opened
