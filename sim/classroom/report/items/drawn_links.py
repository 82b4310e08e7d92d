"""Interaction diagrams of a class: which links were invented that the author knows, which left out.

Of links that nobody foresaw nothing is told: there are dozens in a diagram, and most are slips.
"""

from __future__ import annotations

from collections.abc import Sequence

from sim.classroom.report.items.foreseen import Foreseen
from sim.classroom.report.marked import Answer
from sim.lesson.kinds.interactions import Interactions
from sim.lesson.kinds.links import Known, Link
from sim.lesson.mark import is_empty
from sim.scene.said import said


def told_links(answers: Sequence[Answer], question: Interactions) -> list[Foreseen]:
    """Each known invented link, and each right link: who left it out."""
    drawn = [(a, links) for a in answers if (links := _links(a, question)) is not None]
    invented = [
        Foreseen(f"wrong-{k}", _any(known, question),
                 [a for a, links in drawn if known.fits(links)], known.belief)
        for k, known in enumerate(question.wrong, 1)
    ]  # fmt: skip
    return invented + [
        Foreseen(f"no-{link.name}", said("no line: {link}", link=_named(link, question)),
                 [a for a, links in drawn if link not in links])
        for link in question.links
    ]  # fmt: skip


def _links(answer: Answer, question: Interactions) -> set[Link] | None:
    """What was drawn; None where nothing was, or nothing that can be read."""
    return None if is_empty(answer.value) else question.drawn(answer.value)


def _any(known: Known, question: Interactions) -> str:
    """An invented link in words; the way is named where only that one is meant."""
    if len(known.by) == 1:
        return _named(Link(known.a, known.b, known.by[0]), question)
    return said("a line: {a} and {b}", a=question.objects[known.a], b=question.objects[known.b])


def _named(link: Link, question: Interactions) -> str:
    a, b = question.objects[link.a], question.objects[link.b]
    if link.by == "contact":
        return said("{a} and {b} touch", a=a, b=b)
    return said("{a} and {b}, without touching", a=a, b=b)
