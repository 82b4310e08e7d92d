"""What the page of `boot_site` says of its start, and the index of its runtime, to be changed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

RUNTIME = Path("assets") / "carts" / "runtime"
TOLD_WITHIN = 10_000  # ms, promised to the reader
HURRY = 3


def hurried(times: int) -> str:
    """A script after which the clocks of a page, by which it waits for Python, count seconds that
    are so many times as short. Python's own are as long as ever."""
    return f"""((count) => {{
  window.setInterval = (call, ms) => count(call, ms / {times});
}})(window.setInterval);
"""


HURRIED = hurried(HURRY)


def booted(page: Any) -> dict[str, Any]:
    return dict(page.evaluate("window.booted"))


def scripts(site: Path, name: str) -> list[Path]:
    return sorted((site / RUNTIME).glob(f"{name}.*.js"))


def read_index(site: Path) -> dict[str, Any]:
    text = (site / RUNTIME / "index.js").read_text(encoding="utf-8")
    return dict(json.loads(text.partition("=")[2].rstrip().rstrip(";")))


def write_index(site: Path, index: dict[str, Any]) -> None:
    text = f"self.__cartsRuntime = {json.dumps(index)};\n"
    (site / RUNTIME / "index.js").write_text(text, encoding="utf-8")
