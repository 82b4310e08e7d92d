"""How a QTI item is marked and what it says then: response processing and modal feedback.

A mark is given as a whole, as in the pages. Of feedback that fits more than one answer, the first
known one is shown; the explanation comes after any answer.
"""

from __future__ import annotations

from dataclasses import dataclass

from sim.lesson.kinds.number import NEAR
from sim.pages.classroom.portable import Portable
from sim.pages.classroom.qti.xhtml import blocks, xml_text

_RESPONSE = '<qti-variable identifier="RESPONSE"/>'


@dataclass(frozen=True, slots=True)
class Processing:
    """`feedback`: cardinality of its outcome, empty where there is none; `shown`: its texts."""

    rules: str
    shown: tuple[str, ...]
    feedback: str


def processing(q: Portable) -> Processing:
    """Rules and texts of a question; an essay that says nothing has no rules."""
    said = _said(q)
    rules = [] if q.shape == "essay" else _rules(q, said)
    texts = [_modal("FEEDBACK", name, html) for name, html, _ in said]
    if q.explain:
        rules.append(_condition([(_not(_null()), _set("EXPLAIN", _name("explain")))]))
        texts.append(_modal("EXPLAIN", "explain", q.explain))
    whole = ["<qti-response-processing>", *rules, "</qti-response-processing>"] if rules else []
    kinds = ("multiple" if q.shape == "choices" else "single") if said else ""
    return Processing("\n".join(whole), tuple(texts), kinds)


def _said(q: Portable) -> list[tuple[str, str, str]]:
    """Feedback: its name, its text, and the test of an answer (empty: the choice of that name)."""
    if q.shape in ("choice", "choices"):
        return [(f"C{k}", html, "") for k, (_, _, html) in enumerate(q.answers, 1) if html]
    if q.shape == "short":
        return [(f"W{k}", html, _same_text(text))
                for k, (text, _, html) in enumerate(q.answers, 1) if html]  # fmt: skip
    return [(f"W{k}", html, _near(value, tolerance))
            for k, (value, tolerance, html) in enumerate(q.wrong_numbers, 1) if html]  # fmt: skip


def _rules(q: Portable, said: list[tuple[str, str, str]]) -> list[str]:
    """Marks, and the feedback on what was answered; a right number or text has none."""
    known = [(test, _set("FEEDBACK", _name(name))) for name, _, test in said]
    answered = _not(_null())
    if q.shape == "short":
        marked = _set("SCORE", '<qti-map-response identifier="RESPONSE"/>')
        return [_condition([(answered, marked)]), *([_condition(known)] if known else [])]
    marks = _set("SCORE", f'<qti-base-value base-type="float">{q.marks}</qti-base-value>')
    if q.shape == "number":
        return [_condition([(_near(*q.number), marks), *known])]
    right = f'<qti-match>{_RESPONSE}<qti-correct identifier="RESPONSE"/></qti-match>'
    chosen = [_condition([(answered, _set("FEEDBACK", _RESPONSE))])] if said else []
    return [_condition([(right, marks)]), *chosen]


def _condition(cases: list[tuple[str, str]]) -> str:
    """If, else if …: each a test and what is done."""
    made = [
        f"<qti-response-{'else-if' if k else 'if'}>{test}{done}"
        f"</qti-response-{'else-if' if k else 'if'}>"
        for k, (test, done) in enumerate(cases)
    ]
    return "<qti-response-condition>" + "".join(made) + "</qti-response-condition>"


def _near(value: float, tolerance: float) -> str:
    edge = tolerance * NEAR  # as here: what lies on the edge is inside, whatever its last bit
    return (
        f'<qti-equal tolerance-mode="absolute" tolerance="{edge!r} {edge!r}">{_RESPONSE}'
        f'<qti-base-value base-type="float">{value!r}</qti-base-value></qti-equal>'
    )


def _same_text(text: str) -> str:
    return (
        f'<qti-string-match case-sensitive="false">{_RESPONSE}'
        f'<qti-base-value base-type="string">{xml_text(text)}</qti-base-value></qti-string-match>'
    )


def _null() -> str:
    return f"<qti-is-null>{_RESPONSE}</qti-is-null>"


def _not(test: str) -> str:
    return f"<qti-not>{test}</qti-not>"


def _set(outcome: str, value: str) -> str:
    return f'<qti-set-outcome-value identifier="{outcome}">{value}</qti-set-outcome-value>'


def _name(name: str) -> str:
    return f'<qti-base-value base-type="identifier">{name}</qti-base-value>'


def _modal(outcome: str, name: str, html: str) -> str:
    return (
        f'<qti-modal-feedback outcome-identifier="{outcome}" identifier="{name}" show-hide="show">'
        f"<qti-content-body>{blocks(html)}</qti-content-body></qti-modal-feedback>"
    )
