"""Slips as HTML: one for each student, four on a sheet of A4, to be cut and handed out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sim.classroom.handouts.slip import FormSlip, Given, Look, Slip
from sim.classroom.handouts.wording import FORMS, cut
from sim.classroom.report.flags.times import moment_of
from sim.classroom.report.numerals import numbers
from sim.classroom.show.html_parts import Tell, text, who
from sim.scene.said import counted, said, template

SHORT = 110
"""Characters of a question: two lines of a slip. Its number stands before it."""

LOOK = template("Look at these again")
UNANSWERED = template(
    "Nothing is answered in this file. If you did answer, hand in the file with your answers."
)


def slips_html(found: Sequence[Slip], tell: Tell, *, answers: bool = False) -> str:
    """All slips. `answers`: with the right answers and why; else only what helps to find them."""
    each = "".join(_slip(slip, tell, answers=answers) for slip in found)
    return f'<div class="carts-slips">{each}</div>'


def _slip(slip: Slip, tell: Tell, *, answers: bool) -> str:
    parts = "".join(_form(form, tell, answers=answers) for form in slip.forms)
    nobody = said("no code word ({file})", file=slip.file)
    name = who(slip.student) if slip.student else tell(nobody)
    return (
        f'<article class="carts-slip"><header><b>{name}</b>'
        f"<span>{text(slip.title)}</span></header>{parts}"
        f"<footer>{tell(template('From your teacher:'))}</footer></article>"
    )


def _form(form: FormSlip, tell: Tell, *, answers: bool) -> str:
    head = f"<h3>{tell(FORMS[form.form])} <small>{text(day_of(form.saved))}</small></h3>"
    return head + "".join(_lines(form, tell, answers=answers))


def day_of(saved: str) -> str:
    """The day here of a moment that a file tells in UTC: in Singapore a lesson at 7:30 is still of
    the day before there."""
    moment = moment_of(saved)
    try:
        return f"{moment.astimezone():%Y-%m-%d}" if moment else saved[:10]
    except (ValueError, OverflowError, OSError):  # a year that this computer's clock does not know
        return saved[:10]


def _lines(form: FormSlip, tell: Tell, *, answers: bool) -> Iterator[str]:
    if form.marks is None:
        yield _line(tell(template("These answers were not marked.")))
        return
    if form.unanswered:
        yield _line(tell(UNANSWERED))
        return
    if form.of and not form.waiting and not form.foreign:
        marks = said("{marks} of {of} marks", marks=f"{form.marks}", of=f"{form.of}")
        yield f'<p class="carts-slip-marks">{tell(marks)}</p>'
    if form.right:
        yield _line(tell(said("Right: {questions}", questions=numbers(form.right))))
    if form.sure:
        sure, right = form.sure
        yield _line(tell(counted("You were sure of 1 answer: {right} right.",
                                 "You were sure of {n} answers: {right} right.",
                                 n=sure, right=str(right))))  # fmt: skip
    if form.look:
        looks = "".join(_look(look, tell, answers=answers) for look in form.look)
        yield f"<h4>{tell(LOOK)}</h4><ol>{looks}</ol>"
    if form.also:
        yield _line(tell(counted("Also look at question {questions}",
                                 "Also look at questions {questions}",
                                 n=len(form.also), questions=numbers(form.also))))  # fmt: skip
    if form.open:
        yield _line(tell(said("Left open: {questions}", questions=numbers(form.open))))
    if form.waiting:
        reads = counted("Your teacher still reads question {questions}",
                        "Your teacher still reads questions {questions}",
                        n=len(form.waiting), questions=numbers(form.waiting))  # fmt: skip
        yield _line(tell(reads))
    if form.foreign:
        other = said("You had another text of these questions, so they are not marked: {questions}",
                     questions=numbers(form.foreign))  # fmt: skip
        yield _line(tell(other))
    if form.given:
        yield f"<h4>{tell(template('Your own words'))}</h4>"
        yield f"<ol>{''.join(_given(one, tell) for one in form.given)}</ol>"


def _look(look: Look, tell: Tell, *, answers: bool) -> str:
    parts = [f"{text(cut(look.ask, SHORT))}"]
    if look.answer:
        you = said("You answered: {answer}", answer=cut(look.answer))
        sure = f" <b>{tell(template('You were sure.'))}</b>" if look.sure else ""
        parts.append(f'<span class="carts-slip-you">{tell(you)}{sure}</span>')
    parts += [f"<i>{text(cut(hint))}</i>" for hint in look.hints]
    if answers and look.right:
        parts.append(f"<b>{tell(said('Right: {answer}', answer=cut(look.right)))}</b>")
    if answers and look.explain:
        parts.append(text(cut(look.explain)))
    return f'<li value="{look.number}">{"<br>".join(parts)}</li>'


def _given(given: Given, tell: Tell) -> str:
    parts = [text(cut(given.ask, SHORT))]
    if given.idea:
        first = said("Your first idea: {idea}", idea=cut(given.idea))
        parts.append(f'<span class="carts-slip-you">{tell(first)}</span>')
    you = tell(said("You wrote: {answer}", answer=cut(given.answer)))
    parts.append(f'<span class="carts-slip-you">{you}</span>')
    if given.marks is not None:
        marks = said("{marks} of {of} marks", marks=f"{given.marks}", of=f"{given.of}")
        parts.append(f"<b>{tell(marks)}</b>")
    return f'<li value="{given.number}">{"<br>".join(parts)}</li>'


def _line(html: str) -> str:
    return f"<p>{html}</p>"
