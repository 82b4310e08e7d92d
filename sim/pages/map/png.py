"""A picture with few colours as a PNG file: signature, header, palette, packed rows, end."""

from __future__ import annotations

import struct
import zlib
from base64 import b64encode
from collections.abc import Sequence

SIGNATURE = b"\x89PNG\r\n\x1a\n"
EIGHT_BITS, BY_PALETTE = 8, 3


def png(width: int, pixels: bytes, palette: Sequence[Sequence[int]]) -> bytes:
    """`pixels`: places in the palette (red, green, blue), row after row from the top."""
    rows = [pixels[k : k + width] for k in range(0, len(pixels), width)]
    header = struct.pack(">IIBBBBB", width, len(rows), EIGHT_BITS, BY_PALETTE, 0, 0, 0)
    no_filter = b"\0"
    packed = b"".join(no_filter + row for row in rows)
    colours = bytes(part for colour in palette for part in colour)
    return SIGNATURE + b"".join(
        (
            _chunk(b"IHDR", header),
            _chunk(b"PLTE", colours),
            _chunk(b"IDAT", zlib.compress(packed, 9)),
            _chunk(b"IEND", b""),
        )
    )


def data_url(file: bytes) -> str:
    """The file inside an address."""
    return f"data:image/png;base64,{b64encode(file).decode('ascii')}"


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
