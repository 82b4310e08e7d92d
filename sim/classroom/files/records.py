"""Answers as short rows, so that a page can keep them and hand them back with every question."""

from __future__ import annotations

from typing import Any

from sim.classroom.files.reading import Read
from sim.lesson.answer_file import AnswerFile, Item


def as_record(read: Read) -> list[Any]:
    """One file as a list of plain values."""
    f = read.answers
    items = [
        [
            i.id,
            i.hash,
            i.type,
            i.value,
            i.own,
            dict(i.set),
            dict(i.more),
            i.first,
            i.last,
            i.tries,
            i.right,
            dict(i.before),
        ]
        for i in f.items
    ]
    return [
        read.name, f.site, f.lesson, f.lesson_hash, f.student, f.form, f.created, f.saved, items
    ]  # fmt: skip


def from_record(row: list[Any]) -> Read:
    """The same back again."""
    name, site, lesson, lesson_hash, student, form, created, saved, items = row
    return Read(
        name,
        AnswerFile(
            site=site, lesson=lesson, lesson_hash=lesson_hash, student=student, form=form,
            created=created, saved=saved, handed=None, code="", items=tuple(map(_item, items)),
        ),
    )  # fmt: skip


def _item(row: list[Any]) -> Item:
    name, digest, kind, value, own, changed, more, first, last, tries, right, before = row
    return Item(
        id=name, hash=digest, type=kind, value=value, own=own, first=first, last=last, tries=tries,
        set=changed, more=more, right=right, before=before,
    )  # fmt: skip
