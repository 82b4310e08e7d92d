"""Numbers that YAML reads otherwise than people write them: `1:30` is 90, `010` is 8."""

from __future__ import annotations

import re

WHOLE = re.compile(r"[+-]?(0|[1-9][0-9]*)")
_OTHER_BASE = re.compile(r"[+-]?0[xXoObB0-9][0-9a-fA-F]*")


def misread(text: str) -> tuple[str, str] | None:
    """Message and hint for what YAML takes for another number than it looks like."""
    if ":" in text:
        hint = f'write the seconds: 90 s; a ratio goes in quotes: "{text}"'
        return f"YAML reads {text} as a number to base 60", hint
    if "_" in text:
        return f"{text} has an underscore in it", f"write {text.replace('_', '')}"
    if _OTHER_BASE.fullmatch(text) and not WHOLE.fullmatch(text):
        hint = "write it with the digits 0 to 9, without a zero in front"
        return f"YAML does not read {text} as an ordinary number", hint
    return None
