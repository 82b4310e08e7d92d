"""Moodle XML: one file with all questions, to be imported into a question bank."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import partial
from xml.sax.saxutils import escape, quoteattr

from sim.pages.classroom.moodle_text import category, cdata, literal, plain_text, text_and_files
from sim.pages.classroom.pictures import Pictures, no_pictures
from sim.pages.classroom.portable import Portable

Text = Callable[[str], str]
"""How HTML is written: its text, and the pictures that it shows."""

KINDS = {
    "choice": "multichoice", "choices": "multichoice", "number": "numerical",
    "short": "shortanswer", "essay": "essay", "pairs": "matching",
}  # fmt: skip

_FORBIDDEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]")  # no XML may hold these


def moodle_xml(title: str, questions: Iterable[Portable], pictures: Pictures = no_pictures) -> str:
    """The file; `title` names the category."""
    text = partial(text_and_files, pictures=pictures)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        "<quiz>",
        '<question type="category">',
        f"<category><text>{cdata(category(title))}</text></category>",
        "</question>",
        *(line for question in questions for line in _question(question, text)),
        "</quiz>",
    ]
    return _FORBIDDEN.sub("", "\n".join(lines)) + "\n"


def _question(q: Portable, text: Text) -> list[str]:
    return [
        f'<question type="{KINDS[q.shape]}">',
        f"<name><text>{cdata(q.id)}</text></name>",
        _html("questiontext", text(q.ask)),
        *([_html("generalfeedback", text(q.explain))] if q.explain else []),
        f"<defaultgrade>{q.marks}</defaultgrade>",
        f"<idnumber>{escape(q.id)}</idnumber>",
        *_parts(q, text),
        *_tags(q),
        "</question>",
    ]


def _parts(q: Portable, text: Text) -> list[str]:
    if q.shape in ("choice", "choices"):
        head = [
            f"<single>{'true' if q.shape == 'choice' else 'false'}</single>",
            "<shuffleanswers>true</shuffleanswers>",
            "<answernumbering>ABCD</answernumbering>",
        ]
        return head + [
            _answer(text(option), percent, text(said), form="html")
            for option, percent, said in q.answers
        ]
    if q.shape == "short":
        return [
            "<usecase>0</usecase>",
            *(
                _answer(_plain(literal(typed)), percent, text(said), form="moodle_auto_format")
                for typed, percent, said in q.answers
            ),
        ]
    if q.shape == "number":
        value, tolerance = q.number
        return [
            '<answer fraction="100" format="moodle_auto_format">',
            f"<text>{value!r}</text><tolerance>{tolerance!r}</tolerance>",
            "</answer>",
            *(_wrong_number(x, near, text(said)) for x, near, said in q.wrong_numbers if said),
            "<unitgradingtype>0</unitgradingtype><showunits>3</showunits>",
        ]
    if q.shape == "pairs":
        pairs = [*q.pairs, *(("", other) for other in q.others)]
        # Right sides are shuffled always; left ones are the places of an ordering: first, second …
        shuffled = "false" if q.order else "true"
        return [
            f"<shuffleanswers>{shuffled}</shuffleanswers>",
            *(_pair(text(left), right) for left, right in pairs),
        ]
    rubric = "".join(f"<p>{marks}: {escape(met)}</p>" for marks, met in q.rubric.items())
    # Into a plain field a platform writes the template as it is: marks of HTML would be seen.
    template = f'<responsetemplate format="plain_text">{_plain(q.start)}</responsetemplate>'
    return [
        "<responseformat>plain</responseformat>",
        _html("graderinfo", _plain(rubric)),
        *([template] if q.start else []),
    ]


def _answer(text: str, percent: float, feedback: str, *, form: str) -> str:
    said = _html("feedback", feedback)
    fraction = f"{percent:.5f}".rstrip("0").rstrip(".")
    return f'<answer fraction="{fraction}" format={quoteattr(form)}>{text}{said}</answer>'


def _wrong_number(value: float, tolerance: float, feedback: str) -> str:
    return (
        '<answer fraction="0" format="moodle_auto_format">'
        f"<text>{value!r}</text><tolerance>{tolerance!r}</tolerance>"
        f"{_html('feedback', feedback)}</answer>"
    )


def _pair(left: str, right: str) -> str:
    return (
        f'<subquestion format="html">{left}'
        f"<answer>{_plain(plain_text(right))}</answer></subquestion>"
    )


def _html(name: str, text: str) -> str:
    return f'<{name} format="html">{text}</{name}>'


def _plain(text: str) -> str:
    return f"<text>{cdata(text)}</text>"


def _tags(q: Portable) -> list[str]:
    tags = "".join(f"<tag><text>{escape(topic)}</text></tag>" for topic in q.topics)
    return [f"<tags>{tags}</tags>"] if tags else []
