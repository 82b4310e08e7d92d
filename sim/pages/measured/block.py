"""A `measured` block: a place for readings of real carts, with those of a file to begin with.

    ```measured
    id: our-carts
    data: real-carts.txt
    units: {length: m, time: s}
    ```

The file lies beside the lesson or in the folder data/ beside it. It is read when the site is built:
what is wrong in it is told with its own line. Without `data` the bench is empty, for the class.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from sim.measured.model.contact import LAWS, Law
from sim.measured.refusal import ReadingError
from sim.measured.sheet.cells import decoded
from sim.measured.tracks import Measured, read_measured
from sim.measured.units import OFFERED, Units
from sim.pages.blocks.scene_block import Lesson, SiteIds, load_block
from sim.pages.findings import AuthorError, Finding
from sim.pages.language import mark
from sim.pages.text.author_text import shown_here
from sim.pages.text.fence_scan import Block
from sim.pages.text.yaml.source import KeyPath, Source
from sim.scene.fence.presentation import ID
from sim.scene.problem import did_you_mean
from sim.scene.prose import PROSE

KEYS = ("id", "title", "data", "units", "law", "synthetic")
READ = {"properties": {"title": PROSE}}
"""The text that readers read, as a schema."""
SUFFIXES = (".txt", ".csv", ".tsv")
FOLDER = "data"
USUAL_TITLE = mark("Real carts beside the model")


@dataclass(frozen=True, slots=True)
class MeasuredBlock:
    """A block that makes sense. `text` and `measured` are those of the file, if there is one.

    `units`: what the lesson says of columns without units; None: the reader is asked.
    `synthetic`: a program made them, and nothing is said of them as if they were evidence.
    """

    id: str
    title: str
    name: str
    text: str
    measured: Measured | None
    units: Units | None
    law: Law
    synthetic: bool


def read_measured_block(
    block: Block, lesson: Lesson, ids: SiteIds, *, first_line: int
) -> MeasuredBlock:
    """Read it, or raise `AuthorError` with everything that is wrong."""
    source = load_block(block, lesson.file, first_line=first_line)
    reader = _Reader(source, lesson)
    reader.unknown_keys()
    identity = reader.identity()
    title, law = reader.word("title", USUAL_TITLE), reader.law()
    units, synthetic = reader.units(), reader.synthetic()
    name, text, measured = reader.readings(units or Units())
    if reader.findings:
        raise AuthorError(reader.findings)
    ids.claim(identity, Finding(lesson.file, *source.place(("id",)), "id", ""))
    return MeasuredBlock(identity, title, name, text, measured, units, law, synthetic)


class _Reader:
    """Reads key after key and collects what is wrong."""

    def __init__(self, source: Source, lesson: Lesson) -> None:
        self.source, self.lesson = source, lesson
        self.findings: list[Finding] = []

    def refuse(
        self, path: KeyPath, code: str, message: str, hint: str, *, key: bool = False
    ) -> None:
        place = self.source.key_place(path) if key else self.source.place(path)
        self.findings.append(Finding(self.lesson.file, *place, code, message, hint))

    def unknown_keys(self) -> None:
        for key in self.source.plain:
            if key not in KEYS:
                hint = did_you_mean(key, KEYS, f"a block has {', '.join(KEYS)}")
                self.refuse((key,), "unknown-key", f"{key}: unknown key “{key}”", hint, key=True)

    def identity(self) -> str:
        value = self.source.plain.get("id")
        if isinstance(value, str) and ID.fullmatch(value):
            return value
        hint = "small letters, digits and hyphens, one of its kind in the site: id: our-carts"
        if "id" in self.source.plain:
            shown = f"id: “{str(value)[:40]}” cannot be an id"
            self.refuse(("id",), "bad-name", shown, hint)
        else:
            self.refuse((), "missing", "id is missing", hint)
        return ""

    def word(self, key: str, usual: str) -> str:
        value = self.source.plain.get(key, usual)
        if isinstance(value, str):
            return value
        self.refuse((key,), "not-text", f"{key}: this is no text", f"{key}: {usual}")
        return usual

    def law(self) -> Law:
        value = self.source.plain.get("law", "bumper")
        for law in LAWS:
            if value == law:
                return law
        message = f"law: “{str(value)[:40]}” is not a law that readings are fitted with"
        self.refuse(("law",), "not-a-choice", message, f"law: {' or '.join(LAWS)}")
        return "bumper"

    def synthetic(self) -> bool:
        value = self.source.plain.get("synthetic", False)
        if isinstance(value, bool):
            return value
        self.refuse(("synthetic",), "not-a-choice", "synthetic is true or false", "synthetic: true")
        return False

    def units(self) -> Units | None:
        if "units" not in self.source.plain:
            return None
        value: Any = self.source.plain["units"]
        if not isinstance(value, dict):
            self.refuse(
                ("units",), "not-a-table", "units: this is no table", "units: {length: cm, time: s}"
            )
            return None
        chosen: dict[Any, Any] = {}
        for kind, unit in value.items():
            offered = OFFERED.get(kind)
            if offered is None:
                message = f"units.{kind}: unknown key “{kind}”"
                hint = f"units has {', '.join(OFFERED)}"
                self.refuse(("units", kind), "unknown-key", message, hint, key=True)
            elif unit not in offered:
                message = f"units.{kind}: “{str(unit)[:40]}” is not a unit of {kind} here"
                hint = f"{kind}: {', '.join(offered)}"
                self.refuse(("units", kind), "wrong-unit", message, hint)
            else:
                chosen[kind] = str(unit)
        return Units(**chosen)

    def readings(self, units: Units) -> tuple[str, str, Measured | None]:
        """Name, text and readings of the file."""
        if "data" not in self.source.plain:
            return "", "", None
        name = self.source.plain["data"]
        path = _find(name, self.lesson.scene_folders) if isinstance(name, str) else None
        if path is None:
            message = f"data: there is no file “{str(name)[:60]}” with readings"
            hint = f"a file {', '.join(SUFFIXES)} beside the lesson or in its folder {FOLDER}/"
            self.refuse(("data",), "no-such-file", message, hint)
            return "", "", None
        text = ""
        try:
            text = decoded(path.read_bytes())
            measured = read_measured([text], units)
        except ReadingError as error:
            self.findings += [
                Finding(shown_here(path), f.line, f.column(text), "readings", f.reason, f.hint)
                for f in error.faults
            ]
            return "", "", None
        return path.name, text, measured


def _find(name: str, folders: Iterable[Path]) -> Path | None:
    """The file in the first folder that has it; never outside of them."""
    relative = PurePosixPath(name)
    if relative.is_absolute() or ".." in relative.parts or relative.suffix not in SUFFIXES:
        return None
    for folder in folders:
        for path in (folder / relative, folder / FOLDER / relative):
            if path.is_file() and path.resolve().is_relative_to(folder.resolve()):
                return path
    return None
