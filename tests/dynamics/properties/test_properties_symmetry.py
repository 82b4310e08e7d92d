"""Symmetries of mechanics over random scenes: mirror, moving train, time reversed, other units."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.dynamics.given.random_effects import ELASTIC, acted_on
from tests.dynamics.given.random_runs import FEW, FEWER, HALF, finished
from tests.fuzz.mirror import mirrored

GROWN = 1e-8
"""m/s. What rounding, 1e-16, may have grown to after a dozen contacts."""


def events(result: Any) -> int:
    """How many there were, the end left out."""
    return sum(result.record.counts.values()) - 1


@HALF
@given(acted_on())
def test_the_mirror_image_runs_as_the_mirror_image(plain: dict[str, Any]) -> None:
    one, two = finished(plain), finished(mirrored(plain))
    if one is None or events(one) > FEW:
        return
    assert [-v for v in reversed(two.v)] == pytest.approx(list(one.v), abs=GROWN)
    assert two.ledger.warmed == pytest.approx(one.ledger.warmed, abs=GROWN)
    for kind, work in one.ledger.works.items():
        assert two.ledger.works[kind] == pytest.approx(work, abs=GROWN)


def shifted(plain: dict[str, Any], boost: str) -> dict[str, Any]:
    carts = {
        name: cart | {"velocity": str(Decimal(cart["velocity"]) + Decimal(boost))}
        for name, cart in plain["carts"].items()
    }
    return plain | {"carts": carts}


@given(
    acted_on(("incline", "push", "spring", "magnets", "release"), walls=False),
    st.sampled_from(["0.5", "-3"]),
)
def test_from_a_moving_train_everything_looks_the_same(plain: dict[str, Any], boost: str) -> None:
    """No walls, no track that rubs, no air: nothing says who is at rest."""
    one, two = finished(plain), finished(shifted(plain, boost))
    if one is None or events(one) > FEW:
        return
    assert [v - float(boost) for v in two.v] == pytest.approx(list(one.v), abs=GROWN)


@given(acted_on(("incline", "spring", "magnets"), contact=ELASTIC))
def test_where_nothing_dissipates_the_film_runs_backwards(plain: dict[str, Any]) -> None:
    for entry in plain["effects"]:
        if "spring" in entry:
            entry["spring"]["damping"] = 0
    there = finished(plain)
    if there is None or events(there) > FEW or there.outcome.kind == "too-many-events":
        return
    if there.ledger.warmed > 1e-12 or there.record.events[0].t == 0.0:
        return  # an instant contact that came to rest under a force; a touch cut in two
    if 0.0 in there.scene.gaps and "instant" in str(plain["contact"]):
        return  # the film would end with an impact
    if list(there.x) != sorted(there.x):
        return  # bumpers so soft that centres have passed each other: another row
    carts = {
        cart.name: plain["carts"][cart.name] | {"position": repr(x), "velocity": repr(-v)}
        for cart, x, v in zip(there.scene.carts, there.x, there.v, strict=True)
    }
    back = finished(plain | {"carts": carts, "start": {"overlap": True}})
    if back.outcome.kind == "too-many-events":
        return
    start = there.scene.carts
    grown = 1e-6 * max(1.0, *map(abs, there.v))  # magnets may throw a light cart very far
    assert [-v for v in back.v] == pytest.approx([cart.velocity for cart in start], abs=grown)
    assert list(back.x) == pytest.approx([cart.position for cart in start], abs=grown)


# Units: 1 kg is written as 2, 1 m as 4, 1 s as 4. Speeds keep their number.
KILOGRAM, METRE, SECOND = Decimal(2), Decimal(4), Decimal(4)
UNIT = {
    "mass": KILOGRAM,
    "position": METRE,
    "length": METRE,
    "stiffness": KILOGRAM / SECOND**2,
    "damping": KILOGRAM / SECOND,
    "linear": KILOGRAM / SECOND,
    "quadratic": KILOGRAM / METRE,
    "force": KILOGRAM * METRE / SECOND**2,
    "energy": KILOGRAM * METRE**2 / SECOND**2,
    "from": SECOND,
    "until": SECOND,
    "at": SECOND,
}


def in_other_units(value: Any) -> Any:
    """Exact: the factors are powers of two."""
    if isinstance(value, dict):
        return {
            key: str(Decimal(str(item)) * UNIT[key])
            if key in UNIT and not isinstance(item, dict)
            else in_other_units(item)
            for key, item in value.items()
        }
    return [in_other_units(item) for item in value] if isinstance(value, list) else value


def in_both_units(plain: dict[str, Any]) -> tuple[Any, Any]:
    plain = plain | {
        "carts": {name: cart | {"length": "0.2"} for name, cart in plain["carts"].items()}
    }
    other = in_other_units(plain) | {"gravity": str(Decimal("9.81") * METRE / SECOND**2)}
    return finished(plain), finished(other)


@given(acted_on(("friction", "incline", "push", "spring", "release"), most=2))
def test_other_units_give_the_same_run_to_the_last_bit(plain: dict[str, Any]) -> None:
    """Powers of two only move the exponent of a float."""
    one, two = in_both_units(plain)
    if events(one) > FEW:
        return
    assert one.v == two.v
    assert tuple(x * float(METRE) for x in one.x) == two.x
    assert one.ledger.warmed * 2 == two.ledger.warmed


@FEWER
@given(acted_on(("drag",), most=2))
def test_drag_in_other_units_gives_the_same_run_to_rounding(plain: dict[str, Any]) -> None:
    """Logarithms and exponentials of drag may round anew."""
    one, two = in_both_units(plain)
    if events(one) > FEW:
        return
    assert list(two.v) == pytest.approx(list(one.v), abs=1e-12)
    assert two.ledger.warmed == pytest.approx(one.ledger.warmed * 2, abs=1e-12)
