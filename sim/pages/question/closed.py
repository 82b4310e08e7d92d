"""A form whose last day is over: nobody can answer it, which its author sees only in the page."""

from __future__ import annotations

from datetime import date

from sim.pages.findings import Finding
from sim.pages.question.quiz import QuizBlock
from sim.scene.problem import Problem

CODE = "closed-already"


def closed_already(quiz: QuizBlock, today: date | None = None) -> list[Finding]:
    """A hint where `close` lies before today: with a new class a lesson keeps last year's date."""
    last = quiz.form.close.date
    if not last or last >= (today or date.today()).isoformat():
        return []
    told = (
        f"this form closed on {last}: nobody can answer it any more; close: {{date: a later day}}"
    )
    return [quiz.places.finding(Problem(("close", "date"), CODE, "")).as_hint(told)]
