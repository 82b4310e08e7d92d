"""Where files come from: other wordings, other versions, other sites, nobody."""

from __future__ import annotations

from collections.abc import Sequence

from sim.classroom.report.flag import Flag
from sim.classroom.report.marked import Marked


def foreign(files: Sequence[Marked]) -> list[Flag]:
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


def nameless(files: Sequence[Marked]) -> list[Flag]:
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
