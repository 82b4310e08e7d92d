"""Numbers of a report by their names."""

from __future__ import annotations

import pytest

from sim.bridge.end_state import read


@pytest.mark.parametrize(
    ("what", "value"),
    [
        ("v.A", 1.0),
        ("v.cart-1", 4.0),
        ("v.cart-1-A", 3.0),
        ("v.A-cart-1", -3.0),
        ("v.cart-2-cart-1", 5.0),
        ("v.A+cart-1+cart-2", 14.0),
    ],
)
def test_a_cart_may_have_a_hyphen_in_its_name(what: str, value: float) -> None:
    assert read({"final": {"v": {"A": 1.0, "cart-1": 4.0, "cart-2": 9.0}}}, what) == value
