"""What a cart is drawn as: lines on its box, and nothing else."""

from __future__ import annotations

import re
from typing import Any

import pytest

from sim.pages.widget.render import render
from sim.scene.fields import SKINS
from tests.web.scene.given.widget_site import MEETING, baked, in_node

BOX = {"width": 40, "height": 60}


def with_skin(skin: str) -> dict[str, Any]:
    carts = {**MEETING["carts"]}
    return {**MEETING, "carts": {**carts, "A": {**carts["A"], "skin": skin}}}


@pytest.mark.parametrize("skin", SKINS)
def test_a_run_does_not_know_what_its_carts_look_like(skin: str) -> None:
    _, header, numbers = baked(with_skin(skin))
    _, plain, same = baked(MEETING)
    assert header == plain
    assert numbers == same


def test_a_page_whose_carts_are_carts_holds_no_skin() -> None:
    assert 'data-part="skin"' not in render(*baked(MEETING))
    assert render(*baked(with_skin("van"))).count('data-part="skin"') == 2  # wide and narrow


@pytest.mark.parametrize("skin", [skin for skin in SKINS if skin != "cart"])
def test_the_lines_of_a_skin_stay_on_its_box_and_face_the_way_it_drives(skin: str) -> None:
    right, left, narrow = in_node(
        """const { SKINS } = await import(view + "/skins.js");
        const { lines } = SKINS[data.skin];
        const pair = /(-?[\\d.]+) (-?[\\d.]+)/g;
        const points = (path) => [...path.matchAll(pair)].map(([, x, y]) => [+x, +y]);
        const [right, left] = [1, -1].map((front) => points(lines(data.box, front)));
        give([right, left, lines({ ...data.box, width: 10 }, 1)]);""",
        {"skin": skin, "box": BOX},
    )
    assert right
    assert all(abs(x) <= BOX["width"] / 2 and -BOX["height"] <= y <= 0 for x, y in right)
    assert left == [[-x, y] for x, y in right]
    assert narrow == ""


def test_a_glider_floats_above_the_track_on_a_box_like_any_other() -> None:
    plain, floats = (drawn_cart(skin) for skin in ("cart", "glider"))
    assert floats["box"] == plain["box"]
    assert floats["x"] == plain["x"]
    assert 2 <= plain["y"] - floats["y"] <= 6  # units: a gap that is seen, and small
    assert plain["wheels"]
    assert not floats["wheels"]


def drawn_cart(skin: str) -> dict[str, Any]:
    """Where the wide picture has cart A, and its box."""
    made = render(*baked(with_skin(skin)))
    start = re.search(
        r'<g transform="translate\(([\d.]+) ([\d.]+)\)" class="carts-cart [^>]*data-body="A">', made
    )
    assert start
    cart = made[start.end() : made.index("</g>\n", start.end())]
    box = re.search(r'<rect [^>]*data-part="box"[^>]*>', cart)
    assert box
    return {
        "x": float(start[1]),
        "y": float(start[2]),
        "box": dict(re.findall(r'\b(x|y|width|height)="([-\d.]+)"', box[0])),
        "wheels": 'data-part="wheels"' in cart,
    }


def renamed(name: str) -> str:
    carts = {name if one == "A" else one: cart for one, cart in MEETING["carts"].items()}
    return render(*baked({"id": "named", "carts": carts, "until": 3}))


def test_a_cart_whose_name_is_a_word_has_it_as_its_head() -> None:
    assert 'aria-label="Cart A"' in renamed("A")
    page = renamed("truck")
    assert "Cart truck" not in page
    assert 'role="group" aria-label="truck"' in page


@pytest.mark.parametrize(
    ("name", "skin", "above"),
    [("A", "truck", False), ("M1", "cart", False), ("car", "cart", False), ("car", "truck", True),
     ("locomotive", "cart", True)],
)  # fmt: skip
def test_a_word_stands_above_a_cart_that_is_too_narrow_for_it_or_has_lines(
    name: str, skin: str, above: bool
) -> None:
    """“truck” lay over the lines of its drawing, and “car” stuck out of its cart."""
    made = in_node(
        """const { box } = await import(view + "/shapes.js");
        const body = { name: data.name, mass: 1, length: 0.2, bumper_length: 0.04 };
        const layout = { stagger: 17, ranks: 1, scale: 300 };
        const skin = data.skin === "cart" ? undefined : data.skin;
        give(box(body, { perHeight: 1 }, layout, 0, skin));""",
        {"name": name, "skin": skin},
    )
    assert (made["nameY"] is None) is above
    assert made["label"] == (f"{name}: 1 kg" if above else "1 kg")
