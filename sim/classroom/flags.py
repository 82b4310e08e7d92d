"""What a teacher should look at before counting: worded as questions, never as a verdict.

A flag changes nothing in the numbers, except where two files claim the same place: `Sorted.counted`
leaves both out until the teacher has decided.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta

from sim.classroom.marked import Marked
from sim.lesson.mark import is_empty

FEWEST_EQUAL = 5
"""Equal answers in two files below this number say nothing."""

HASTE = timedelta(seconds=2)
"""Per answer. Nobody reads a question faster."""

ORDER = ("pre", "worksheet", "post", "delayed")
_FIRST_YEAR = 2020


@dataclass(frozen=True, slots=True)
class Flag:
    """A question to the teacher about some files."""

    code: str
    sentence: str
    files: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Sorted:
    """The files that count, those that wait for the teacher, and the questions about them."""

    counted: tuple[Marked, ...]
    set_aside: tuple[Marked, ...]
    flags: tuple[Flag, ...]


def sort_out(files: Sequence[Marked], now: str = "") -> Sorted:
    """Flags, and which files count. `now`: ISO 8601 UTC, where the clock of the reader is known."""
    counted, aside, flags = _doubles(files)
    flags += _equal(counted)
    for file in counted:
        flags += _times(file, now)
    flags += _order(counted)
    flags += _foreign(counted)
    flags += _nameless(counted)
    return Sorted(tuple(counted), tuple(aside), tuple(flags))


def _doubles(files: Sequence[Marked]) -> tuple[list[Marked], list[Marked], list[Flag]]:
    """One file for each student and form; of two saves of one student the later one."""
    places: dict[tuple[str, str, str, str], list[Marked]] = {}
    for file in files:
        places.setdefault(file.key, []).append(file)
    counted, aside, flags = [], [], []
    for same in places.values():
        if len(same) == 1:
            counted += same
            continue
        names = tuple(file.name for file in same)
        who = f"{same[0].who}, form {same[0].file.form}"
        typed = any(not file.file.created for file in same)  # a hand-in code has no times
        distinct = {_answers(file, times=not typed) for file in same}
        if len(distinct) == 1:
            counted.append(same[0])
            aside += same[1:]
            text = f"{who}: is this the same file {_times_word(len(same))}? It is counted once."
            flags.append(Flag("same-file", text, names))
        elif len({file.file.created for file in same}) == 1:
            latest = max(same, key=lambda file: file.file.saved)
            counted.append(latest)
            aside += [file for file in same if file is not latest]
            text = (
                f"{who}: is this one student who saved {_times_word(len(same))}? "
                "The file saved last is counted."
            )
            flags.append(Flag("saved-again", text, names))
        else:
            aside += same
            text = (
                f"{who}: {len(same)} files have this code word. Are these two students, or one "
                "who began again? None of them is counted until you leave all but one out."
            )
            flags.append(Flag("doubled-id", text, names))
    return counted, aside, flags


def _times_word(count: int) -> str:
    return "twice" if count == 2 else f"{count} times"


def _answers(file: Marked, *, times: bool) -> str:
    """The answers of a file as something to compare; empty ones and the student are left out."""
    rows = sorted(
        [i.id, i.type, i.value, *([i.first, i.last] if times else [])]
        for i in file.file.latest().values()
        if not is_empty(i.value)
    )
    # The texts of 5,000 students would stay in memory: a digest of each is enough.
    return hashlib.sha256(json.dumps(rows, sort_keys=True).encode()).hexdigest()


def _equal(files: Iterable[Marked]) -> list[Flag]:
    """Different students with the same answers to everything."""
    found: dict[tuple[str, str, str, str], list[Marked]] = {}
    for file in files:
        answered = sum(not is_empty(item.value) for item in file.file.latest().values())
        if answered >= FEWEST_EQUAL:
            f = file.file
            found.setdefault((f.site, f.lesson, f.form, _answers(file, times=False)), []).append(
                file
            )
    flags = []
    for same in found.values():
        if len(same) < 2:
            continue
        names = tuple(file.name for file in same)
        count = "two" if len(same) == 2 else str(len(same))
        text = f"Same answers in {count} files. Partners and good students do this too. "
        right = all(a.marks == a.worth for file in same for a in file.answers.values())
        if right and any(a.worth for a in same[0].answers.values()):
            text += "Here all answers are right. "
        if len({_answers(file, times=True) for file in same}) == 1:
            text += "The times are equal as well: is one a copy of the other? "
        flags.append(Flag("equal-files", f"{text}Ask before you judge.", names))
    return flags


def _times(file: Marked, now: str) -> list[Flag]:
    """Times that cannot be: a wrong clock, a file that was edited, or a try in haste."""
    f = file.file
    if not f.created:
        return []  # a hand-in code
    created, saved = _moment(f.created), _moment(f.saved)
    strange = created is None or saved is None or created.year < _FIRST_YEAR
    strange = strange or (created is not None and saved is not None and saved < created)
    here = _moment(now)
    ahead = bool(here and saved and saved > here + timedelta(days=1))
    moments = [
        (first, last)
        for item in f.items
        if (first := _moment(item.first or "")) and (last := _moment(item.last or ""))
    ]
    strange = strange or any(last < first or (saved and last > saved) for first, last in moments)
    flags = []
    if strange or ahead:
        text = (
            f"{file.who}, form {f.form}: the times in this file cannot be right. Was the clock "
            "of that laptop wrong, or was the file changed by hand?"
        )
        flags.append(Flag("impossible-times", text, (file.name,)))
    elif len(moments) >= FEWEST_EQUAL:
        took = max(last for _, last in moments) - min(first for first, _ in moments)
        if took < HASTE * (len(moments) - 1):
            text = (
                f"{file.who}, form {f.form}: {len(moments)} answers in {took.seconds} s. "
                "Was this only a try?"
            )
            flags.append(Flag("in-haste", text, (file.name,)))
    return flags


def _moment(text: str) -> datetime | None:
    try:
        moment = datetime.fromisoformat(text)
    except ValueError:
        return None
    return moment if moment.tzinfo else moment.replace(tzinfo=UTC)


def _order(files: Sequence[Marked]) -> list[Flag]:
    """A later form that was finished before an earlier one was begun."""
    by_student: dict[tuple[str, str, str], dict[str, Marked]] = {}
    for file in files:
        f = file.file
        by_student.setdefault((f.site, f.lesson, file.student), {})[f.form] = file
    flags = []
    for forms in by_student.values():
        if "pre" in forms and "post" in forms:
            pre, post = forms["pre"], forms["post"]
            begun, ended = _moment(pre.file.created), _moment(post.file.saved)
            if begun and ended and ended < begun:
                text = (
                    f"{post.who}: the form post was saved before the form pre was begun. "
                    "Were the two forms mixed up, or is a clock wrong?"
                )
                flags.append(Flag("post-before-pre", text, (pre.name, post.name)))
    return flags


def _foreign(files: Sequence[Marked]) -> list[Flag]:
    """Answers to other wordings, and files of other sites."""
    flags = []
    other = [file for file in files if file.foreign]
    if other:
        items = sorted({name for file in other for name in file.foreign})
        text = (
            f"{len(other)} files hold answers to another wording of {', '.join(items[:5])}"
            f"{' and others' if len(items) > 5 else ''}. Do file and key come from the same "
            "version of the lesson? These files are listed and not counted."
        )
        flags.append(Flag("foreign-version", text, tuple(file.name for file in other)))
    flags += _versions(files)
    sites = sorted({file.file.site for file in files})
    if len(sites) > 1:
        most = max(sites, key=lambda site: sum(f.file.site == site for f in files))
        strangers = tuple(file.name for file in files if file.file.site != most)
        text = (
            f"Files of {len(sites)} sites: {', '.join(sites[:5])}. Did all students use the same "
            "copy of the lessons? Each site has tables of its own."
        )
        flags.append(Flag("foreign-site", text, strangers))
    return flags


def _versions(files: Sequence[Marked]) -> list[Flag]:
    """Files from another version of a lesson than most: what still fits is counted."""
    by_lesson: dict[tuple[str, str], dict[str, list[str]]] = {}
    for file in files:
        f = file.file
        if f.lesson_hash:
            versions = by_lesson.setdefault((f.site, f.lesson), {})
            versions.setdefault(f.lesson_hash, []).append(file.name)
    flags = []
    for (_, lesson), versions in by_lesson.items():
        if len(versions) > 1:
            most = max(versions.values(), key=len)
            others = tuple(n for names in versions.values() if names is not most for n in names)
            text = (
                f"{len(versions)} versions of the lesson {lesson}. Was it changed meanwhile, or do "
                "students have different copies? Answers to unchanged questions are counted."
            )
            flags.append(Flag("other-version", text, others))
    return flags


def _nameless(files: Sequence[Marked]) -> list[Flag]:
    """Files that say nothing of whose they are."""
    names = tuple(file.name for file in files if not file.file.student.strip())
    if not names:
        return []
    one = len(names) == 1
    text = (
        f"{'1 file has' if one else f'{len(names)} files have'} no code word: "
        f"{'it counts' if one else 'each counts'} as a person of its own. Do you know whose "
        f"{'it is' if one else 'they are'}? Then give {'it' if one else 'them'} a code word."
    )
    return [Flag("no-code", text, names)]
