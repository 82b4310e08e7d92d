"""Teacher mode in browsers: open, change, see it, save; nothing changed is nothing lost."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import BrowserContext, Page, Playwright, expect

from sim.pages.runtime import TEACHER
from sim.pages.teach.withheld import withhold
from tests.teach.at_work import LESSON, WAIT, open_teacher, saved, settled
from tests.web.conftest import OpenPage, running
from tests.web.runtime.boot_site import build_site, write_page

pytestmark = [pytest.mark.browser, pytest.mark.slow]

ROOT = Path(__file__).parents[2]
NewPage = Callable[..., Page]
GOLDEN = ROOT / "tests" / "golden" / "author-errors"


def source(name: str = LESSON) -> str:
    return (ROOT / "worksheets" / f"{name}.md").read_bytes().decode()


def field(page: Page, label: str) -> Any:
    return page.locator(".carts-teach-piece[open]").get_by_label(label, exact=True).first


def test_a_teacher_changes_a_scene_and_sees_it_and_takes_it_home(
    lessons: Path, open_page: OpenPage, browser_name: str
) -> None:
    page = open_teacher(open_page, lessons)
    complaints: list[str] = []
    page.on("console", lambda m: complaints.append(m.text) if m.type == "error" else None)
    untouched = page.locator("carts-scene").nth(1)
    untouched.evaluate("element => { element.dataset.same = 'yes'; }")
    assert saved(page).decode() == withhold(source())

    page.get_by_role("button", name="Change this scene").first.click()
    field(page, "mass").fill("0.8 kg")
    settled(page)
    assert saved(page).decode() == withhold(source()).replace("mass: 0.5 kg", "mass: 0.8 kg", 1)
    expect(page.locator("#second-steady svg").first).to_contain_text("0.8 kg")
    expect(page.locator("#second-steady")).to_have_attribute("data-state", "live", timeout=WAIT)
    assert untouched.get_attribute("data-same") == "yes"  # the others were not made anew

    field(page, "mass").fill("-1 kg")
    settled(page)
    line = source()[: source().index("mass: 0.5 kg")].count("\n") + 1
    mistake = page.locator(".carts-teach-mistakes li:visible")
    expect(mistake).to_contain_text("mass must be greater than 0")
    expect(mistake).to_contain_text("Cart A, mass: mass")  # by the name of its field
    page.click(".carts-teach-save")
    status = page.locator(".carts-teach-status")
    expect(status).to_contain_text("There are mistakes in it")
    expect(status).to_be_in_viewport(ratio=1)  # with its piece scrolled to the top
    expect(page.locator(".carts-teach-piece[open] > summary")).to_be_in_viewport(ratio=0.95)
    assert re.fullmatch(rf".*:{line}:\d+", mistake.get_attribute("data-place") or "")
    at_its_field = page.locator(".carts-teach-note:visible")
    expect(at_its_field.filter(has_text="mass must be greater than 0")).to_have_count(1)
    expect(field(page, "mass")).to_have_attribute("aria-invalid", "true")

    while page.locator(".carts-teach-undo").is_enabled():  # what is typed in one go is one step
        page.click(".carts-teach-undo")
    settled(page)
    assert saved(page).decode() == withhold(source())
    expect(page.locator("#second-steady svg").first).to_contain_text("0.5 kg")
    expect(page.locator(".carts-teach-status")).not_to_contain_text("mistake")
    assert complaints == []


def test_text_between_and_questions_follow_too_and_a_draft_survives(
    lessons: Path, browser_name: str, open_page: OpenPage
) -> None:
    if browser_name == "firefox":
        pytest.skip("the store is tested with the answers; the panel in the test before")
    page = open_teacher(open_page, lessons)
    waits = page.locator("carts-after[data-after]").count()
    assert waits
    waiting = page.locator(".carts-q[data-after]:not([data-opened])").first
    expect(waiting.locator(".carts-q-ask")).to_be_visible()  # as what it is changed into
    page.get_by_role("button", name="Change this question").first.click()
    field(page, "Question").fill("Who, *then*, is: right?")
    settled(page)
    expect(page.locator("#second-first-idea em").first).to_have_text("then")
    first = page.locator(".carts-teach-piece").filter(has_text="Text Newton's second law").first
    first.locator("summary").click()
    area = first.get_by_label("Text in Markdown")
    area.fill(area.input_value().replace("# Newton's second law", "# A law, \\(a = b\\)", 1))
    settled(page)
    expect(page.locator("article h1 .katex")).to_have_count(1)
    expect(page.locator("article h1 + .carts-languages")).to_have_count(1)
    expect(page.locator("carts-after[data-after]:not([data-opened])")).to_have_count(waits)
    expect(page.locator(".carts-teach-missing")).to_have_count(0)
    changed = saved(page)
    expect(page.locator(".carts-teach-state")).to_have_text("Draft kept in this browser.")

    page.reload()
    page.wait_for_selector(".carts-teach[data-state=ready]", timeout=WAIT)  # by its #teacher
    expect(page.locator(".carts-teach-status")).to_contain_text("is back")
    assert saved(page) == changed
    page.get_by_role("button", name="Back to the published lesson").click()
    page.get_by_role("button", name="Yes, go back").click()
    settled(page)
    assert saved(page).decode() == withhold(source())
    expect(page.locator("article h1")).to_contain_text("Newton's second law")
    expect(page.locator("article h1 .headerlink")).to_have_count(1)  # it is the built one
    expect(page.locator("article h1 + .carts-languages")).to_have_count(1)


@pytest.fixture
def chromium(driver: Playwright) -> Iterator[NewPage]:
    """A new page of Chromium, where Firefox sees nothing else; it leaves with its test."""
    contexts: list[BrowserContext] = []

    def new_page(**more: Any) -> Page:
        contexts.append(running(driver, "chromium", briefly=False).new_context(**more))
        return contexts[-1].new_page()

    yield new_page
    for made in contexts:
        made.close()


def test_a_lesson_of_each_kind_is_saved_as_it_is_on_disk_with_the_teachers_own_file(
    lessons: Path, chromium: NewPage
) -> None:
    """With notes for teachers, with nothing withheld, an exam; for all see `test_round_trip.py`."""
    page = chromium()
    for name in (LESSON, "return-week-1", "test-forces-and-motion"):
        path = ROOT / "worksheets" / f"{name}.md"
        page.goto((lessons / "worksheets" / f"{path.stem}.html").as_uri() + "?teacher")
        page.wait_for_selector(".carts-teach:is([data-state=ready], [data-state=asks])")
        asks = page.get_attribute(".carts-teach", "data-state") == "asks"
        text = path.read_text(encoding="utf-8")
        assert asks == ("mode: exam" in text)
        if asks or withhold(text) != text:
            page.set_input_files(".carts-teach-own input", path)
        page.wait_for_selector(".carts-teach:not(:has(.carts-teach-own))")
        settled(page)
        assert saved(page) == path.read_bytes()


FEW = ("map-with-mistakes", "measured-with-mistakes", "quiz-with-mistakes", "many-at-once",
       "scene-file-with-a-mistake")  # fmt: skip
"""What a page has other tools for: files, readings, banks. `test_preview.py` walks all of them with
the same program outside of a page."""


def test_an_authors_mistake_reads_in_the_page_as_in_carts_check(
    tmp_path: Path, chromium: NewPage
) -> None:
    site = build_site(tmp_path / "site", packages=frozenset({TEACHER}))
    page = chromium()
    page.goto(write_page(site, packages=TEACHER).as_uri())
    page.evaluate("() => window.booted")
    names = [p.relative_to(GOLDEN).as_posix() for p in GOLDEN.rglob("*") if p.is_file()]
    files = {n: (GOLDEN / n).read_text(encoding="utf-8") for n in names if n.endswith(".yml")}
    for path in (GOLDEN / f"{name}.md" for name in FEW):
        lesson = {"file": path.name, "scenes": ["scenes"], "banks": ["banks"], "names": names}
        request = {"kind": "teach", "do": "look", "text": path.read_text(encoding="utf-8")}
        request |= {"lesson": lesson, "files": files}
        answer = page.evaluate("(request) => window.runtime.request(request)", request)
        header = answer["header"]
        while header["more"]:
            answer = page.evaluate("(request) => window.runtime.request(request)", request)
            header = answer["header"]
        rows = [
            f"{f['file']}:{f['line']}:{f['col']}: {f['severity']}: {f['message']}\n"
            + (f"  hint: {f['hint']}\n" if f["hint"] else "")
            for f in header["findings"]
        ]
        assert "".join(rows) == path.with_suffix(".txt").read_text(encoding="utf-8"), path.name


def test_what_is_for_teachers_or_exams_is_nowhere_in_the_site(site: Path) -> None:
    import base64
    import gzip

    told = {}
    for script in (site / "assets" / "carts" / "lessons").iterdir():
        packed = re.search(r'="([^"]+)"', script.read_text(encoding="ascii"))
        assert packed
        data = json.loads(gzip.decompress(base64.b64decode(packed[1])))
        told[data["file"]] = json.dumps(data, ensure_ascii=False)
    assert len(told) == len(list((ROOT / "worksheets").rglob("*.md")))
    assert "FALCON" in source("test-forces-and-motion")
    assert not any("FALCON" in text or "HARBOUR" in text for text in told.values())
    note = "Nearly everybody is with Ana or Ben"
    assert note in source("newtons-third-law")
    assert not any(note in text for text in told.values())
    bank = (ROOT / "worksheets" / "banks" / "forces-and-motion.yml").read_text(encoding="utf-8")
    asked = re.findall(r'text: "?([^"{}]{30,}?)["}]', bank)
    assert len(asked) > 10
    assert not any(line in text for line in asked for text in told.values())


def test_teacher_mode_loads_nothing_before_it_is_opened(lessons: Path, chromium: NewPage) -> None:
    page = chromium()
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto((lessons / "worksheets" / f"{LESSON}.html").as_uri())
    page.wait_for_selector("carts-scene[data-state=live]", timeout=WAIT)
    assert not [url for url in asked if "teacher" in url or "/lessons/" in url]


def test_it_can_be_used_with_the_keyboard_at_phone_size_and_axe_finds_nothing(
    lessons: Path, chromium: NewPage
) -> None:
    page = chromium(viewport={"width": 360, "height": 740}, color_scheme="dark")
    page.goto((lessons / "worksheets" / f"{LESSON}.html").as_uri())
    page.focus(".carts-teach-door a")
    page.keyboard.press("Enter")
    page.wait_for_selector(".carts-teach[data-state=ready]", timeout=WAIT)
    assert page.evaluate("document.activeElement.textContent") == "Change this lesson"
    pieces = page.locator(".carts-teach-piece > summary")
    listed = " ".join(pieces.all_inner_texts())
    assert not re.search(r"!!!|\{:|\*\*|\]\(", listed), "the list speaks as the page does"
    assert max(pieces.evaluate_all("all => all.map((one) => one.offsetHeight)")) < 60, "one line"
    expect(page.locator(".carts-teach-save")).to_be_in_viewport()
    for index in (0, 1, 4):
        pieces.nth(index).focus()
        page.keyboard.press("Enter")
    page.wait_for_selector(".carts-teach-piece:nth-child(5) .carts-teach-fields input")
    expect(page.locator(".carts-teach-save")).to_be_in_viewport()
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.closest('.carts-teach-fields') !== null")
    wide = page.evaluate("document.documentElement.scrollWidth")
    assert wide <= 360
    axe = (ROOT / "node_modules" / "axe-core" / "axe.min.js").read_text(encoding="utf-8")
    page.evaluate(axe)
    found = page.evaluate("axe.run('.carts-teach').then((result) => result.violations)")
    assert [(v["id"], [n["html"] for n in v["nodes"]][:2]) for v in found] == []
    page.get_by_role("button", name="Close").focus()
    page.keyboard.press("Enter")
    expect(page.locator(".carts-teach")).to_be_hidden()
    assert "#teacher" not in page.url


@pytest.mark.one_browser
def test_a_mistake_that_shows_elsewhere_is_told_with_its_place(
    lessons: Path, open_page: OpenPage
) -> None:
    """A scene has a new name: its questions lose it. It has that of another: that one is told."""
    page = open_teacher(open_page, lessons, "momentum-and-restitution")
    page.get_by_role("button", name="Change this scene").first.click()
    piece = page.locator(".carts-teach-piece[open]")
    piece.locator("details summary").last.click()
    area = piece.get_by_label("Text of this block")
    text, status = area.input_value(), page.locator(".carts-teach-status")
    places = {"momentum-else": "Read A's momentum", "momentum-bounce": "Two equal carts and"}
    for (name, place), count in zip(places.items(), ("mistakes", "1 mistake"), strict=True):
        area.fill(text.replace("id: momentum-stays", f"id: {name}"))
        settled(page)
        expect(status).to_contain_text(f"{count}: the page shows these parts as they were before")
        expect(status).to_contain_text(f"The first is in “{place}")
