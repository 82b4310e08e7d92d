"""Colours of the bands of a map, made in OKLab so that equal steps look equal.

From low to high: dark blue over green to light yellow, ever lighter. Around zero: blue for minus,
orange for plus, white at zero. Lightness alone tells the order, so the colours work for
colour-blind readers and on a printer without colours. OKLab: B. Ottosson, 2020.
"""

from __future__ import annotations

import math

Colour = tuple[int, int, int]

NONE: Colour = (176, 176, 176)
"""Where a map has no value."""

ZERO: Colour = (32, 32, 32)
"""The line of zero."""

EDGE = 0.72
"""A band's colour on its edge towards the next band, as a part of its own: the contour line."""


def sequential(count: int) -> list[Colour]:
    """From low to high."""
    return [_along(k / max(1, count - 1)) for k in range(count)]


def diverging(centres: list[float]) -> list[Colour]:
    """For bands with these centres, some below and some above zero: equal size, equal lightness."""
    far = max(abs(c) for c in centres)
    return [_side(c / far) for c in centres]


def edge(colour: Colour) -> Colour:
    """Of the contour line on a band."""
    red, green, blue = (round(EDGE * part) for part in colour)
    return red, green, blue


def _along(t: float) -> Colour:
    return _oklch(0.30 + 0.64 * t, 0.09 + 0.05 * math.sin(math.pi * t), 268.0 - 165.0 * t)


def _side(t: float) -> Colour:
    size = abs(t)
    return _oklch(0.97 - 0.47 * size, 0.145 * size, 250.0 if t < 0 else 52.0)


def _oklch(lightness: float, chroma: float, hue: float) -> Colour:
    """sRGB of a colour in OKLCH; hue in degrees."""
    a, b = chroma * math.cos(math.radians(hue)), chroma * math.sin(math.radians(hue))
    long = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3
    middle = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3
    short = (lightness - 0.0894841775 * a - 1.2914855480 * b) ** 3
    return (
        _channel(4.0767416621 * long - 3.3077115913 * middle + 0.2309699292 * short),
        _channel(-1.2684380046 * long + 2.6097574011 * middle - 0.3413193965 * short),
        _channel(-0.0041960863 * long - 0.7034186147 * middle + 1.7076147010 * short),
    )


def _channel(linear: float) -> int:
    linear = min(1.0, max(0.0, linear))
    coded = 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055
    return round(255 * coded)
