"""Where files come from: other wordings, other versions, other sites, nobody."""

from __future__ import annotations

from collections.abc import Sequence

from sim.classroom.report.flag import Flag
from sim.classroom.report.marked import Marked
from sim.scene.said import counted, said

NAMED = 5
"""Items or sites that a question names."""


def foreign(files: Sequence[Marked]) -> list[Flag]:
    """Answers to other wordings, and files of other sites."""
    flags = []
    other = [file for file in files if file.foreign]
    if other:
        items = sorted({name for file in other for name in file.foreign})
        named = ", ".join(items[:NAMED])
        text = counted(
            "1 file holds answers to another wording of {items}. Do file and key come from the "
            "same version of the lesson? This file is listed and not counted.",
            "{n} files hold answers to another wording of {items}. Do file and key come from the "
            "same version of the lesson? These files are listed and not counted.",
            n=len(other),
            items=said("{items} and others", items=named) if len(items) > NAMED else named,
        )  # fmt: skip
        flags.append(Flag("foreign-version", text, tuple(file.name for file in other)))
    flags += _versions(files)
    sites = sorted({file.file.site for file in files})
    if len(sites) > 1:
        most = max(sites, key=lambda site: sum(f.file.site == site for f in files))
        strangers = tuple(file.name for file in files if file.file.site != most)
        text = said(
            "Files of {n} sites: {sites}. Did all students use the same copy of the lessons? Each "
            "site has tables of its own.",
            n=f"{len(sites)}", sites=", ".join(sites[:NAMED]),
        )  # fmt: skip
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
            text = said(
                "{n} versions of the lesson {lesson}. Was it changed meanwhile, or do students "
                "have different copies? Answers to unchanged questions are counted.",
                n=f"{len(versions)}", lesson=lesson,
            )  # fmt: skip
            flags.append(Flag("other-version", text, others))
    return flags


def nameless(files: Sequence[Marked]) -> list[Flag]:
    """Files that say nothing of whose they are."""
    names = tuple(file.name for file in files if not file.file.student.strip())
    if not names:
        return []
    text = counted(
        "1 file has no code word: it counts as a person of its own. Do you know whose it is? Then "
        "give it a code word.",
        "{n} files have no code word: each counts as a person of its own. Do you know whose they "
        "are? Then give them a code word.",
        n=len(names),
    )
    return [Flag("no-code", text, names)]
