"""Numbers as text, for tables and scales. Ties round away from zero, as
JavaScript's `toFixed` does. A real minus sign; never “−0”.
"""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, Decimal

from sim.scene.notation import SUPERSCRIPT

MINUS = "−"
MAX_DECIMALS = 12
SLOW = 0.01  # m/s; scenes with no greater speed speak of mm/s


def exponent(value: float) -> int:
    """The power of ten of the first digit of `value`; 0 for 0."""
    return int(f"{abs(value):.16e}".split("e")[1]) if value else 0


def fixed(value: float, decimals: int) -> str:
    """`value` with so many decimals, for example 0.60 or −1.25."""
    step = Decimal(1).scaleb(-decimals)
    text = format(Decimal(abs(value)).quantize(step, rounding=ROUND_HALF_UP), "f")
    return MINUS + text if value < 0 and text.strip("0.") else text


def decimals_for(scale: float, figures: int = 3) -> int:
    """Decimals that show a value as large as `scale` with so many figures."""
    return min(MAX_DECIMALS, max(0, figures - 1 - exponent(scale)))


def short(value: float, figures: int = 3) -> str:
    """At most so many figures, without trailing zeros: 0.5, 1.25, 2, 1.5 × 10⁹."""
    power = exponent(value)
    if value and not -4 < power < 6:
        mantissa = _trim(fixed(value / float(f"1e{power}"), figures - 1))
        if mantissa.endswith("10"):  # 9.999 is 1.00 of the next power
            mantissa, power = mantissa[:-1], power + 1
        return f"{mantissa} × 10{str(power).translate(SUPERSCRIPT)}"
    return _trim(fixed(value, max(0, figures - 1 - power)))


def speed_unit(scale: float) -> tuple[float, str]:
    """The unit of all velocities of a scene with that greatest speed: m/s in it, and its name."""
    return (0.001, "mm/s") if scale <= SLOW else (1.0, "m/s")


def _trim(text: str) -> str:
    return text.rstrip("0").rstrip(".") if "." in text else text


def px(value: float, decimals: int = 1) -> str:
    """A drawing coordinate: rounded to tenths, shortest form."""
    factor = float(10**decimals)
    rounded = math.floor(value * factor + 0.5) / factor
    return str(int(rounded)) if rounded == int(rounded) else repr(rounded)


def plain(value: float) -> str:
    """A number for an HTML attribute: shortest form, no exponent for whole numbers."""
    return str(int(value)) if value == int(value) and abs(value) < 1e15 else repr(float(value))
