"""Figures drawn when a site is built, by the page's own script: V8 from pip runs it.

`draw("scene", values)` gives the HTML that the page's script would make of the same values in the
same language. A context of V8 takes a tenth of a second to start, so there is one per language.
"""

from __future__ import annotations

import atexit
import json
import threading
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sim.pages.language import spoken

if TYPE_CHECKING:
    from py_mini_racer import MiniRacer

SCRIPT = Path(__file__).parents[1] / "web" / "dist" / "draw.js"
MISSING = (
    "Pictures are drawn by V8, and there is none for this machine (the package “mini-racer” has no "
    "wheel for it): build the site on Windows, macOS or Linux with a 64-bit processor."
)

_lock = threading.Lock()
_drawers: dict[int, tuple[Mapping[str, str], MiniRacer]] = {}


class DrawingError(Exception):
    """The script could not draw: a fault of the program, or no V8 for this machine."""


def draw(kind: str, values: Mapping[str, Any]) -> str:
    """The HTML of a figure in the language that is being written; raises DrawingError."""
    context = _drawer(spoken())
    text = json.dumps(values, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    try:
        return str(context.eval(f"cartsDraw({json.dumps(kind)}, {text})"))
    except Exception as error:
        if type(error).__module__.partition(".")[0] != "py_mini_racer":
            raise
        raise DrawingError(f"a figure ({kind}) could not be drawn: {error}") from error


def _drawer(words: Mapping[str, str]) -> MiniRacer:
    """V8 with the script, for readers of these words."""
    with _lock:
        if id(words) not in _drawers:
            _drawers[id(words)] = words, _started(words)
        return _drawers[id(words)][1]


def _started(words: Mapping[str, str]) -> MiniRacer:
    try:
        from py_mini_racer import MiniRacer, init_mini_racer

        init_mini_racer(ignore_duplicate_init=True)
    except (ImportError, OSError) as error:
        raise DrawingError(MISSING) from error
    # From a thread of its own: where an event loop runs, the context would wait for that one.
    with ThreadPoolExecutor(1) as pool:
        context = pool.submit(MiniRacer).result()
    atexit.register(context.close)  # else Python waits for V8's thread for ever
    context.eval(f"globalThis.cartsWords={json.dumps(dict(words), ensure_ascii=False)};")
    context.eval(SCRIPT.read_text(encoding="utf-8"))
    return context
