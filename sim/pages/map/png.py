"""A picture with few colours as a PNG file: signature, header, palette, packed rows, end."""

from __future__ import annotations

import struct
import zlib
from base64 import b64encode
from collections.abc import Sequence
from typing import TYPE_CHECKING

from sim.pages.map.palette import Colour

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

SIGNATURE = b"\x89PNG\r\n\x1a\n"
EIGHT_BITS, BY_PALETTE = 8, 3


def png(pixels: NDArray[np.uint8], palette: Sequence[Colour]) -> bytes:
    """`pixels`: places in the palette, row after row from the top."""
    rows, columns = pixels.shape
    header = struct.pack(">IIBBBBB", columns, rows, EIGHT_BITS, BY_PALETTE, 0, 0, 0)
    no_filter = b"\0"
    packed = b"".join(no_filter + row.tobytes() for row in pixels)
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
