"""What fits where: carts and graphs on one screen, labels beside each other, events in full."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage, SharePage
from tests.web.scene.given.widget_site import (
    in_windows,
    live,
    lock,
    on_scene,
    widget_site,
    write_page,
)

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture

SCREEN = 768 - 96  # px of a small laptop below the header of the page

QUESTION: dict[str, Any] = {
    "id": "asked",
    "carts": {
        "A": {"mass": "0.5 kg", "position": "0.30 m", "velocity": "0.60 m/s"},
        "B": {"mass": "1.0 kg", "position": "1.10 m"},
    },
    "track": {"length": "2.4 m"},
    "until": 4,
    "show": ["x", "v"],
    "predict": {"ask": "What does B do?", "choice": ["It slows down", "It goes on"]},
    "controls": [{"set": "B.mass", "from": "0.5 kg", "to": "4 kg", "step": "0.5 kg"}],
}


FEET = """const box = (part) => part.getBoundingClientRect();
  return [box(el).top, box(el.querySelector(".carts-play")).bottom,
    ...[...el.querySelectorAll(".carts-plot")].map((plot) => box(plot).bottom)];"""


@pytest.mark.one_browser
def test_after_the_lock_carts_play_and_graphs_fit_on_a_laptop(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(write_page(widget_site, "asked", QUESTION)), "asked")
    page.locator("#asked input[type=radio]").first.check()
    lock(page, "asked")
    for width in in_windows(page, (700, 1075), 768):
        top, *bottoms = on_scene(page, FEET, name="asked")
        assert max(bottoms) - top <= SCREEN, width
        options = page.locator("#asked .carts-options label:visible")
        assert options.all_inner_texts() == ["It slows down"]


@pytest.mark.one_browser
def test_ten_events_stand_in_full_and_more_are_scrolled(
    shared_page: SharePage, widget_site: Path
) -> None:
    bouncing = {
        "id": "bouncing",
        "carts": {"A": {"mass": 1, "position": 0.5, "velocity": 1}},
        "contact": {"restitution": 1, "stiffness": 4000},
        "track": {"left": "wall", "right": "wall", "length": 1},
        "until": 1,
    }
    page = live(shared_page(write_page(widget_site, "bouncing", bouncing)), "bouncing")
    seen = """const list = el.querySelector(".carts-events");
      return [list.children.length, list.scrollHeight > list.clientHeight,
        list.getAttribute("tabindex")];"""
    few, scrolled, stop = on_scene(page, seen, name="bouncing")
    assert few <= 10
    assert not scrolled
    assert stop is None
    on_scene(page, "await el.set({ 'A.velocity': 6 });", name="bouncing")
    many, scrolled, stop = on_scene(page, seen, name="bouncing")
    assert many > 10
    assert scrolled
    assert stop == "0"


def test_on_paper_there_are_lines_to_write_on_and_no_velocity_twice(
    shared_page: SharePage, widget_site: Path, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("this driver cannot show Firefox's pages as on paper; the style sheet is one")
    page = live(shared_page(write_page(widget_site, "paper", {**QUESTION, "id": "paper"})), "paper")
    assert page.locator("#paper .carts-write hr:visible").count() == 0
    page.emulate_media(media="print")
    expect(page.locator("#paper .carts-write hr").filter(visible=True)).to_have_count(4)
    expect(page.locator('#paper .carts-control[data-set="B.mass"]')).to_be_hidden()


HEAVY: dict[str, Any] = {
    "id": "heavy",
    "carts": {
        "A": {"mass": "0.2", "position": "0.3", "velocity": "0.5"},
        "B": {"mass": 1, "position": "0.5"},
        "C": {"mass": 5, "position": "0.7"},
        "D": {"mass": 6, "position": "0.9"},
    },
    "track": {"length": "1.4"},
    "until": 2,
}
FONTS = ["inherit", "serif", "monospace", "sans-serif", "cursive"]
OVERLAPS = """
  const pen = document.createElement("canvas").getContext("2d");
  const ink = (text) => { // the letters themselves: what else fonts count in differs
    const style = getComputedStyle(text);
    pen.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    const size = pen.measureText(text.textContent);
    const matrix = text.getScreenCTM();
    const start = text.getStartPositionOfChar(0).matrixTransform(matrix);
    const { left, right } = text.getBoundingClientRect();
    return { left, right, top: start.y - size.actualBoundingBoxAscent * matrix.d,
      bottom: start.y + size.actualBoundingBoxDescent * matrix.d };
  };
  const stage = [...el.querySelectorAll(".carts-stage")].find((s) => s.clientWidth);
  return argument.flatMap((font) => {
    stage.style.fontFamily = font;
    const signs = [...stage.querySelectorAll("text")].filter((text) =>
      text.textContent && text.getClientRects().length
      && getComputedStyle(text).visibility === "visible");
    const inks = signs.map(ink);
    return inks.flatMap((p, i) => inks.slice(i + 1).flatMap((q, k) =>
      p.left < q.right && q.left < p.right && p.top < q.bottom && q.top < p.bottom
        ? [`${font}: ${signs[i].textContent} | ${signs[i + 1 + k].textContent}`] : []));
  });"""


@pytest.mark.parametrize("width", [360, pytest.param(1000, marks=pytest.mark.one_browser)])
@pytest.mark.parametrize("length", ["1.4", pytest.param("4", marks=pytest.mark.one_browser)])
def test_signs_of_touching_carts_do_not_overlap_in_any_font(
    shared_page: SharePage, widget_site: Path, width: int, length: str
) -> None:
    scene = {**HEAVY, "track": {"length": length}}
    page = live(
        shared_page(
            write_page(widget_site, "heavy", scene), window={"width": width, "height": 700}
        ),
        "heavy",
    )
    for t in (0.0, 0.05, 0.15):
        on_scene(page, f"el.time = {t};", name="heavy")
        assert on_scene(page, OVERLAPS, FONTS if t == 0 else ["inherit"], name="heavy") == []
    torn = page.locator("#heavy .carts-torn").filter(visible=True)
    expect(torn).to_contain_text("not to scale")
    on_scene(page, "await el.set({ 'B.mass': 0.5, 'C.mass': 0.5, 'D.mass': 0.5 });", name="heavy")
    expect(torn).to_have_count(0)


@pytest.mark.one_browser
def test_names_of_forces_stay_between_the_walls(shared_page: SharePage, widget_site: Path) -> None:
    narrow = {
        "id": "between",
        "carts": {
            "A": {"mass": 1, "position": "0.15", "velocity": "0.2"},
            "B": {"mass": 1, "position": "0.36"},
        },
        "track": {"length": "1.2", "left": "wall", "right": "wall"},
        "until": 8,
    }
    page = live(
        shared_page(
            write_page(widget_site, "between", narrow), window={"width": 360, "height": 700}
        ),
        "between",
    )
    outside, seen = on_scene(
        page,
        """const stage = el.querySelector(".carts-stage-narrow");
        const faces = [...stage.querySelectorAll(".carts-wall-face")]
          .map((face) => face.getBoundingClientRect().x).sort((a, b) => a - b);
        let seen = 0;
        const outside = el.trajectory.events.filter((e) => e.kind === "peak").flatMap((event) => {
          el.time = event.t;
          return [...stage.querySelectorAll(".carts-push text")]
            .filter((text) => text.getAttribute("visibility") === "visible")
            .filter((text) => { seen += 1; const box = text.getBoundingClientRect();
              return box.left < faces[0] || box.right > faces[1]; })
            .map((text) => `${event.t}: ${text.textContent}`);
        });
        return [outside, seen];""",
        name="between",
    )
    assert outside == []
    assert seen >= 4


def test_a_reader_who_wants_no_motion_gets_stills(
    open_page: OpenPage, widget_site: Path, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("this driver cannot ask Firefox for reduced motion; the module is one")
    page = live(open_page(widget_site / "meeting.html", reduced_motion="reduce"))
    assert on_scene(page, "return el.time") == 0
    seen = on_scene(
        page,
        """const cart = el.querySelector('.carts-cart'), stills = [];
        const touch = el.trajectory.events[0].t;
        await new Promise((done) => {
          const watch = new MutationObserver(() => {
            stills.push([el.time, performance.now()]);
            if (el.time > touch) done();
          });
          watch.observe(cart, { attributes: true, attributeFilter: ["transform"] });
          el.querySelector(".carts-play").click();
        });
        return { stills, touch };""",
    )
    times, clock = zip(*seen["stills"], strict=True)
    assert all(later - before > 900 for before, later in pairwise(clock))  # ms
    assert any(t == pytest.approx(seen["touch"], abs=1e-9) for t in times)


@pytest.mark.one_browser
def test_the_ring_around_a_typed_number_leaves_its_unit_free_on_a_phone(
    shared_page: SharePage, widget_site: Path
) -> None:
    page = live(shared_page(widget_site / "meeting.html", window={"width": 360, "height": 700}))
    box = page.locator("#meeting .carts-control .carts-number-box").first
    box.focus()
    page.keyboard.press("Shift")  # as who goes on by keys: else no ring is drawn
    free = box.evaluate(
        """(box) => {
          const { outlineStyle, outlineWidth, outlineOffset } = getComputedStyle(box);
          const unit = document.createRange();
          unit.selectNodeContents(box.parentElement.querySelector(".carts-unit-text"));
          const ring = parseFloat(outlineWidth) + parseFloat(outlineOffset);
          const gap = unit.getBoundingClientRect().left - box.getBoundingClientRect().right;
          return [outlineStyle, gap - ring];
        }"""
    )
    assert free[0] == "solid"
    assert free[1] >= 0.5, free
