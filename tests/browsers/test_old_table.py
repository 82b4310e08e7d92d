"""Which browsers do what is told in one way: as it was seen."""

from __future__ import annotations

import json
import re
from pathlib import Path

from .old.binaries import PACKAGES
from .old.table import SEEN, table

ROOT = Path(__file__).parents[2]
SEEN_NOW = json.loads(SEEN.read_text(encoding="utf-8"))
# Wherever a reader is told which browser to take.
TELLING = (
    "docs/teachers/index.md", "docs/developers/runtime.md", "sim/pages/offline/open_me.py",
    "sim/web/src/runtime/failure.js", "sim/web/src/class-main.js", "sim/web/src/measured-main.js",
)  # fmt: skip


def test_the_docs_hold_the_table_of_old_browsers_as_it_was_seen_last() -> None:
    assert table(SEEN_NOW) in (ROOT / TELLING[0]).read_text(encoding="utf-8")
    assert [int(version) for version in SEEN_NOW] == list(PACKAGES)


def test_everybody_is_told_the_oldest_chrome_in_which_python_was_seen_live() -> None:
    oldest = min(int(version) for version, its in SEEN_NOW.items() if its["live"])
    for name in TELLING:
        told = re.findall(r"Chrome or Edge (\d+)", (ROOT / name).read_text(encoding="utf-8"))
        assert set(told) == {str(oldest)}, name


def test_no_old_browser_is_silent() -> None:
    """Where Python is not live something says why, and answers are kept or the fields closed."""
    assert all(its["live"] or its["told"] for its in SEEN_NOW.values())
