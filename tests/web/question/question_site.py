"""Pages with questions and forms as the generator makes them, with the script from its source."""

from __future__ import annotations

import html
import json
import shutil
from pathlib import Path

import pytest
from markdown import Markdown
from playwright.sync_api import Page

from sim.pages.blocks.extension import CartsExtension, set_page
from sim.pages.blocks.extension import Page as MadePage
from sim.pages.blocks.scene_block import Lesson
from tests.web.runtime.boot_site import ROOT, STRICT, bundle

SITE_ID = "question-tests"
PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{csp}">
<meta name="carts-site" content="{site_id}">
<meta name="carts-page" content="worksheets/{name}">
<title>Questions</title><link rel="icon" href="data:,">
<link rel="stylesheet" href="assets/carts/carts.css">
<link rel="stylesheet" href="assets/carts/questions.css"></head>
<body><main>{body}</main>
<script type="application/json" id="carts-lesson">{outline}</script>
{scenes}<script src="assets/carts/answers.js"></script></body></html>
"""
SCENES = '<script src="assets/carts/carts.js"></script>\n'


def questions_page(name: str, text: str, banks: Path | None = None) -> tuple[str, MadePage]:
    """The page of a lesson: its HTML, and what the generator noted about it."""
    made = MadePage(Lesson(f"{name}.md", (), (banks,) if banks else ()))
    md = Markdown(
        extensions=[CartsExtension(), "tables", "pymdownx.arithmatex"],
        extension_configs={"pymdownx.arithmatex": {"generic": True}},
    )
    set_page(made)
    try:
        body = md.convert(text)
    finally:
        set_page(None)
    outline = json.dumps(made.items.outline(name)).replace("<", "\\u003c")
    page = PAGE.format(
        csp=html.escape(STRICT),
        site_id=SITE_ID,
        name=name,
        body=body,
        outline=outline,
        scenes=SCENES if made.scenes else "",
    )
    return page, made


def write_page(site: Path, name: str, text: str, banks: Path | None = None) -> Path:
    path = site / f"{name}.html"
    path.write_text(questions_page(name, text, banks)[0], encoding="utf-8")
    return path


def prepare(site: Path) -> Path:
    """A folder with the scripts and styles, without the runtime: pages of questions need none."""
    assets = site / "assets" / "carts"
    assets.mkdir(parents=True)
    for sheet in ("carts.css", "questions.css"):
        shutil.copy(ROOT / "sim" / "web" / "css" / sheet, assets)
    for entry, out in (("answers-main.js", "answers.js"), ("main.js", "carts.js")):
        bundle(ROOT / "sim" / "web" / "src" / entry, assets / out)
    return site


ALL_KINDS = (Path(__file__).parent / "all_kinds.md").read_text(encoding="utf-8")
BANK = Path(__file__).parent / "banks"


_built: list[Path] = []


@pytest.fixture(scope="session")
def question_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy for every file of tests that imports this; built once by every worker."""
    if not _built:
        site = prepare(tmp_path_factory.mktemp("questions-built") / "site")
        write_page(site, "kinds", ALL_KINDS)
        write_page(site, "test", (BANK / "test.md").read_text(encoding="utf-8"), BANK)
        _built.append(site)
    return shutil.copytree(_built[0], tmp_path_factory.mktemp("questions") / "site")


def ready(page: Page) -> Page:
    """Wait until earlier answers are back."""
    page.locator(".carts-bar[data-ready]").wait_for()
    return page
