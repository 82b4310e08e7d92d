"""What tests of the packed runtime read: its index; and a report that nobody hears."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any


def quiet(_: str) -> None:
    pass


def read_index(folder: Path) -> dict[str, Any]:
    text = (folder / "index.js").read_text(encoding="utf-8")
    return dict(json.loads(text.partition("=")[2].rstrip().rstrip(";")))
