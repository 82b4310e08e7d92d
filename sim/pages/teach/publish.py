"""A lesson's text for its own page: what is shipped, under which name, and the link at its foot.

The text is a script that only teacher mode loads: gzip in base64, like all that a page on file://
has to read. What is for the teacher alone is withheld (`withheld.py`). A lesson with an exam ships
no text at all: the words that open a form stand in it. Its teacher opens the file instead.
"""

from __future__ import annotations

import base64
import contextlib
import hashlib
import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import quote

from sim.pages.blocks.scene_block import Lesson, SiteIds, load_block, with_scene_file
from sim.pages.findings import AuthorError
from sim.pages.gzipped import gzipped
from sim.pages.measured.block import read_measured_block
from sim.pages.teach.pieces import blocks
from sim.pages.teach.spans import values
from sim.pages.teach.withheld import withhold
from sim.pages.text.fence_scan import KINDS
from sim.pages.text.lesson_places import JOINING, is_hidden, scene_folders
from sim.scene.reading.written import named_laws

FORMAT = 1
FOLDER = "lessons/"  # in assets/carts/
LINKED = (".md", *JOINING, ".csv")  # tables only where all files join the site, in docs/
DOOR = (
    '<p class="carts-teach-door" id="teacher"><a href="#teacher" data-lesson="{address}">'
    "Change this lesson</a> <span>for teachers: scenes, questions and text, in this page</span></p>"
)


@dataclass(frozen=True, slots=True)
class Published:
    """The script `name` (in assets/carts/) with all that teacher mode needs to know of a lesson."""

    name: str
    script: bytes

    def door(self, assets: str) -> str:
        """The link at the foot of the lesson; `assets` leads from its page to assets/carts/."""
        return DOOR.format(address=quote(assets + self.name))


def published(
    path: Path,
    root: Path,
    *,
    ids: Mapping[str, str],
    extensions: Iterable[object],
    configs: Mapping[str, Any],
    words: Mapping[str, str],
    whole: bool = False,
) -> Published | None:
    """What is shipped of the lesson at `path`; None if it is no text.

    `ids`: of all blocks of the site, with their places. `extensions`, `configs`: the generator's.
    `words`: the interface words in the lesson's language, as `sim.pages.language` has them.
    `whole`: with what is for the teacher alone, where nobody else can see the page.
    """
    try:
        text = path.read_bytes().decode("utf-8")
    except UnicodeDecodeError:
        return None
    file = path.relative_to(root).as_posix()
    folders = scene_folders(path, root)
    closed = has_secrets(text)
    shipped = text if whole else withhold(text)
    told = {
        "format": FORMAT,
        "file": file,
        "text": None if closed else shipped,
        "hash": hashlib.sha256(text.encode("utf-8")).hexdigest(),
        "files": {} if closed else _named_files(text, Lesson(file, folders), root),
        "lesson": {
            "file": file,
            "scenes": [f.relative_to(root).as_posix() for f in folders if f.is_relative_to(root)],
            "banks": [],
            "ids": {i: at for i, at in ids.items() if at.rpartition(":")[0] != file},
            "names": _names(root, path.parent),
            "extensions": [name for name in extensions if isinstance(name, str)],
            "configs": _plain(configs),
            "words": dict(words),
        },
    }
    return _script(path.stem, told)


def has_secrets(text: str) -> bool:
    """Whether a form in this lesson is an exam, or a word that is said in class opens it."""
    for block in blocks(text):
        if block.name != "quiz":
            continue
        found = values(text, block)
        practice = any(v.path == ("mode",) and v.value == "practice" for v in found)
        if not practice or any("word" in v.path for v in found):
            return True
    return False


def _script(stem: str, told: Mapping[str, Any]) -> Published:
    text = json.dumps(told, ensure_ascii=False, separators=(",", ":"), sort_keys=True)
    packed = base64.b64encode(gzipped(text.encode("utf-8"))).decode("ascii")
    script = f'self.__cartsLesson="{packed}";\n'.encode()
    digest = hashlib.sha256(script).hexdigest()[:12]
    return Published(f"{FOLDER}{stem}.{digest}.js", script)


def _named_files(text: str, lesson: Lesson, root: Path) -> dict[str, str]:
    """The scene files, readings and laws that blocks name, by their path."""
    found = {}
    for block in blocks(text):
        if block.name not in KINDS:
            continue
        try:
            source = load_block(block, lesson.file, first_line=1)
            if block.name == "measured":
                read_measured_block(block, lesson, SiteIds(), first_line=1)
            else:
                with_scene_file(source, lesson)
        except AuthorError:
            continue  # it is refused, so nothing is read for it
        own = source.plain.get("data" if block.name == "measured" else "file")
        laws = [law for _, law in named_laws(source.plain.get("contact"))]
        for name in ([own] if isinstance(own, str) else []) + laws:
            places = [f / part / name for f in lesson.scene_folders for part in (".", "data")]
            path = next((place for place in places if place.is_file()), None)
            if path:
                with contextlib.suppress(UnicodeDecodeError):
                    found[path.relative_to(root).as_posix()] = path.read_bytes().decode("utf-8")
    return found


def _names(root: Path, lessons: Path) -> Sequence[str]:
    """What a lesson may link to: pages and pictures of the site."""
    found = (p for folder in (root / "docs", lessons) for p in folder.rglob("*"))
    kept = (p.relative_to(root) for p in found if p.suffix.lower() in LINKED and p.is_file())
    return sorted(p.as_posix() for p in kept if not is_hidden(p))


def _plain(configs: Mapping[str, Any]) -> dict[str, Any]:
    """Settings of extensions that can be written down; a preview does without the others."""
    kept = {}
    for name, settings in configs.items():
        try:
            kept[name] = json.loads(json.dumps(settings))
        except (TypeError, ValueError):
            continue
    return kept
