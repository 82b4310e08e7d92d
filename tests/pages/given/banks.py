"""Banks of questions to write for other programs."""

from __future__ import annotations

from pathlib import Path

from sim.lesson.bank import Bank
from sim.pages.question.quiz import read_bank_text
from tests.conftest import ROOT

OWN = ROOT / "worksheets" / "banks" / "forces-and-motion.yml"


def read(path: Path) -> Bank:
    bank, findings = read_bank_text(path.read_text(encoding="utf-8"), path.name)
    assert bank is not None, findings
    return bank
