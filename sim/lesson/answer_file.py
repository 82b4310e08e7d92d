"""The file of a student's answers: read with checks, so that nothing unknown gets any further.

The page writes it (sim/web/src/answers/file.js) and reads it within the same bounds. What is not
understood is refused as a whole, with a message for the teacher; unknown keys are left out.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, TypeGuard

from sim.lesson.opening import FORMS

FORMAT = 1
KIND = "newtons-carts-answers"
MOST_BYTES = 2_000_000  # an answer file has some 20 000
MOST_ITEMS = 2000
LONGEST = 20_000  # characters of one answer
LARGEST = 1e300  # a number; beyond, and for what is no number, nothing is compared or added
MOST_TRIES = 1_000_000
_ID = re.compile(r"[a-z_][a-z0-9-]{0,79}", re.ASCII)
_HASH = re.compile(r"[0-9a-f]{12}", re.ASCII)
_TYPE = re.compile(r"[a-z][a-z-]{2,23}", re.ASCII)
_TIME = re.compile(r"\d{4}-\d{2}-\d{2}T\d{2}:\d{2}:\d{2}(\.\d{1,3})?Z", re.ASCII)
_NAME = re.compile(r"[\w.+-]{1,64}", re.ASCII)
_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f]")
_PART_OF_KEYS = re.compile(r"[#@]")  # a lesson may have them in its name, a code word may not
_HALF = re.compile(r"\\u[dD][89a-fA-F]")
TEXTS = ("unit", "said", "asked", "sure", "locked", "again", "why", "now")
FOUND_FORCE, CHALLENGE = "found-force", "challenge"  # types of what was done with a run
PREDICTIONS = ("arrows", "curve", "choice", "text")  # types of what was said before a run
NO_QUESTIONS = (*PREDICTIONS, FOUND_FORCE, CHALLENGE)  # types of answers that no key knows
NOTHING_SET: Mapping[str, Any] = MappingProxyType({})  # one for millions of answers


def _nothing() -> Mapping[str, Any]:
    return NOTHING_SET  # Python 3.11 takes it for mutable: no default, then


class AnswerFileError(ValueError):
    """This is no file of answers that can be used; the message is for people."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """One answer. `value` as in sim.lesson.kinds, times ISO 8601 UTC, `hash` of the question."""

    id: str
    hash: str
    type: str
    value: Any
    first: str | None
    last: str | None
    tries: int
    own: float | None = None
    set: Mapping[str, Any] = field(
        default_factory=_nothing
    )  # what was changed in the run it was read off
    right: int | None = None  # press on Check at which it was right first; 0: none; None: not told
    before: Mapping[str, Any] = field(default_factory=_nothing)
    """The answer (value) when the run beside it was watched."""
    more: Mapping[str, str]


@dataclass(frozen=True, slots=True, kw_only=True)
class AnswerFile:
    """One student's answers to one form of one lesson. Earlier answers stand before later ones."""

    site: str
    lesson: str
    lesson_hash: str
    student: str
    form: str
    created: str
    saved: str
    handed: str | None
    code: str
    items: tuple[Item, ...]

    def latest(self) -> dict[str, Item]:
        """The last answer to each question."""
        return {item.id: item for item in self.items}


def read_answer_file(text: str) -> AnswerFile:
    """The answers in the text of a file; raises `AnswerFileError`."""
    content = _table(text)
    wanted = ("site", "lesson", "lessonHash", "student", "created", "saved")
    if not all(isinstance(content.get(name), str) for name in wanted) or any(
        len(content[name]) > 200
        or _CONTROL.search(content[name])
        or (name in ("site", "student") and _PART_OF_KEYS.search(content[name]))
        for name in wanted
    ):
        raise AnswerFileError("this file is damaged: it does not say whose answers it holds")
    if content.get("form") not in FORMS:
        raise AnswerFileError("this file is damaged: it does not say which form it is")
    rows = content.get("items")
    if not isinstance(rows, list) or len(rows) > MOST_ITEMS:
        raise AnswerFileError("this file is damaged: its answers cannot be read")
    handed = content.get("handed")
    code = content.get("code", "")
    return AnswerFile(
        site=content["site"],
        lesson=content["lesson"],
        lesson_hash=content["lessonHash"],
        student=content["student"],
        form=content["form"],
        created=content["created"],
        saved=content["saved"],
        handed=handed if isinstance(handed, str) and _TIME.fullmatch(handed) else None,
        code=code if isinstance(code, str) and re.fullmatch(r"[0-9A-Z-]{0,14}", code) else "",
        items=tuple(map(_item, rows)),
    )


def _table(text: str) -> dict[str, Any]:
    if len(text) > MOST_BYTES:
        raise AnswerFileError("this file is too large to be a file of answers")
    try:
        content = json.loads(text.removeprefix("\ufeff"), parse_constant=_no_constant)
        if _HALF.search(text):  # half a character: no text with it could ever be written out
            json.dumps(content, ensure_ascii=False).encode("utf-8")
    except (ValueError, RecursionError):
        raise AnswerFileError("this file is damaged, or it is not a file of answers") from None
    if not isinstance(content, dict) or content.get("kind") != KIND:
        raise AnswerFileError("this is not a file of answers")
    version = content.get("format")
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        raise AnswerFileError("this is not a file of answers")
    if version > FORMAT:
        raise AnswerFileError("this file comes from a newer version of the lessons")
    return content


def _no_constant(name: str) -> float:
    raise ValueError(name)


def _item(row: object) -> Item:
    if not isinstance(row, dict) or not _is_good(row) or not is_plain(row.get("value")):
        raise AnswerFileError("an answer in this file is damaged")
    own = row.get("own")
    return Item(
        id=row["id"],
        hash=row["hash"],
        type=row["type"],
        value=row.get("value"),
        first=row["first"],
        last=row["last"],
        tries=row["tries"],
        own=float(own) if _is_number(own) else None,
        set=_settings(row.get("set")),
        right=_right(row),
        before=_before(row.get("before")),
        more={
            name: row[name]
            for name in TEXTS
            if isinstance(row.get(name), str) and len(row[name]) <= LONGEST
        },
    )


def _is_number(value: Any) -> TypeGuard[float]:
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return number and bool(abs(value) < LARGEST)


def _right(row: Mapping[str, Any]) -> int | None:
    right = row.get("right")
    told = isinstance(right, int) and not isinstance(right, bool) and 0 <= right <= row["tries"]
    return right if told else None


def _before(value: object) -> Mapping[str, Any]:
    """What was answered at the run; only what it was, not how it was said."""
    if not isinstance(value, dict) or not is_plain(value) or value.get("value") is None:
        return NOTHING_SET
    return {"value": value["value"]}


def _settings(value: object) -> Mapping[str, Any]:
    if not value or not isinstance(value, dict) or not is_plain(value, 1):
        return NOTHING_SET
    return {name: part for name, part in value.items() if isinstance(part, (str, int, float))}


def _is_good(row: Mapping[str, Any]) -> bool:
    def text(name: str, pattern: re.Pattern[str]) -> bool:
        return isinstance(row.get(name), str) and pattern.fullmatch(row[name]) is not None

    tries = row.get("tries")
    return (
        text("id", _ID)
        and (row.get("hash") == "" or text("hash", _HASH))
        and text("type", _TYPE)
        and all(
            name in row and (row[name] is None or text(name, _TIME)) for name in ("first", "last")
        )
        and isinstance(tries, int)
        and not isinstance(tries, bool)
        and 0 <= tries <= MOST_TRIES
    )


def is_plain(value: object, depth: int = 0) -> bool:
    """Texts, numbers, short lists and tables of them: all that an answer can be."""
    if value is None or isinstance(value, bool):
        return True
    if isinstance(value, str):
        return len(value) <= LONGEST
    if isinstance(value, (int, float)):
        return abs(value) < LARGEST
    if depth > 3 or not isinstance(value, (list, dict)) or len(value) > 200:
        return False
    pairs = value.items() if isinstance(value, dict) else ((str(k), v) for k, v in enumerate(value))
    return all(
        _NAME.fullmatch(name) and not name.startswith("__") and is_plain(part, depth + 1)
        for name, part in pairs
    )
