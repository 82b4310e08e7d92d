"""Numbers with units: one place converts, exactly; everything else is refused with a hint."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from sim.scene import quantity
from sim.scene.quantity import QuantityError, read_quantity


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("0.5 kg", quantity.MASS, "1/2"),
        ("500 g", quantity.MASS, "1/2"),
        ("500g", quantity.MASS, "1/2"),
        ("20 cm", quantity.LENGTH, "1/5"),
        ("2 km/h", quantity.SPEED, "5/9"),
        ("−0.5 m/s", quantity.SPEED, "-1/2"),
        ("1e9", quantity.MASS, "1000000000"),
        ("+3.", quantity.LENGTH, "3"),
        (".25", quantity.LENGTH, "1/4"),
        ("0.5 mm/s", quantity.SPEED, "1/2000"),
        ("30 %", quantity.RATIO, "3/10"),
        ("5 \u00b5m", quantity.LENGTH, "1/200000"),
        ("5 \u03bcm", quantity.LENGTH, "1/200000"),
        ("4 N/cm", quantity.STIFFNESS, "400"),
        ("2 min", quantity.TIME, "120"),
        ("9.81 m s⁻²", quantity.ACCELERATION, "981/100"),
        ("9.81 m s^-2", quantity.ACCELERATION, "981/100"),
        ("981 cm/s²", quantity.ACCELERATION, "981/100"),
        ("9.81 m/s/s", quantity.ACCELERATION, "981/100"),
        ("6×10⁻¹ m s⁻¹", quantity.SPEED, "3/5"),
        ("6 x 10^-1 m/s", quantity.SPEED, "3/5"),
        ("1e6 N m^-1.5", quantity.HERTZ_STIFFNESS, "1000000"),
        (0.1, quantity.LENGTH, "1/10"),
        (7, quantity.LENGTH, "7"),
    ],
)
def test_a_quantity_is_the_exact_number_its_text_names(text, dimension, value):
    assert read_quantity(text, dimension) == Fraction(value)


INCH = Fraction("0.0254")
SIZES = {
    "kg": 1, "g": "1e-3", "mg": "1e-6", "t": 1000, "m": 1, "cm": "1e-2", "mm": "1e-3", "km": 1000,
    "\u00b5m": "1e-6", "dm": "0.1", "in": INCH, "ft": 12 * INCH, "m/s": 1, "cm/s": "1e-2",
    "mm/s": "1e-3", "km/h": Fraction(1000, 3600), "km/s": 1000, "s": 1, "ms": "1e-3",
    "\u00b5s": "1e-6", "ns": "1e-9", "min": 60, "h": 3600, "N": 1, "mN": "1e-3", "kN": 1000,
    "N/m": 1, "N/cm": 100, "N/mm": 1000, "kN/m": 1000, "N/m^1.5": 1, "N/m^(3/2)": 1, "m/s²": 1,
    "N/kg": 1, "cm/s²": "1e-2", "mm/s²": "1e-3", "rad": 1, "deg": math.radians(1),
    "°": math.radians(1), "J": 1, "mJ": "1e-3", "kJ": 1000, "kg/s": 1, "g/s": "1e-3", "N s/m": 1,
    "N·s/m": 1, "kg/m": 1, "g/m": "1e-3", "%": "1e-2",
}  # fmt: skip
"""Every unit in SI, by hand."""


def test_every_unit_is_as_large_as_it_is_in_si():
    dimensions = [kind for kind in vars(quantity).values() if isinstance(kind, quantity.Dimension)]
    units = {(unit, kind) for kind in range(len(dimensions)) for unit in dimensions[kind].units}
    assert {unit for unit, _ in units} == set(SIZES)
    for unit, kind in units:
        assert read_quantity(f"2 {unit}", dimensions[kind]) == 2 * Fraction(SIZES[unit]), unit


@pytest.mark.parametrize(
    ("value", "code"),
    [
        ("0.5 m", "wrong-unit"),
        ("0.5 Kg", "wrong-unit"),
        ("0,5 kg", "not-a-number"),
        ("1,000", "not-a-number"),
        ("1.000,5", "not-a-number"),
        ("heavy", "not-a-number"),
        ("", "not-a-number"),
        ("1_000", "not-a-number"),
        ("0x10", "wrong-unit"),
        ("1:30", "wrong-unit"),
        ("١٢", "not-a-number"),
        ("９", "not-a-number"),
        ("NaN", "not-finite"),
        ("-inf", "not-finite"),
        (float("nan"), "not-finite"),
        (float("inf"), "not-finite"),
        ("1e309", "out-of-range"),
        ("1e-320", "out-of-range"),
        ("1e99999", "not-a-number"),
        ("9" * 1_000_000, "not-a-number"),
        (True, "not-a-number"),
        (None, "not-a-number"),
        ([1], "not-a-number"),
        ({"kg": 1}, "not-a-number"),
    ],
)
def test_anything_else_is_refused_with_a_hint(value, code):
    with pytest.raises(QuantityError) as caught:
        read_quantity(value, quantity.MASS)
    assert caught.value.code == code or code in ("not-a-number", "wrong-unit")
    assert caught.value.hint
    assert len(caught.value.message) < 120
