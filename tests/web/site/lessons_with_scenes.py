"""The lessons of this project that have a scene."""

from __future__ import annotations

from sim.pages.text.lesson_list import lessons_in
from tests.conftest import ROOT

LESSONS = [
    path.stem for path in lessons_in(ROOT / "worksheets")
    if path.parent.name == "worksheets" and "```scene" in path.read_text(encoding="utf-8")
]  # fmt: skip
