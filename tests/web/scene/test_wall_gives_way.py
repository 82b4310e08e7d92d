"""A wall that a cart without bumpers runs into gives way, in the picture and in the lens."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import SharePage
from tests.web.scene.given.against_ends import AT_PEAK
from tests.web.scene.given.widget_site import MEETING, live, on_scene, widget_site, write_page

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

__all__ = ["widget_site"]  # a fixture

FOAM: dict[str, Any] = {
    "id": "foam",
    "title": "Against foam",
    "carts": {
        "A": {
            "mass": "0.5 kg",
            "position": "0.50 m",
            "velocity": "0.50 m/s",
            "length": "0.30 m",
            "bumper_length": "0 m",
        }
    },
    "track": {"length": "1.2 m", "right": "wall"},
    "contact": {"restitution": 0.2, "stiffness": "30 N/m"},
    "until": "3 s",
    "show": ["v", "F"],
    "with": ["lens"],
    "controls": [
        {"set": "contact.stiffness", "from": "30 N/m", "to": "2000 N/m", "step": "10 N/m"}
    ],
}
DRAWN = """const places = ["wide", "narrow"].map((kind) => {
  const stage = el.querySelector(`.carts-stage-${kind}`);
  const part = (name) => stage.querySelector(`.carts-${name}`).getAttribute("d") ?? "";
  const cart = stage.querySelector(".carts-cart");
  const box = cart.querySelector('[data-part="box"]');
  const [centre] = cart.getAttribute("transform").match(/[\\d.]+/);
  const front = Number(centre) + Number(box.getAttribute("width")) / 2;
  const xs = [...part("wall-face").matchAll(/[ML]([\\d.]+) /g)].map(([, x]) => Number(x));
  return { front, edge: xs[0], deepest: Math.max(...xs), was: part("was") };
});
return places;"""


@pytest.fixture
def foam(shared_page: SharePage, widget_site: Path) -> Page:
    page = live(shared_page(write_page(widget_site, "foam", FOAM)), "foam")
    on_scene(page, AT_PEAK, name="foam")
    return page


def test_no_cart_is_drawn_inside_a_wall(foam: Page) -> None:
    for place in on_scene(foam, DRAWN, name="foam"):
        assert place["front"] > place["edge"] + 10
        assert place["deepest"] == pytest.approx(place["front"], abs=0.2)
        assert place["was"].startswith(f"M{place['edge']:g} ")  # where the face was
    for place in on_scene(foam, f"el.time = 0; {DRAWN}", name="foam"):
        assert place["deepest"] == place["edge"]
        assert place["was"] == ""


def test_bumpers_give_way_before_the_wall_does(shared_page: SharePage, widget_site: Path) -> None:
    fence = {**MEETING, "id": "sprung"}
    page = live(shared_page(write_page(widget_site, "sprung", fence)), "sprung")
    hit = "el.trajectory.events.filter((e) => e.kind === 'peak').at(-1)"
    bodies = on_scene(page, f"el.time = {hit}.t; return {hit}.bodies;", name="sprung")
    assert bodies[1] == "right"
    for place in on_scene(page, DRAWN, name="sprung"):
        assert place["deepest"] == place["edge"]
        assert place["was"] == ""


def test_the_lens_shows_where_the_wall_was(foam: Page) -> None:
    heading = foam.locator("#foam .carts-lens .carts-heading")
    assert line_in_the_lens(foam)
    enlarged = heading.inner_text()
    assert not enlarged.endswith("×10")
    on_scene(foam, 'await el.set({"contact.stiffness": 2000});', name="foam")
    expect(heading).to_have_text(enlarged[: enlarged.index("×")] + "×10")
    on_scene(foam, AT_PEAK, name="foam")
    assert line_in_the_lens(foam)


def test_at_the_end_the_lens_shows_the_touch_that_was(foam: Page) -> None:
    """It was empty, but for a name on either side."""
    note = foam.locator("#foam .carts-lens-note")
    on_scene(foam, "el.time = 0;", name="foam")
    expect(note).to_contain_text("apart")
    assert not line_in_the_lens(foam)
    on_scene(foam, "el.time = 3;", name="foam")
    expect(note).to_contain_text("A and the wall: squeezed by")
    expect(foam.locator('#foam .carts-lens [data-part="when"]')).to_have_text(
        "when they pushed hardest"
    )
    assert line_in_the_lens(foam)


def line_in_the_lens(page: Page) -> bool:
    """Whether all of the dashed line is in the drawing."""
    inside: bool = on_scene(
        page,
        """const svg = el.querySelector(".carts-lens svg");
        const [frame, line] = [svg, svg.querySelector('[data-part="was"]')]
          .map((one) => one.getBoundingClientRect());
        return line.height > 0 && line.left > frame.left && line.right < frame.right;""",
        name="foam",
    )
    return inside


def test_what_has_no_bumper_has_no_bumper_in_words(foam: Page) -> None:
    told = foam.locator("#foam .carts-events")
    expect(told).to_contain_text("A and the wall: squeezed the most, 1.9")
    expect(told).not_to_contain_text("bumper")


RULED = """await el.set({ "track.length": argument });
el.time = 0;
return ["wide", "narrow"].map((kind) => {
  const stage = el.querySelector(`.carts-stage-${kind}`);
  const [beam, face] = ["beam", "wall-face"].map((name) => stage.querySelector(`.carts-${name}`));
  const told = [...stage.querySelectorAll(".carts-number")]
    .filter((one) => one.getAttribute("visibility") !== "hidden");
  return { face: Number(face.getAttribute("d").match(/[\\d.]+/)[0]),
    end: Number(beam.getAttribute("x")) + Number(beam.getAttribute("width")),
    last: Number(told.at(-1).textContent) };
});"""


@pytest.mark.parametrize("unit", ["m", "cm"])
def test_a_slider_of_the_track_s_length_moves_wall_beam_and_ruler(
    shared_page: SharePage, widget_site: Path, unit: str
) -> None:
    """The cart turned in mid-track, or drove through the old wall."""
    ends = {"m": ("1.2 m", "2 m", "0.1 m"), "cm": ("120 cm", "200 cm", "10 cm")}[unit]
    slider = {"set": "track.length", **dict(zip(("from", "to", "step"), ends, strict=True))}
    plain = {**FOAM, "track": {"length": "1.6 m", "right": "wall"}, "controls": [slider]}
    page = live(shared_page(write_page(widget_site, "track", {**plain, "id": "track"})), "track")
    for length in (1.2, 2.0):
        for place in on_scene(page, RULED, length, name="track"):
            assert place["face"] == pytest.approx(place["end"], abs=0.2)
            assert place["last"] <= length + 1e-9
            assert place["last"] > length - 0.6
