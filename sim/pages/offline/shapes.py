"""The site's sign, two carts that push each other, as shapes; and shapes as SVG and as PNG.

The PNGs are made here, without a picture library: coverage of each pixel from SUB lines within it.
"""

from __future__ import annotations

import math
import struct
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

Colour = tuple[int, int, int]
Point = tuple[float, float]

BLUE: Colour = (0x1D, 0x4E, 0x79)
PAPER: Colour = (0xFF, 0xFF, 0xFF)
A: Colour = (0x5C, 0xB6, 0xF2)
B: Colour = (0xFF, 0x91, 0x57)
SUB = 4  # lines of sampling per pixel; a power of two, so that sums are exact


@dataclass(frozen=True, slots=True)
class Polygon:
    """A convex polygon in a square of side 1; y points down."""

    colour: Colour
    points: tuple[Point, ...]

    def span(self, y: float) -> tuple[float, float] | None:
        """From where to where it covers the line at y."""
        crossed = []
        for (x0, y0), (x1, y1) in zip(self.points, self.points[1:] + self.points[:1], strict=True):
            if (y0 <= y) != (y1 <= y):
                crossed.append(x0 + (y - y0) / (y1 - y0) * (x1 - x0))
        return (min(crossed), max(crossed)) if crossed else None

    def svg(self) -> str:
        """The element, in a picture of 100 by 100."""
        listed = " ".join(f"{100 * x:g},{100 * y:g}" for x, y in self.points)
        return f'<polygon fill="{hexa(self.colour)}" points="{listed}"/>'


@dataclass(frozen=True, slots=True)
class Disc:
    """A filled circle."""

    colour: Colour
    x: float
    y: float
    r: float

    def span(self, y: float) -> tuple[float, float] | None:
        """From where to where it covers the line at y."""
        square = self.r**2 - (y - self.y) ** 2
        return (self.x - math.sqrt(square), self.x + math.sqrt(square)) if square > 0 else None

    def svg(self) -> str:
        """The element, in a picture of 100 by 100."""
        place = f'cx="{100 * self.x:g}" cy="{100 * self.y:g}" r="{100 * self.r:g}"'
        return f'<circle fill="{hexa(self.colour)}" {place}/>'


Shape = Polygon | Disc


def hexa(colour: Colour) -> str:
    """A colour as CSS writes it."""
    return "#{:02x}{:02x}{:02x}".format(*colour)


def sign() -> tuple[Shape, ...]:
    """Two carts in contact on a track, and the two equal forces."""
    return (
        _box(PAPER, 0.14, 0.705, 0.86, 0.725),
        _box(A, 0.20, 0.48, 0.49, 0.64),
        _box(B, 0.51, 0.40, 0.80, 0.64),
        *(Disc(PAPER, x, 0.655, 0.045) for x in (0.275, 0.415, 0.585, 0.725)),
        *_arrow(A, 0.49, 0.30, -0.24),
        *_arrow(B, 0.51, 0.30, 0.24),
    )


def _box(colour: Colour, left: float, top: float, right: float, bottom: float) -> Polygon:
    return Polygon(colour, ((left, top), (right, top), (right, bottom), (left, bottom)))


def _arrow(colour: Colour, x: float, y: float, size: float) -> Iterator[Shape]:
    neck = x + 0.62 * size
    yield _box(colour, min(x, neck), y - 0.02, max(x, neck), y + 0.02)
    yield Polygon(colour, ((neck, y - 0.065), (x + size, y), (neck, y + 0.065)))


def svg(shapes: Sequence[Shape], ground: Colour = BLUE) -> str:
    """A square picture, with round corners."""
    frame = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">'
    corner = f'<rect width="100" height="100" rx="18" fill="{hexa(ground)}"/>'
    return "".join([frame, corner, *(shape.svg() for shape in shapes), "</svg>\n"])


@cache
def png(shapes: tuple[Shape, ...], width: int, height: int, scale: float = 1) -> bytes:
    """The shapes in the middle of a picture of `width` by `height` pixels; `scale` 1 fills it."""
    side = scale * min(width, height)
    left, top = (width - side) / 2, (height - side) / 2
    rows = []
    for y in range(height):
        row = bytearray(bytes(BLUE) * width)
        for shape in shapes:
            spans = [shape.span((y + (k + 0.5) / SUB - top) / side) for k in range(SUB)]
            _paint(row, [(left + side * a, left + side * b) for a, b in filter(None, spans)], shape)
        rows.append(b"\0" + row)
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    body = zlib.compress(b"".join(rows), 9)
    parts = _chunk(b"IHDR", head), _chunk(b"IDAT", body), _chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def _paint(row: bytearray, spans: list[tuple[float, float]], shape: Shape) -> None:
    if not spans:
        return
    first, last = math.floor(min(a for a, _ in spans)), math.ceil(max(b for _, b in spans))
    first, last = max(0, first), min(len(row) // 3, last)
    whole, rest = first, first  # pixels in which every line is covered
    if len(spans) == SUB:
        whole = min(last, max(first, math.ceil(max(a for a, _ in spans))))
        rest = max(whole, min(last, math.floor(min(b for _, b in spans))))
        row[3 * whole : 3 * rest] = bytes(shape.colour) * (rest - whole)
    for x in (*range(first, whole), *range(rest, last)):
        covered = sum(max(0.0, min(b, x + 1) - max(a, x)) for a, b in spans) / SUB
        for k, wanted in enumerate(shape.colour):
            row[3 * x + k] = round(row[3 * x + k] + (wanted - row[3 * x + k]) * covered)


def _chunk(kind: bytes, content: bytes) -> bytes:
    check = zlib.crc32(kind + content)
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", check)
