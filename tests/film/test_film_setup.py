"""What a film still needs is said, and what cannot be is not taken: no page."""

from __future__ import annotations

from typing import Any

import pytest

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


@pytest.mark.parametrize(("x", "other"), [(10, True), (12, True), (30, False)])
def test_one_mark_is_not_taken_for_both_carts(x: float, other: bool) -> None:
    given = {"points": MARKS[:1], "length": ""}
    mark = f"{{ x: {x}, y: 10, radius: 4 }}"
    assert in_node(SETUP + f"give(setup.isOther({mark}));", given) is other
