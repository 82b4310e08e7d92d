"""Figures drawn when a site is built, by the page's own script: V8 from pip runs it.

`draw("scene", values)` gives the HTML that the page's script would make of the same values in the
same language. V8 takes a tenth of a second to start, once; the script is read once per language,
since it looks its sentences up when it is read.
"""

from __future__ import annotations

import atexit
import json
import threading
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
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
_started: list[MiniRacer] = []
_formulas: list[Path] = []  # the script of KaTeX, once V8 has read it
_read: dict[int, Mapping[str, str]] = {}  # words that there is a script for, by their identity


class DrawingError(Exception):
    """The script could not draw: a fault of the program, or no V8 for this machine."""


def draw(kind: str, values: Mapping[str, Any]) -> str:
    """The HTML of a figure in the language that is being written; raises DrawingError."""
    text = json.dumps(values, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return _drawn(kind, text, _Language(spoken()))


@dataclass(frozen=True, eq=False, slots=True)
class _Language:
    """The words of a language; the same mapping is the same language."""

    words: Mapping[str, str]

    def __hash__(self) -> int:
        return id(self.words)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Language) and self.words is other.words


@lru_cache(maxsize=128)  # the scenes of the lesson that is being edited, in its languages
def _drawn(kind: str, text: str, language: _Language) -> str:
    with _lock:
        v8, words = _v8(), language.words
        try:
            if id(words) not in _read:
                v8.eval(f"globalThis.cartsWords={json.dumps(dict(words), ensure_ascii=False)};")
                v8.eval(SCRIPT.read_text(encoding="utf-8"))
                v8.eval(f"globalThis.cartsDraw{id(words)} = cartsDraw;")
                _read[id(words)] = words  # kept: another mapping must not get its identity
            return str(v8.eval(f"cartsDraw{id(words)}({json.dumps(kind)}, {text})"))
        except Exception as error:
            if type(error).__module__.partition(".")[0] != "py_mini_racer":
                raise
            raise DrawingError(f"a figure ({kind}) could not be drawn: {error}") from error


@lru_cache(maxsize=4096)  # one formula stands on pages of several languages
def draw_formula(tex: str, *, display: bool, katex: Path) -> str:
    """The HTML of a formula, with MathML for those who do not see it; `katex`: its script."""
    with _lock:
        v8 = _v8()
        if not _formulas:
            v8.eval(katex.read_text(encoding="utf-8"))
            _formulas.append(katex)
        options = json.dumps({"displayMode": display, "throwOnError": False})
        return str(v8.eval(f"katex.renderToString({json.dumps(tex)}, {options})"))


def _v8() -> MiniRacer:
    if not _started:
        try:
            from py_mini_racer import MiniRacer, init_mini_racer

            init_mini_racer(ignore_duplicate_init=True)
        except (ImportError, OSError) as error:
            raise DrawingError(MISSING) from error
        # From a thread of its own: where an event loop runs, V8 would wait for that one.
        with ThreadPoolExecutor(1) as pool:
            _started.append(pool.submit(MiniRacer).result())
        atexit.register(_started[0].close)  # else Python waits for V8's thread for ever
    return _started[0]
