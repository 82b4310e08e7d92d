"""Texts of a scene that a page shows as they are typed: a formula in one would be backslashes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.lesson.kinds.unformatted import unformatted
from sim.scene import Problem


def as_typed(plain: Mapping[str, Any]) -> list[Problem]:
    """One for the title, and for each text of the prediction, that has marks of Markdown in it."""
    problems: list[Problem] = []
    unformatted(plain, (), problems, ("title",))
    if isinstance(predict := plain.get("predict"), Mapping):
        unformatted(predict, ("predict",), problems, ("ask", "choice", "text"))
    return problems
