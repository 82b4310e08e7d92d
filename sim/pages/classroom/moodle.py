"""Moodle XML: one file with all questions, to be imported into a question bank."""

from __future__ import annotations

import re
from collections.abc import Iterable
from html import unescape
from xml.sax.saxutils import escape, quoteattr

from sim.pages.classroom.portable import Portable

KINDS = {
    "choice": "multichoice", "choices": "multichoice", "number": "numerical",
    "short": "shortanswer", "essay": "essay", "pairs": "matching",
}  # fmt: skip

_MARK = re.compile("<[^>]*>")
_PICTURE = re.compile(r'<img\b[^>]*?\balt="([^"]*)"[^>]*>')
_FORBIDDEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]")  # no XML may hold these


def moodle_xml(title: str, questions: Iterable[Portable]) -> str:
    """The file; `title` names the category."""
    category = title.replace("/", "//")  # a single slash would make a sub-category
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        "<quiz>",
        '<question type="category">',
        f"<category><text>{_cdata(f'$course$/top/{category}')}</text></category>",
        "</question>",
        *(line for question in questions for line in _question(question)),
        "</quiz>",
    ]
    return _FORBIDDEN.sub("", "\n".join(lines)) + "\n"


def literal(text: str) -> str:
    """A short answer as typed: Moodle takes a bare star for anything."""
    return text.replace("*", "\\*")


def _question(q: Portable) -> list[str]:
    return [
        f'<question type="{KINDS[q.shape]}">',
        f"<name><text>{_cdata(q.id)}</text></name>",
        _html("questiontext", q.ask),
        *([_html("generalfeedback", q.explain)] if q.explain else []),
        f"<defaultgrade>{q.marks}</defaultgrade>",
        f"<idnumber>{escape(q.id)}</idnumber>",
        *_parts(q),
        *_tags(q),
        "</question>",
    ]


def _parts(q: Portable) -> list[str]:
    if q.shape in ("choice", "choices"):
        head = [
            f"<single>{'true' if q.shape == 'choice' else 'false'}</single>",
            "<shuffleanswers>true</shuffleanswers>",
            "<answernumbering>ABCD</answernumbering>",
        ]
        return head + [_answer(*answer, form="html") for answer in q.answers]
    if q.shape == "short":
        return [
            "<usecase>0</usecase>",
            *(
                _answer(literal(text), percent, said, form="moodle_auto_format")
                for text, percent, said in q.answers
            ),
        ]
    if q.shape == "number":
        value, tolerance = q.number
        return [
            '<answer fraction="100" format="moodle_auto_format">',
            f"<text>{value!r}</text><tolerance>{tolerance!r}</tolerance>",
            "</answer>",
            *(_wrong_number(*wrong) for wrong in q.wrong_numbers if wrong[2]),
            "<unitgradingtype>0</unitgradingtype><showunits>3</showunits>",
        ]
    if q.shape == "pairs":
        pairs = [*q.pairs, *(("", other) for other in q.others)]
        # Right sides are shuffled always; left ones are the places of an ordering: first, second …
        shuffled = "false" if q.order else "true"
        return [
            f"<shuffleanswers>{shuffled}</shuffleanswers>",
            *(_pair(*pair) for pair in pairs),
        ]
    rubric = "".join(f"<p>{marks}: {escape(text)}</p>" for marks, text in q.rubric.items())
    # Into a plain field a platform writes the template as it is: marks of HTML would be seen.
    start = _cdata(q.start)
    template = f'<responsetemplate format="plain_text"><text>{start}</text></responsetemplate>'
    return [
        "<responseformat>plain</responseformat>",
        _html("graderinfo", rubric),
        *([template] if q.start else []),
    ]


def _answer(text: str, percent: float, feedback: str, *, form: str) -> str:
    said = _html("feedback", feedback)
    fraction = f"{percent:.5f}".rstrip("0").rstrip(".")
    return (
        f'<answer fraction="{fraction}" format={quoteattr(form)}>'
        f"<text>{_cdata(text)}</text>{said}</answer>"
    )


def _wrong_number(value: float, tolerance: float, feedback: str) -> str:
    return (
        '<answer fraction="0" format="moodle_auto_format">'
        f"<text>{value!r}</text><tolerance>{tolerance!r}</tolerance>"
        f"{_html('feedback', feedback)}</answer>"
    )


def _pair(left: str, right: str) -> str:
    return (
        f'<subquestion format="html"><text>{_cdata(left)}</text>'
        f"<answer><text>{_cdata(plain_text(right))}</text></answer></subquestion>"
    )


def plain_text(html: str) -> str:
    """What a list to choose from can show: it holds no marks of HTML, of a picture its words."""
    return unescape(_MARK.sub("", _PICTURE.sub(r"\1", html)))


def _html(name: str, content: str) -> str:
    return f'<{name} format="html"><text>{_cdata(content)}</text></{name}>'


def _cdata(content: str) -> str:
    """A text as it is: of an escaped one Moodle's reader drops blanks between two such signs."""
    return "<![CDATA[" + content.replace("]]>", "]]]]><![CDATA[>") + "]]>"


def _tags(q: Portable) -> list[str]:
    tags = "".join(f"<tag><text>{escape(topic)}</text></tag>" for topic in q.topics)
    return [f"<tags>{tags}</tags>"] if tags else []
