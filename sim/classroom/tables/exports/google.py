"""The answers to a quiz of Google Forms: `Timestamp`, `Score` as `7 / 10`, `… [Score]`."""

from __future__ import annotations

from collections.abc import Sequence

from sim.classroom.tables.layout import Column, Layout, norm, place_of
from sim.classroom.tables.words import CLASS, GROUP, STUDENT

STAMP = ("timestamp", "zeitstempel", "cap masa", "setem masa", "时间戳记", "时间戳", "நேரமுத்திரை")
TOTAL = ("score", "total score", "punktzahl", "gesamtpunktzahl", "skor", "markah", "得分", "总得分",
         "மதிப்பெண்")  # fmt: skip
MAIL = ("email address", "username", "e-mail-adresse", "nutzername", "alamat e-mel", "电子邮件地址")
PARTS = ("[score]", "[punktzahl]", "[punkte]", "[skor]", "[markah]", "[得分]")


def layout(heads: Sequence[str]) -> Layout | None:
    """The columns of such an export, or None."""
    words = [norm(head) for head in heads]
    total = place_of(heads, TOTAL)
    items = [k for k, word in enumerate(words) if word.endswith(PARTS)]
    if place_of(heads, STAMP) is None or (total is None and not items):
        return None
    return Layout(
        kind="google",
        student=_person(heads),
        group=place_of(heads, GROUP),
        klass=place_of(heads, CLASS),
        items=tuple(Column(k, heads[k].rpartition("[")[0].strip() or heads[k]) for k in items),
        totals=(Column(total, "total"),) if total is not None else (),
    )


def _person(heads: Sequence[str]) -> tuple[tuple[int, ...], ...]:
    """The question for a code word or a name, then the address."""
    asked = [
        k
        for k, head in enumerate(heads)
        if norm(head) in STUDENT or any(w in norm(head) for w in ("code word", "your name"))
    ]
    mail = place_of(heads, MAIL)
    return tuple((k,) for k in [*asked[:1], *([mail] if mail is not None else [])])
