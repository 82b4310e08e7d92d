"""A `scene` block of a lesson: from its text to a described scene, or to the author's mistakes.

A block holds either a scene written out or the name of a scene file beside the keys that say how
it is shown:

    ```scene
    id: light-meets-heavy
    file: two-carts.yml
    controls: [{set: A.mass, from: 0.5 kg, to: 5 kg, step: 0.1 kg}]
    ```
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path, PurePosixPath
from typing import Any

from sim.pages.blocks.law_files import with_law_files
from sim.pages.checks.as_typed import as_typed
from sim.pages.checks.no_forces import no_forces
from sim.pages.checks.off_track import off_track
from sim.pages.findings import AuthorError, Finding
from sim.pages.language import language_folder
from sim.pages.text.author_text import author_text, shown_here
from sim.pages.text.fence_scan import KINDS, Block, meant_kind
from sim.pages.text.yaml.source import KeyPath, Place, Source, YamlError, load
from sim.scene import Fence, Problem, SceneError, read_fence

_FAULTS = {
    "in-quote": ("a block cannot stand in a quotation", "remove the > in front of its lines"),
    "tab-indent": ("a tab character in front of the block", "indent it with spaces"),
    "less-indented": (
        "a line of this block stands further left than its first line",
        "indent all lines of the block alike",
    ),
}


@dataclass(frozen=True, slots=True)
class Lesson:
    """Where a lesson comes from: `file` as messages show it, folders of scene files and banks.

    `watch`: what scenes do that do not say it themselves; “first” in worksheets. `texts`: of banks
    that are read otherwise than they stand in their files, in another language.
    """

    file: str
    scene_folders: tuple[Path, ...] = ()
    bank_folders: tuple[Path, ...] = ()
    watch: str = ""
    texts: Mapping[Path, str] = field(default_factory=dict)


@dataclass(slots=True)
class SiteIds:
    """The ids of all scenes and questions of a site, each with the place of its first use."""

    used: dict[str, str] = field(default_factory=dict)
    exam: dict[str, str] = field(default_factory=dict)  # hashes of items, and the form they are in
    told: dict[str, str] = field(default_factory=dict)  # the same for items whose key is in a page

    def forget(self, file: str) -> None:
        """Give back everything that the page of `file` has: it is made again."""
        gone = {name for name, place in self.used.items() if place.rpartition(":")[0] == file}
        for table in (self.exam, self.told):
            for item in [item for item, form in table.items() if form in gone]:
                del table[item]
        for name in gone:
            del self.used[name]

    def claim(self, identity: str, place: Finding) -> None:
        """Take `identity` for the block at `place`; raise `AuthorError` if it is taken."""
        here = f"{place.file}:{place.line}"
        # A lesson that was translated keeps its ids: its answers are counted with the others.
        folder = language_folder(place.file)
        first = self.used.setdefault(f"{folder}/{identity}" if folder else identity, here)
        if first != here:
            message = f"id: “{identity}” is already used at {first}"
            hint = "every scene and question of the site needs an id of its own: "
            raise AuthorError([
                Finding(place.file, place.line, place.col, "id-taken", message,
                        f"{hint}in a copy, change the copy")
            ])  # fmt: skip


@dataclass(frozen=True, slots=True)
class SceneBlock:
    """A scene block that makes sense; `places` maps later problems back to the author's lines."""

    fence: Fence
    places: Places


@dataclass(frozen=True, slots=True)
class Places:
    """Where the keys of a block stand: in the lesson itself, or in the scene file it names."""

    file: str
    source: Source
    scene_file: str | None = None
    scene_source: Source | None = None

    def finding(self, problem: Problem) -> Finding:
        """The problem with its file, line and column."""
        file, source, path = self.file, self.source, problem.path
        in_scene_file = bool(path) and path[0] not in self.source.plain
        if self.scene_file and self.scene_source and in_scene_file:
            file, source = self.scene_file, self.scene_source
        line, col = _place(source, path, problem.code)
        message = f"{problem.where}: {problem.message}" if path else problem.message
        return Finding(file, line, col, problem.code, message, problem.hint)


def read_scene_block(
    block: Block,
    lesson: Lesson,
    ids: SiteIds,
    *,
    first_line: int,
    laws: Mapping[str, str] | None = None,
) -> SceneBlock:
    """The described scene of `block`; raises `AuthorError` with everything that is wrong.

    `first_line` is the line in the lesson's file of the first scanned line (counted from 1);
    `laws`: texts of laws that need no file.
    """
    source = load_block(block, lesson.file, first_line=first_line)
    plain, places = with_scene_file(source, lesson)
    try:
        fence = read_fence(with_law_files(plain, lesson.scene_folders, laws))
    except SceneError as error:
        raise AuthorError(places.finding(problem) for problem in error.problems) from None
    if found := [*off_track(fence.scene), *no_forces(fence), *as_typed(plain)]:
        raise AuthorError(map(places.finding, found))
    ids.claim(fence.id, Finding(lesson.file, *source.place(("id",)), "id", ""))
    return SceneBlock(replace(fence, watch=fence.watch or lesson.watch), places)


def load_block(block: Block, file: str, *, first_line: int) -> Source:
    """The values of any block of ours and their places; raises `AuthorError`."""
    _refuse_form(block, file, (first_line + block.start, block.body_indent + 1))
    try:
        return load(
            block.body, first_line=first_line + block.start + 1, first_col=block.body_indent + 1
        )
    except YamlError as error:
        raise AuthorError(yaml_findings(file, error)) from None


def read_scene_text(text: str, file: str) -> tuple[Mapping[str, Any], Places]:
    """The plain values of a scene file and their places; raises `AuthorError` if not YAML."""
    try:
        source = load(text)
    except YamlError as error:
        raise AuthorError(yaml_findings(file, error)) from None
    return source.plain, Places(file, source)


def _place(source: Source, path: KeyPath, code: str) -> Place:
    return source.key_place(path) if code == "unknown-key" else source.place(path)


def yaml_findings(file: str, error: YamlError) -> list[Finding]:
    """All that was found in one reading of a YAML text of this file."""
    found = (error, *error.others)
    return [Finding(file, e.line, e.col, "yaml", e.message, e.hint) for e in found]


_ANOTHER = re.compile(rf"^[ \t]*`{{3,}}[ \t]*(?:{'|'.join(KINDS)})\b", re.MULTILINE)


def _refuse_form(block: Block, file: str, place: Place) -> None:
    def refuse(code: str, message: str, hint: str) -> None:
        raise AuthorError([Finding(file, *place, code, message, hint)])

    if block.name not in KINDS:
        kind = meant_kind(block.name)
        refuse("unknown-block", f"unknown block “{block.name}”", f"did you mean “{kind}”?")
    if not block.closed:
        refuse("not-closed", "this block is never closed", "end it with a line of ```")
    if following := _ANOTHER.search(block.body):
        line = place[0] + 1 + block.body.count("\n", 0, following.start())
        refuse(
            "not-closed",
            "this block is not closed before the next one begins",
            f"write a line of ``` above line {line}",
        )
    if block.fault:
        refuse(block.fault, *_FAULTS[block.fault])
    if block.rest:
        refuse(
            "text-after-name",
            f"“{block.rest}” stands behind the name of the block",
            "write every key on a line of its own inside the block",
        )


def with_scene_file(source: Source, lesson: Lesson) -> tuple[dict[str, Any], Places]:
    """The block's keys, joined with those of the scene file that it names."""
    if "file" not in source.plain:
        return dict(source.plain), Places(lesson.file, source)

    def refuse(path: KeyPath, code: str, message: str, hint: str) -> AuthorError:
        return AuthorError([Finding(lesson.file, *source.key_place(path), code, message, hint)])

    name = source.plain["file"]
    path = found_in(name, lesson.scene_folders) if isinstance(name, str) else None
    if path is None:
        raise refuse(
            ("file",),
            "no-such-file",
            f"there is no scene file “{name}”",
            f"looked in: {', '.join(map(shown_here, lesson.scene_folders)) or 'no folder'}",
        )
    shown = shown_here(path)
    try:
        scene = load(author_text(path, shown))
    except YamlError as error:
        raise AuthorError(yaml_findings(shown, error)) from None
    own = {key: value for key, value in source.plain.items() if key != "file"}
    if twice := sorted(set(own) & set(scene.plain)):
        raise refuse(
            (twice[0],),
            "twice",
            f"“{twice[0]}” stands here and in {name}",
            "remove one of them",
        )
    return {**scene.plain, **own}, Places(lesson.file, source, shown, scene)


SCENE_FILES = (".yml", ".yaml")


def found_in(
    name: str, folders: Iterable[Path], endings: tuple[str, ...] = SCENE_FILES
) -> Path | None:
    """The file called `name` in the first of `folders` that has it; never outside of them."""
    relative = PurePosixPath(name)
    if relative.is_absolute() or ".." in relative.parts or relative.suffix not in endings:
        return None
    for folder in folders:
        path = folder / relative
        if path.is_file() and path.resolve().is_relative_to(folder.resolve()):
            return path
    return None
