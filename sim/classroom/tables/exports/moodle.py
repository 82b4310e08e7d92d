"""The results of a Moodle quiz as it exports them: `Surname`, `Grade/10.00`, `Q. 1 /1.00`.

Headings are in the language of the site, so questions are known by their shape: a short word, a
number, and the most marks after a slash.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.classroom.statistics.spread import Exact
from sim.classroom.tables.heading_maximum import split_most
from sim.classroom.tables.layout import Column, Layout, norm, place_of
from sim.classroom.tables.words import CLASS, FAMILY, GIVEN, GROUP, ID_NUMBER, words

_QUESTION = re.compile(r"\D{1,12}?[.\s]*[0-9]{1,3}\s*/\s*[0-9]+(?:[.,][0-9]+)?")
_GRADE = re.compile(r"[^\d/]{2,30}/\s*[0-9]+(?:[.,][0-9]+)?")
MAIL = words("""
    email address | e-mail-adresse | alamat e-mel | adresse de courriel | dirección de correo |
    dirección email | correo electrónico | 电子邮件地址 | email | e-mail
""")
ACCOUNT = ID_NUMBER | words("学号 | username | anmeldename | nom d'utilisateur | nombre de usuario")
WHOLE_NAME = words("""
    full name | name | vollständiger name | nama penuh | nom complet | nombre completo | 姓名
""")
STATE = words("state | status | keadaan | état | statut | estado | 状态 | நிலை")
BEGUN = words("""
    started on | started | begonnen am | bermula pada | commencé le | comenzado el | 开始于
""")


def layout(heads: Sequence[str]) -> Layout | None:
    """The columns of such an export, or None."""
    grade = next((k for k, head in enumerate(heads) if _GRADE.fullmatch(head)), None)
    state, begun = place_of(heads, STATE), place_of(heads, BEGUN)
    person = person_of(heads)
    if grade is None or not person or (state is None and begun is None):
        return None
    questions = [k for k, head in enumerate(heads) if _QUESTION.fullmatch(head) and k != grade]
    return Layout(
        kind="moodle",
        student=person,
        group=place_of(heads, GROUP),
        klass=place_of(heads, CLASS),
        items=tuple(Column(k, name, "", of) for k in questions for name, of in [_named(heads[k])]),
        totals=(Column(grade, "total", "", split_most(heads[grade])[1]),),
        state=state,
        needs=tuple(k for k in (state, begun) if k is not None),
    )


def person_of(heads: Sequence[str]) -> tuple[tuple[int, ...], ...]:
    """An address or number tells people apart best, then surname and first name together."""
    single = [place_of(heads, names) for names in (MAIL, ACCOUNT, WHOLE_NAME)]
    both = [place_of(heads, names) for names in (GIVEN, FAMILY)]
    ways = [[place] for place in single[:2]] + [both] + [[single[2]]]
    known = (tuple(place for place in way if place is not None) for way in ways)
    return tuple(way for way in known if way)


def _named(heading: str) -> tuple[str, Exact | None]:
    name, of = split_most(heading)
    return norm(name).replace(" ", "").replace(".", "").upper() or name, of
