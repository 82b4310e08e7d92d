"""Mistakes in questions, forms and banks; a single mistake is a `Problem`, as in scenes."""

from __future__ import annotations

from sim.scene.problem import DescriptionError, Problem

__all__ = ["LessonError", "Problem"]


class LessonError(DescriptionError):
    """Of a question, a form or a bank."""
