"""Numbers typed beside readings of real carts: a decimal comma is read, what is none is told."""

from __future__ import annotations

from typing import Any

import pytest

from tests.web.figures.measured_site import element
from tests.web.scene.given.widget_site import in_node

HEAD = """
const { parseHTML } = await import("linkedom");
const { document, Event } = parseHTML("<main></main>");
globalThis.document = document;
const root = document.querySelector("main");
const type = (box, text) => {
  box.value = text;
  box.dispatchEvent(new Event("input"));
  box.dispatchEvent(new Event("change"));
  const place = box.closest("label, [data-hand]");
  return place.querySelector(".carts-error")?.textContent ?? "";
};
"""
BENCH = """
const { Hands } = await import(`${source}/measured/hands.js`);
const { Settings } = await import(`${source}/measured/settings.js`);
root.innerHTML = data.html;
const settings = new Settings(root, () => {});
settings.named(["A", "B"]);
const hands = new Hands(root, () => {});
for (const { slide } of hands.rows.values()) {
  Object.defineProperty(slide, "valueAsNumber", { get: () => Number(slide.value) });
}
hands.value = { touch: 1, v: [0.5, 0], ratio: 2, e: 1, duration: 0.1 };
const [mass] = root.querySelectorAll(".carts-measured-masses input");
const box = { mass, from: settings.from }[data.box] ?? hands.rows.get(data.box).box;
const told = type(box, data.typed);
const { from, masses } = settings.asked;
give([told, { ...hands.value, mass: masses.A, from }[data.box]]);
"""
FILM = """
const { inside } = await import(`${source}/film/skeleton.js`);
const { Setup } = await import(`${source}/film/setup.js`);
root.innerHTML = String(inside("one"));
const setup = new Setup(root, () => {});
setup.unit = { value: "m" };
setup.points = { one: { x: 0, y: 0 }, other: { x: 9, y: 0 } };
const told = [type(setup.boxes.length, data.length), type(setup.boxes.slower, data.slower)];
give([told, setup.ruler?.length ?? null, setup.slower]);
"""


@pytest.mark.parametrize(
    ("box", "typed", "read", "said"),
    [
        ("mass", "0,25", 0.25, ""),
        ("mass", "250 g", None, "“250 g” is not a number"),
        ("mass", "0", None, "A number above 0"),
        ("mass", "", None, ""),
        ("from", "−0,5", -0.5, ""),
        ("from", "1,000", None, "can mean 1 or 1000"),
        ("e", "0,8", 0.8, ""),
        ("e", "much", 1, "“much” is not a number"),
        ("e", "", 1, ""),
        ("e", "1,5", 1, "bounciness e: 0 to 1, please."),
        ("ratio", "-2", 2, "0.001 to 1000, please."),
        ("duration", "0", 0.1, "A number above 0, please."),
        ("touch", "-3", -3, ""),
    ],
)
def test_a_number_beside_readings_is_read_with_a_comma_or_told_not_to_be_one(
    box: str, typed: str, read: float | None, said: str
) -> None:
    page = element("id: film\ndata: real-carts.txt\nunits: {length: m, time: s}")
    told, value = in_node(HEAD + BENCH, {"html": page, "box": box, "typed": typed})
    assert value == read
    assert said in told and bool(said) == bool(told)


@pytest.mark.parametrize(
    ("length", "slower", "ruler", "times", "said"),
    [
        ("0,5", "2,5", 0.5, 2.5, ("", "")),
        ("0,5", "four", None, 1, ("", "“four” is not a number")),
        ("0,5", "0", None, 1, ("", "A number above 0")),
        ("half", "1", None, 1, ("“half” is not a number", "")),
    ],
)
def test_a_film_is_not_read_by_a_number_that_makes_no_sense(
    length: str, slower: str, ruler: float | None, times: float, said: tuple[str, str]
) -> None:
    found: Any = in_node(HEAD + FILM, {"length": length, "slower": slower})
    assert found[1:] == [ruler, times]
    for wanted, told in zip(said, found[0], strict=True):
        assert wanted in told and bool(wanted) == bool(told)


def test_a_number_that_was_found_is_rounded_as_its_slider_and_has_the_minus_of_the_tables() -> None:
    """Before, "-0.0002607" stood beside a table that says "−0.00026"."""
    script = """
    hands.reach([{ t: [0, 1, 2, 3, 4, 5], value: [0, 1, 2, 3, 4, 5] }], ["A", "B"]);
    hands.value = { touch: 1, v: [0.543212, -0.0002607], ratio: 2, e: 1, duration: 0.1 };
    const [va, vb] = ["va", "vb"].map((key) => hands.rows.get(key).box.value);
    give([va, vb, hands.value.v[1]]);
    """
    bench = BENCH[: BENCH.index("const [mass]")]
    page = element("id: film\ndata: real-carts.txt\nunits: {length: m, time: s}")
    found = in_node(HEAD + bench + script, {"html": page})
    assert found == ["0.5432", "−0.00026", -0.00026]
