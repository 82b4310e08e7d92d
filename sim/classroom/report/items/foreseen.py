"""One thing that an author foresaw in the answers to a question, and who gave it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sim.classroom.report.marked import Answer


@dataclass(frozen=True, slots=True)
class Foreseen:
    """An option, a wrong number, a line of a diagram. `option` names it in files, `label` and
    `text` are for people; `belief` is the tag of what those who give it often think."""

    option: str
    label: str
    gave: Sequence[Answer]
    belief: str = ""
    text: str = ""
    correct: bool = False
