"""When a form is open: at once, after something is done, from a date, or by the teacher's word.

A closed form is hidden, not secret: who reads the page's source finds its questions (never, in an
exam, its key). The page holds only a checksum of the word.
"""

from __future__ import annotations

import re
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import date
from typing import Any

from sim.scene.problem import Path, Problem
from sim.scene.tables import unknown_keys

FORMS = ("worksheet", "pre", "post", "delayed")
RULES = ("word", "date", "done", "days")
HINT = "open: {word: FALCON}, {date: 2027-03-01}, {done: worksheet} or {done: post, days: 14}"
_DATE = re.compile(r"\d{4}-\d{2}-\d{2}", re.ASCII)


@dataclass(frozen=True, slots=True, kw_only=True)
class Rule:
    """All that is given must hold. `done`: a form that must be handed in (worksheet: answered)."""

    word: str = ""
    date: str = ""
    done: str = ""
    days: int = 0

    def facts(self, scope: str) -> dict[str, Any]:
        """What the page knows of the rule."""
        facts: dict[str, Any] = {}
        if self.word:
            facts["word"] = word_sum(scope, self.word)
        if self.date:
            facts["date"] = self.date
        if self.done:
            facts |= {"done": self.done, "days": self.days}
        return facts


def word_sum(scope: str, word: str) -> str:
    """The checksum under which the page knows a word; capitals and spaces do not count."""
    squeezed = "".join(word.split()).upper()
    return f"{zlib.crc32(f'{scope}:{squeezed}'.encode()):08x}"


def read_rule(
    table: Mapping[str, Any], name: str, allowed: tuple[str, ...], problems: list[Problem]
) -> Rule:
    """The rule under `name`; without one, an empty rule."""
    value = table.get(name)
    path: Path = (name,)
    if (value is None and name not in table) or value == "now":
        return Rule()
    if not isinstance(value, Mapping) or not value:
        problems.append(Problem(path, "not-a-table", f"{name} is now or a rule", HINT))
        return Rule()
    unknown_keys(value, allowed, path, problems)
    return Rule(
        word=_word(value, path, problems),
        date=_date(value, path, problems),
        done=_done(value, path, problems),
        days=_days(value, path, problems),
    )


def check_order(opens: Rule, closes: Rule, problems: list[Problem]) -> None:
    """A form whose last day comes before its first is never open."""
    if opens.date and closes.date and closes.date < opens.date:
        message = f"the last day of this form, {closes.date}, is before it opens on {opens.date}"
        problems.append(Problem(("close", "date"), "out-of-range", message, "a later day"))


def _word(table: Mapping[str, Any], path: Path, problems: list[Problem]) -> str:
    word = str(table.get("word", "")).strip()
    if "word" in table and len("".join(word.split())) < 4:
        message = "a word to open a form has at least four letters"
        problems.append(Problem((*path, "word"), "bad-name", message, "word: FALCON"))
    return word


def _date(table: Mapping[str, Any], path: Path, problems: list[Problem]) -> str:
    text = str(table.get("date", ""))
    if not text:
        return ""
    try:
        if not _DATE.fullmatch(text):
            raise ValueError
        date.fromisoformat(text)
    except ValueError:
        message = f"“{text[:40]}” is not a date"
        problems.append(Problem((*path, "date"), "not-a-date", message, "date: 2027-03-01"))
    return text


def _done(table: Mapping[str, Any], path: Path, problems: list[Problem]) -> str:
    done = table.get("done", "")
    if done and done not in FORMS:
        message = f"done is one of {', '.join(FORMS)}"
        problems.append(Problem((*path, "done"), "not-a-choice", message, "done: worksheet"))
    return str(done)


def _days(table: Mapping[str, Any], path: Path, problems: list[Problem]) -> int:
    days = table.get("days", 0)
    if not isinstance(days, int) or isinstance(days, bool) or not 0 <= days <= 400:
        message = "days is a whole number of days after the form was handed in"
        problems.append(Problem((*path, "days"), "out-of-range", message, "days: 14"))
        return 0
    if days and table.get("done", "worksheet") == "worksheet":
        message = "days counts from a form that was handed in"
        problems.append(Problem((*path, "days"), "missing", message, "{done: post, days: 14}"))
    return days
