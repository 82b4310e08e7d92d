"""What `carts check` says of a catalogue: lost marks, broken blocks, and how much is missing."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from sim.pages.findings import AuthorError, Finding
from sim.pages.translate.catalogues import OTHERS, is_bank, lessons_folder, source_of
from sim.pages.translate.markdown_units import markdown_units
from sim.pages.translate.translation import Part, Translation, part_of, translations_of
from sim.pages.translate.unit import Unit, changed_marks

CheckText = Callable[[str, Translation], list[Finding]]


def catalogue_findings(
    path: Path, root: Path, check: CheckText | None, *, hints: bool
) -> list[Finding]:
    """Of the lesson or bank at `path`. `check`: looks for mistakes in what was put together; None
    where the original has some of its own. `hints`: also how many texts are not translated.
    """
    folder = lessons_folder(path)
    findings: list[Finding] = []
    try:
        for language in OTHERS:
            source = source_of(path, folder, language)
            if source.catalogue.is_file() and not source.by_hand:
                part = part_of(source, root)
                findings += [*_of_part(part), *(_missing(part) if hints else ())]
        if check and not is_bank(path) and not findings_are_errors(findings):
            for one in translations_of(path, folder, root):
                findings += map(one.finding, check(one.lesson.made.text, one))
    except AuthorError as error:
        findings += error.findings
    return findings


def findings_are_errors(findings: list[Finding]) -> bool:
    """Whether one of them is more than a hint."""
    return any(finding.severity == "error" for finding in findings)


def _of_part(part: Part) -> Iterator[Finding]:
    """Translations that lost a formula or a link, or that Markdown would read as something else."""
    seen = set()
    for unit in part.made.units:
        said = part.words.words.get(unit.text)
        if said is None or unit.text in seen:
            continue
        seen.add(unit.text)
        line = part.words.place(unit.text)
        lost, new = changed_marks(unit.text, said)
        if lost or new:
            what = [f"lacks {', '.join(lost)}"] if lost else []
            what += [f"has {', '.join(new)}, which the English has not"] if new else []
            message = f"this translation {' and '.join(what)}"
            hint = "copy formulas, code, addresses of links and {attributes} as they stand"
            yield Finding(part.words.file, line, 1, "marks-changed", message, hint)
        if unit.form == "markdown" and not _stays_one(unit, said):
            message = f"Markdown reads the translation of “{unit.text[:60]}” as something else"
            hint = "one paragraph, without #, -, | or a number and a point at its beginning"
            yield Finding(part.words.file, line, 1, "not-one-part", message, hint)


def _stays_one(unit: Unit, said: str) -> bool:
    if unit.where in ("heading", "title of a note", "cell of a table"):
        forbidden = {"title of a note": '"\n', "cell of a table": "|\n"}.get(unit.where, "\n")
        return not any(sign in said for sign in forbidden)
    lines = said.strip().split("\n")
    found = [one.text for one in markdown_units(lines, [0] * len(lines), 0)]
    return not found or (len(found) == 1 and found[0].split() == said.split())


def _missing(part: Part) -> Iterator[Finding]:
    texts = {unit.text for unit in part.made.units}
    left = texts - set(part.words.words)
    if left:
        message = f"{len(left)} of {len(texts)} texts are not translated: readers see English"
        old = len(left & part.words.fuzzy)
        hint = f"{old} of them have an old translation (fuzzy)" if old else "Poedit lists them"
        yield Finding(part.words.file, 1, 1, "untranslated", message, hint, "hint")
