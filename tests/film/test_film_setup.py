"""What a film still needs is said, and what cannot be is not taken: no page."""

from __future__ import annotations

from typing import Any

import pytest

from sim.measured.track import FEWEST
from tests.web.scene.given.widget_site import in_node

SETUP = """
globalThis.document = { documentElement: { lang: "en" }, activeElement: null };
const { Setup } = await import(`${source}/film/setup.js`);
const box = (value) => Object.assign(new EventTarget(), { value });
const parts = {
  ".carts-film-length": box(data.length),
  ".carts-film-slower": box("1"),
  ".carts-film-unit": box("m"),
};
const root = { querySelector: (name) => parts[name], querySelectorAll: () => [] };
const setup = new Setup(root, () => {});
for (const point of data.points) setup.set(point);
"""
MARKS = [{"x": 10, "y": 10, "radius": 4}, {"x": 60, "y": 10, "radius": 4}]
ENDS = [{"x": 10, "y": 90}, {"x": 200, "y": 90}]


@pytest.mark.parametrize(
    ("points", "length", "said"),
    [
        ([], "", "Click on the mark of cart A."),
        (MARKS, "1", "Click on one end of a ruler that lies along the track."),
        ([*MARKS, *ENDS], "", "Type how long the ruler is, then press “Follow”."),
        ([*MARKS, *ENDS], "1,5", "Type how long the ruler is, then press “Follow”."),
        ([*MARKS, *ENDS], "100 cm", "Length of the ruler: “100 cm” is not a number. "
                                    "Type for example 0.5"),
        ([*MARKS, *ENDS], "0", "Length of the ruler: A number above 0, please."),
        ([*MARKS, ENDS[0], ENDS[0]], "1", "Both ends of the ruler are in one place. Press the "
                                          "button of an end and set it anew."),
    ],
)  # fmt: skip
def test_what_keeps_a_film_from_being_followed_is_said(
    points: list[Any], length: str, said: str
) -> None:
    given = {"points": points, "length": length}
    found, ready = in_node(SETUP + "give([setup.next, Boolean(setup.ruler)]);", given)
    assert found == said
    assert ready == (length == "1,5")


def test_a_film_needs_as_many_frames_as_any_readings() -> None:
    given = {"points": [], "length": ""}
    found = in_node(SETUP + "give((await import(`${source}/film/setup.js`)).FEWEST);", given)
    assert found == FEWEST


CLICK = """
const { Frames } = await import(`${source}/film/frames.js`);
const { click } = await import(`${source}/film/click.js`);
const waiting = [];
const helper = { ask: (asked) => new Promise((done) => waiting.push({ asked, done })) };
const frames = new Frames(helper, () => {}, () => {});
const turn = () => new Promise((done) => setTimeout(done));
const film = { helper, frames, setup };
const place = { x: 30, y: 10 };
"""


@pytest.mark.parametrize(
    ("steps", "set_"),
    [
        ("const clicked = click(film, place); waiting[0].done({ mark: place });", True),
        # the frame that was wished for comes before the mark of the one that was clicked on
        ("const clicked = click(film, place); frames.beside(1); waiting[1].done({ time: 1 });"
         "await turn(); waiting[0].done({ mark: place });", False),
        ("frames.beside(1); const clicked = click(film, place);", False),
    ],
    ids=["still", "on before the mark", "on its way"],
)  # fmt: skip
def test_a_mark_is_one_of_the_frame_that_is_shown(steps: str, set_: bool) -> None:
    given = {"points": [], "length": ""}
    found = in_node(SETUP + CLICK + steps + "await clicked; give(Boolean(setup.points.A));", given)
    assert found is set_


def test_steps_that_are_pressed_quickly_go_on_from_what_is_wished_for() -> None:
    given = {"points": [], "length": ""}
    found = in_node(
        SETUP
        + CLICK
        + """
        frames.want(5);
        frames.want(6);
        for (const _ of [1, 2, 3]) frames.beside(1);
        waiting[0].done({ time: 5 });
        await turn();
        give(waiting.map(({ asked: { time, step } }) => [time, step]));
        """,
        given,
    )
    assert found == [[5, 0], [6, 3]]


@pytest.mark.parametrize(("x", "other"), [(10, True), (12, True), (30, False)])
def test_one_mark_is_not_taken_for_both_carts(x: float, other: bool) -> None:
    given = {"points": MARKS[:1], "length": ""}
    mark = f"{{ x: {x}, y: 10, radius: 4 }}"
    assert in_node(SETUP + f"give(setup.isOther({mark}));", given) is other
