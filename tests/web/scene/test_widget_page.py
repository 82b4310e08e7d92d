"""`<carts-scene>` in real browsers, by double click, with real Python behind it."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage, SharePage
from tests.web.scene.given.widget_site import (
    AT_REST,
    FENCES,
    MEETING,
    PLAYS,
    in_windows,
    live,
    on_scene,
    widget_site,
    write_page,
)

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture

STILL = """el => {
  const copy = el.querySelector(".carts-frame").cloneNode(true);
  // Where Python took long to start a note said so; hidden again, it keeps its place.
  copy.querySelector(".carts-note").removeAttribute("style");
  for (const part of copy.querySelectorAll("*")) {
    for (const name of ["disabled", "value"]) part.removeAttribute(name);
    part.classList.remove("carts-draggable", "carts-is-playing", "carts-is-slow");
    const sorted = [...part.attributes].sort((a, b) => (a.name < b.name ? -1 : 1));
    for (const { name } of sorted) part.removeAttribute(name);
    for (const { name, value } of sorted) {
      if (value || name !== "class") part.setAttribute(name, value);
    }
  }
  copy.querySelector(".carts-mark").removeAttribute("aria-label");
  // What only a script has, and what depends on the size of the screen.
  const added = ".carts-choices, .carts-take, .carts-project-bar, .carts-hands, .carts-lens svg";
  for (const part of copy.querySelectorAll(added)) part.remove();
  return copy.outerHTML.split(/(?=<[a-z])/).map((part) => part.trim());
}"""


@pytest.mark.one_browser
@pytest.mark.parametrize("name", ["meeting", "coasting", "struck"])
def test_what_python_computes_is_what_was_baked(
    open_page: OpenPage, widget_site: Path, name: str
) -> None:
    """Adopting the page and taking over changes nothing that a reader sees."""
    text = (widget_site / f"{name}.html").read_text(encoding="utf-8")
    quiet = widget_site / f"quiet-{name}.html"
    quiet.write_text(text.replace("carts.js", "none.js"), encoding="utf-8")
    baked = open_page(quiet).locator(f"#{name}").evaluate(STILL)
    page = live(open_page(widget_site / f"{name}.html"), name)
    page.locator(f"#{name}").evaluate(AT_REST)  # tables are filled a while after the run is there
    assert page.locator(f"#{name}").evaluate(STILL) == baked


@pytest.mark.one_browser
def test_nothing_jumps_and_the_marks_are_set(open_page: OpenPage, widget_site: Path) -> None:
    page = live(open_page(widget_site / "meeting.html"))
    marks = page.evaluate("performance.getEntriesByType('mark').map((mark) => mark.name)")
    assert marks.index("carts:still") < marks.index("carts:live")
    shift = page.evaluate(
        """new Promise((resolve) => {
          let sum = 0;
          try {
            new PerformanceObserver((list) => {
              for (const entry of list.getEntries()) sum += entry.value;
            }).observe({ type: "layout-shift", buffered: true });
          } catch { resolve(0); }
          setTimeout(() => resolve(sum), 200);
        })"""
    )
    assert shift <= 0.01


@pytest.mark.one_browser
def test_steps_never_pass_over_an_event(shared_page: SharePage, widget_site: Path) -> None:
    page = live(shared_page(widget_site / "meeting.html"))
    page.locator("#meeting .carts-speed").select_option("10")
    page.locator("#meeting .carts-slow").uncheck()
    times = on_scene(
        page,
        """const seen = [];
        for (let k = 0; k < 40; k += 1) { el.querySelector(".carts-forward").click();
          seen.push(el.time); }
        return [seen, el.trajectory.events.map((event) => event.t)];""",
    )
    assert set(times[1]) <= set(times[0])


@pytest.mark.one_browser
def test_slow_motion_shows_both_clocks(shared_page: SharePage, widget_site: Path) -> None:
    page = live(shared_page(widget_site / "meeting.html"))
    on_scene(page, "el.time = el.trajectory.events.find((e) => e.kind === 'peak').t")
    expect(page.locator("#meeting .carts-slow-note")).to_be_visible()
    expect(page.locator("#meeting .carts-rate")).to_have_text("1/50")
    classes = page.locator("#meeting .carts-world").get_attribute("class") or ""
    assert "carts-is-slow" in classes


def test_force_arrows_are_equal_and_point_into_their_bodies(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "meeting.html"))
    told = on_scene(
        page,
        """el.time = el.trajectory.events.find((e) => e.kind === "peak").t;
        const arrow = (on) => el.querySelector(
          `.carts-stage-wide [data-pair="A-B"][data-on="${on}"] [data-part="arrow"]`).getBBox();
        const words = [...el.querySelectorAll('.carts-stage-wide [data-pair="A-B"] text')];
        const [a, b] = [arrow("A"), arrow("B")];
        return { a: [a.x, a.width], b: [b.x, b.width], words: words.map((w) => w.textContent) };""",
    )
    (ax, aw), (bx, bw) = told["a"], told["b"]
    assert aw == pytest.approx(bw, abs=0.15)
    assert ax + aw == pytest.approx(bx, abs=0.25)  # tail to tail, where the bumpers meet
    assert [w.split(":")[0] for w in told["words"]] == ["on A by B", "on B by A"]
    assert len({w.split(":")[1] for w in told["words"]}) == 1


@pytest.mark.one_browser
def test_the_live_region_tells_events(shared_page: SharePage, widget_site: Path) -> None:
    page = live(shared_page(widget_site / "meeting.html"))
    page.locator("#meeting .carts-speed").select_option("10")
    page.locator("#meeting .carts-slow").uncheck()
    page.locator("#meeting .carts-play").click()
    expect(page.locator("#meeting .carts-announcer")).to_contain_text(
        "End of the run", timeout=5000
    )


def test_a_missing_runtime_is_said_and_the_baked_run_plays(
    open_page: OpenPage, widget_site: Path, tmp_path: Path
) -> None:
    site = tmp_path / "broken"
    shutil.copytree(widget_site, site)
    shutil.rmtree(site / "assets" / "carts" / "runtime")
    page = open_page(site / "meeting.html")
    page.wait_for_selector('#meeting[data-state="failed"]', timeout=10_000)
    assert page.locator("#meeting").get_attribute("data-reason")
    expect(page.locator("#meeting .carts-note")).to_contain_text("The prepared run still plays")
    page.locator("#meeting .carts-play").click()
    page.wait_for_function(PLAYS)
    rejected = on_scene(page, "return el.ready.then(() => '', (error) => error.message)")
    assert rejected
    refused = on_scene(page, "return el.set({ 'A.mass': 2 }).then(() => '', (e) => e.message)")
    assert refused


@pytest.mark.one_browser
def test_an_older_browser_plays_the_baked_run_and_says_one_sentence(
    open_page: OpenPage, widget_site: Path
) -> None:
    text = (widget_site / "meeting.html").read_text(encoding="utf-8")
    old = widget_site / "old.html"
    (widget_site / "old.js").write_text("delete self.DecompressionStream;", encoding="utf-8")
    first = '<script src="old.js"></script><link rel="stylesheet"'
    old.write_text(text.replace('<link rel="stylesheet"', first, 1), encoding="utf-8")
    page = open_page(old)
    expect(page.locator("#meeting .carts-note")).to_contain_text("too old to run Python")
    page.locator("#meeting .carts-play").click()
    page.wait_for_function(PLAYS)


def test_without_javascript_the_picture_stands(
    open_page: OpenPage, widget_site: Path, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("Playwright cannot switch off JavaScript in Firefox ESR")
    page = open_page(widget_site / "meeting.html", java_script_enabled=False)
    expect(page.locator("#meeting .carts-stage-wide")).to_be_visible()
    expect(page.locator("#meeting .carts-noscript")).to_be_visible()
    expect(page.locator("#meeting .carts-play")).to_be_disabled()


OUTSIDE = """const frame = el.getBoundingClientRect();
  return [...el.querySelectorAll("button, input, select, output, .carts-plot text")]
    .filter((part) => part.getClientRects().length)
    .filter((part) => { const box = part.getBoundingClientRect();
      return box.left < frame.left - 1 || box.right > frame.right + 1; })
    .map((part) => part.outerHTML.slice(0, 80));"""


@pytest.mark.one_browser
def test_nothing_sticks_out(open_page: OpenPage, widget_site: Path) -> None:
    """Opened on a phone, then in windows that are pulled wider."""
    page = live(open_page(widget_site / "meeting.html", viewport={"width": 360, "height": 800}))
    on_scene(page, "el.time = el.trajectory.events.find((e) => e.kind === 'peak').t")
    for width in in_windows(page, (360, 800, 1300), 800):
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), width
        assert on_scene(page, OUTSIDE) == [], width


def test_two_scenes_share_one_worker(open_page: OpenPage, widget_site: Path) -> None:
    other = {**MEETING, "id": "other", "until": "3 s"}
    page = open_page(write_page(widget_site, "both", MEETING, other))
    live(page, "meeting")
    live(page, "other")
    assert len(page.workers) <= 1
    assert on_scene(page, "await el.set({ 'A.mass': 3 }); return el.trajectory.t.at(-1)",
                    name="other") == 3  # fmt: skip
    assert on_scene(page, "return el.trajectory.t.at(-1)") == 6


@pytest.mark.one_browser
def test_no_page_complains(open_page: OpenPage, widget_site: Path) -> None:
    """No error and no violation of the policy while a reader uses everything once, on a page that
    has a scene of every kind."""
    page = open_page(write_page(widget_site, "all", *FENCES.values()))
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda m: errors.append(m.text) if m.type == "error" else None)
    for name in FENCES:
        live(page, name)
        for button in page.locator(f"#{name} button:enabled").all():
            if button.is_visible() and not re.search(
                "carts-lock|carts-project", button.get_attribute("class") or ""
            ):
                button.click()
        assert errors == [], name
