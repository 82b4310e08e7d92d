"""The key of a form on paper, for the teacher: right answers, why, and the rubrics.

It is made from the key files that the teacher has dropped; of what students can practise with no
rubric is ever in a page.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sim.classroom.files.keyed import KeyedForm, KeyedItem
from sim.classroom.handouts.answered import right_words
from sim.classroom.handouts.wording import FORMS
from sim.classroom.report.marked import lesson_title
from sim.classroom.show.html_parts import Tell, text
from sim.classroom.show.prose import prose
from sim.lesson.kinds.arrange import Matching
from sim.scene.said import counted, said, template


def key_html(keys: Sequence[KeyedForm], tell: Tell) -> str:
    """A page for each form."""
    return f'<div class="carts-sheets">{"".join(_form(form, tell) for form in keys)}</div>'


def _form(form: KeyedForm, tell: Tell) -> str:
    name = f"{text(lesson_title(form.lesson, (form,)))} · {tell(FORMS[form.form])}"
    worth = sum(item.worth for item in form.items.values())
    marks = tell(counted("1 mark in all", "{n} marks in all", n=worth))
    rows = "".join(f"<li>{'<br>'.join(_item(item, tell))}</li>" for item in form.items.values())
    head = f"<header><h2>{name}</h2><span>{marks}</span></header>"
    return f'<section class="carts-sheet">{head}<ol>{rows}</ol></section>'


def _item(item: KeyedItem, tell: Tell) -> Iterator[str]:
    """The question, what is right and why, and what each mark is given for."""
    yield text(prose(item.ask))
    if right := _right(item):
        yield f"<b>{tell(said('Right: {answer}', answer=prose(right)))}</b>"
    for marks, words in item.rubric.items():
        yield f"<b>{text(marks)}</b> {text(prose(words))}"
    if why := item.question.common.explain:
        yield f"<i>{text(prose(why))}</i>"
    if item.optional:
        yield tell(template("optional: it gives no marks"))


def _right(item: KeyedItem) -> str:
    question = item.question
    if isinstance(question, Matching):
        pairs = zip(question.left, question.right, strict=False)
        return "; ".join(f"{left} – {right}" for left, right in pairs)
    return right_words(item)
