"""What lies in a zip."""

from __future__ import annotations

import io
import zipfile


def in_zip(content: bytes) -> dict[str, bytes]:
    """Its files by their paths; every one is whole."""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        assert archive.testzip() is None
        return {name: archive.read(name) for name in archive.namelist()}
