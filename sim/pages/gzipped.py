"""gzip that is the same on every machine: without a time, and without the name of the system."""

from __future__ import annotations

import gzip

_SYSTEM = 9  # the byte of the header that names it; Python 3.13 writes another than 3.12
_UNKNOWN = b"\xff"


def gzipped(content: bytes) -> bytes:
    """The bytes, packed as small as gzip can."""
    packed = gzip.compress(content, compresslevel=9, mtime=0)
    return packed[:_SYSTEM] + _UNKNOWN + packed[_SYSTEM + 1 :]
