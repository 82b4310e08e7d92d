"""Teacher mode's side of the wire: the lesson's text comes, what the build would say and show goes.

    {"kind": "teach", "do": "look", "text": "…", "lesson": {…}, "files": {…}, "have": ["…"]}
    {"kind": "teach", "do": "set", "text": "…", "block": 2, "path": ["carts", "A", "mass"],
     "value": "2 kg"}
    {"kind": "teach", "do": "restore", "text": "…", "own": "…"}
    {"kind": "teach", "do": "zip", "file": "…", "text": "…", "published": "…"}

Every request is whole. `lesson` is what the build wrote beside the text (publish.py). `have` are
the keys of blocks whose HTML the page has already.
"""

from __future__ import annotations

import os
from array import array
from collections.abc import Callable, Mapping
from pathlib import Path, PurePosixPath
from typing import Any

from sim.pages.blocks.scene_block import Lesson
from sim.pages.question.challenge import usual_id
from sim.pages.teach.doubt import doubt
from sim.pages.teach.edit import CannotWriteError, with_value
from sim.pages.teach.fields import TRUTH, fields
from sim.pages.teach.frame import Site
from sim.pages.teach.pieces import Piece, pieces
from sim.pages.teach.preview import NUMERICS, Desk, Shown
from sim.pages.teach.right_answers import is_rightness, with_right
from sim.pages.teach.spans import values
from sim.pages.teach.take_home import zipped
from sim.pages.teach.withheld import restore
from sim.pages.text.fence_scan import Block
from sim.pages.text.yaml.source import KeyPath

DESK = "lesson-desk"
"""A folder in the memory of the page's Python: files that the lesson names lie there."""

SLICE = 0.6
"""s. How long a page waits for a look; what is not made by then is made at the next one."""

_desk = Desk()
_laid: dict[str, str] = {}


def teach_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """The header of the answer; there are no numbers beside it."""
    ways: dict[str, Callable[[Mapping[str, Any]], dict[str, Any]]] = {
        "look": _look,
        "set": _set,
        "restore": _restore,
        "zip": _zip,
    }
    return ways[str(request.get("do"))](request), array("d")


def _look(request: Mapping[str, Any]) -> dict[str, Any]:
    """Pieces with their fields, findings, and the page's parts that are new."""
    text, told = str(request["text"]), request["lesson"]
    _lay_out(request.get("files") or {}, told.get("names") or ())
    site = Site(
        told.get("ids") or {},
        told.get("extensions") or (),
        told.get("configs") or {},
        told.get("words") or {},
    )
    preview = _desk.look(text, lesson_of(told), site, seconds=SLICE)
    have = set(request.get("have") or ())
    return {
        "pieces": [_piece(text, piece) for piece in pieces(text)],
        "findings": [finding.as_row() for finding in preview.findings],
        "frame": preview.frame,
        "blocks": [_shown(block, have) for block in preview.blocks],
        "more": any(block.state == "later" for block in preview.blocks),
        "needs": list(NUMERICS) if any(b.state == "needs" for b in preview.blocks) else [],
    }


def lesson_of(told: Mapping[str, Any]) -> Lesson:
    """Where the lesson comes from, with folders counted from the site's root."""
    scenes, banks = (tuple(map(Path, told.get(kind) or ())) for kind in ("scenes", "banks"))
    return Lesson(str(told["file"]), scenes, banks, watch="first")


def _set(request: Mapping[str, Any]) -> dict[str, Any]:
    try:
        text = _changed(
            str(request["text"]), int(request["block"]), tuple(request["path"]),
            str(request["value"]),
        )  # fmt: skip
    except CannotWriteError as error:
        return {"refused": str(error)}
    return {"text": text}


def _changed(text: str, block: int, path: KeyPath, value: str) -> str:
    if asked := doubt(path, value):
        raise CannotWriteError(asked)
    if is_rightness(path) and value in TRUTH:
        return with_right(text, block, int(path[1]), right=value == "true")
    return with_value(text, block, path, value)


def _restore(request: Mapping[str, Any]) -> dict[str, Any]:
    text, missing = restore(str(request["text"]), str(request["own"]))
    return {"text": text, "missing": missing}


def _zip(request: Mapping[str, Any]) -> dict[str, Any]:
    return {"base64": zipped(str(request["file"]), str(request["text"]), str(request["published"]))}


def _piece(text: str, piece: Piece) -> dict[str, Any]:
    row: dict[str, Any] = {
        "kind": piece.kind,
        "text": text[piece.start : piece.end],
        "line": piece.line,
    }
    if piece.block:
        named = {v.path[0]: v.value for v in values(text, piece.block) if len(v.path) == 1}
        row |= {
            "name": piece.block.name,
            "id": str(named.get("id") or _usual_id(piece.block, named)),
            "title": str(named.get("title") or named.get("ask") or ""),
            "fields": [field.as_row() for field in fields(text, piece.block)],
        }
    return row


def _usual_id(block: Block, named: Mapping[Any, str]) -> str:
    """The id of a block that states none."""
    return usual_id(named.get("scene", "")) if block.name == "challenge" else ""


def _shown(block: Shown, have: set[str]) -> dict[str, Any]:
    row: dict[str, Any] = {"state": block.state}
    if block.state == "shown":
        row |= {"key": block.key, "html": None if block.key in have else block.html}
    return row


def _lay_out(files: Mapping[str, str], names: Any) -> None:
    """Put files where the validators look for them; where they are only linked to, names do."""
    here = Path.cwd()
    if here.name != DESK:
        (here / DESK).mkdir(exist_ok=True)
        os.chdir(here / DESK)
    wanted = {**dict.fromkeys(map(str, names), ""), **files}
    for name, content in wanted.items():
        path = PurePosixPath(name)
        if path.is_absolute() or ".." in path.parts or _laid.get(name) == content:
            continue
        Path(path).parent.mkdir(parents=True, exist_ok=True)
        Path(path).write_text(content, encoding="utf-8", newline="")
        _laid[name] = content
