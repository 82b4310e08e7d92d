"""The paper's tables, read from the files beside the evidence page."""

from __future__ import annotations

from pathlib import Path

from sim.classroom.paper import later, laws

EVIDENCE = Path(__file__).parents[3] / "docs" / "evidence"


def text(name: str) -> str:
    return (EVIDENCE / name).read_text(encoding="utf-8")


TABLE_2 = laws(text("table-2.csv"), text("table-2-printed.csv"))
TABLE_3 = later(text("table-3.csv"))
