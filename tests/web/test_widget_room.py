"""What fits where: carts and graphs on one screen, labels beside each other, events in full."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.web.conftest import OpenPage
from tests.web.widget_site import live, on_scene, widget_site, write_page

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


@pytest.mark.parametrize("width", [700, 1075])
def test_after_the_lock_carts_play_and_graphs_fit_on_a_laptop(
    open_page: OpenPage, widget_site: Path, width: int
) -> None:
    page = live(
        open_page(
            write_page(widget_site, "asked", QUESTION), viewport={"width": width, "height": 768}
        ),
        "asked",
    )
    page.locator("#asked input[type=radio]").first.check()
    page.locator("#asked .carts-lock").click()
    page.wait_for_selector("#asked:not(.carts-asks)")
    top, *bottoms = on_scene(
        page,
        """const box = (part) => part.getBoundingClientRect();
        return [box(el).top, box(el.querySelector(".carts-play")).bottom,
          ...[...el.querySelectorAll(".carts-plot")].map((plot) => box(plot).bottom)];""",
        name="asked",
    )
    assert max(bottoms) - top <= SCREEN
    options = page.locator("#asked .carts-options label:visible")
    assert options.all_inner_texts() == ["It slows down"]


def test_ten_events_stand_in_full_and_more_are_scrolled(
    open_page: OpenPage, widget_site: Path
) -> None:
    bouncing = {
        "id": "bouncing",
        "carts": {"A": {"mass": 1, "position": 0.5, "velocity": 1}},
        "contact": {"restitution": 1, "stiffness": 4000},
        "track": {"left": "wall", "right": "wall", "length": 1},
        "until": 1,
    }
    page = live(open_page(write_page(widget_site, "bouncing", bouncing)), "bouncing")
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
    open_page: OpenPage, widget_site: Path
) -> None:
    page = live(open_page(write_page(widget_site, "paper", {**QUESTION, "id": "paper"})), "paper")
    assert page.locator("#paper .carts-write hr:visible").count() == 0
    page.emulate_media(media="print")
    assert page.locator("#paper .carts-write hr:visible").count() == 4
    assert page.locator('#paper .carts-control[data-set="B.mass"]:visible').count() == 0


@pytest.mark.parametrize("width", [360, 1000])
def test_signs_of_touching_heavy_carts_do_not_overlap(
    open_page: OpenPage, widget_site: Path, width: int
) -> None:
    heavy = {
        "id": "heavy",
        "carts": {
            "A": {"mass": "0.2", "position": "0.3", "velocity": "0.5"},
            "B": {"mass": 1, "position": "0.5"},
            "C": {"mass": 5, "position": "0.7"},
        },
        "track": {"length": "1.4"},
        "until": 2,
    }
    page = live(
        open_page(
            write_page(widget_site, "heavy", heavy), viewport={"width": width, "height": 700}
        ),
        "heavy",
    )
    overlaps = on_scene(
        page,
        """const stage = [...el.querySelectorAll(".carts-stage")].find((s) => s.clientWidth);
        const signs = [...stage.querySelectorAll(".carts-break text, .carts-mass")]
          .filter((text) => text.getClientRects().length
            && getComputedStyle(text).visibility === "visible");
        const room = 2; // px of empty height above and below the letters of a line
        return signs.flatMap((a, i) => signs.slice(i + 1).filter((b) => {
          const [p, q] = [a.getBoundingClientRect(), b.getBoundingClientRect()];
          return p.left < q.right && q.left < p.right
            && p.top + room < q.bottom - room && q.top + room < p.bottom - room;
        }).map((b) => `${a.textContent} | ${b.textContent}`));""",
        name="heavy",
    )
    assert overlaps == []
