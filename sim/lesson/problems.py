"""Mistakes in questions, forms and banks; a single mistake is a `Problem`, as in scenes."""

from __future__ import annotations

from collections.abc import Iterable

from sim.scene.problem import Problem, first_causes

__all__ = ["LessonError", "Problem"]


class LessonError(ValueError):
    """A description that cannot be used. Carries every problem found, never none."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = first_causes(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))
