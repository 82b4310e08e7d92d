"""Names that Windows gives to no file and no folder: what is made with one reaches no Windows."""

from __future__ import annotations

import re

_DEVICES = re.compile(r"(?:con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])\s*(?:\..*)?", re.IGNORECASE)


def why_not_on_windows(name: str) -> str:
    """Why such a name cannot be taken along, as a sentence; empty: it can."""
    if _DEVICES.fullmatch(name):
        return f"“{name}” is the name of a device on Windows, with any ending. Choose another name."
    if name not in (".", "..") and name.endswith((".", " ")):
        return f"“{name}” ends in a dot or a space, which Windows leaves out. Choose another name."
    return ""
