"""A `law` block: a scene, and the law that its reader begins with.

```law
id: my-law
ask: Write a law in which the heavier cart pushes harder.
start: |
  def force(overlap, rate, stiffness):
      return stiffness * overlap
carts:
  A: {mass: 2 kg, position: 0.4 m, velocity: 0.4 m/s}
  B: {mass: 0.5 kg, position: 1.2 m}
until: 3 s
```

In place of `start` a contact may name a file beside the lesson: `contact: {law: mine.py}`.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sim.lesson.kinds.unformatted import unformatted
from sim.pages.blocks.law_files import with_law_files
from sim.pages.blocks.scene_block import Lesson, Places, SiteIds, load_block
from sim.pages.findings import AuthorError, Finding
from sim.pages.language import mark
from sim.pages.text.fence_scan import Block
from sim.scene import Fence, Problem, SceneError, read_fence
from sim.scene.laws import is_written
from sim.scene.prose import PROSE

KEYS = ("id", "ask", "start")
"""Beside those of a scene."""

READ = {"properties": {"ask": PROSE}}
"""The text that readers read, as a schema."""

FILE = "mine.py"
ASK = mark("Write a law of your own.")


@dataclass(frozen=True, slots=True)
class LawBlock:
    """`fence`: the scene with the law that the reader begins with; `file`: what it is called."""

    id: str
    ask: str
    file: str
    start: str
    fence: Fence
    places: Places

    @property
    def hash(self) -> str:
        """Twelve hexadecimal digits that change when what is asked does."""
        plain = {key: str(value) for key, value in self.fence.plain.items()}
        text = json.dumps([self.ask, plain], ensure_ascii=False, sort_keys=True)
        return hashlib.sha256(text.encode("utf-8")).hexdigest()[:12]

    def finding(self, problem: Problem) -> Finding:
        """With its place: a line of the law is one of the lesson, where the law stands in it."""
        if problem.path[:1] == ("laws",) and "start" in self.places.source.plain:
            line, _ = self.places.source.place(("start",))
            row = line + int(problem.path[-1])
            return Finding(self.places.file, row, 1, problem.code, problem.message, problem.hint)
        return self.places.finding(problem)


def read_law_block(block: Block, lesson: Lesson, ids: SiteIds, *, first_line: int) -> LawBlock:
    """Read it; raises `AuthorError` with everything that is wrong."""
    source = load_block(block, lesson.file, first_line=first_line)
    places = Places(lesson.file, source)
    plain = dict(source.plain)
    own = {key: plain.pop(key) for key in KEYS if key in plain}
    ask, start = own.get("ask", ASK), own.get("start")
    problems = [
        Problem((key,), "not-text", f"{key} is a text", hint)
        for key, value, hint in (("ask", ask, f"ask: {ASK}"), ("start", start or "", "start: |"))
        if not isinstance(value, str)
    ]
    contact = plain.get("contact", {})
    table: Mapping[str, Any] = contact if isinstance(contact, Mapping) else {}
    file = table.get("law")
    if start is not None and file is not None:
        message = "the law that a reader begins with stands here and in a file"
        problems.append(Problem(("start",), "twice", message, "remove start, or law"))
    elif start is None and not is_written(file):
        message = "a law block needs the law that its reader begins with"
        hint = "start: |, and below it: def force(overlap, rate):"
        problems.append(Problem(("start",), "missing", message, hint))
    elif start is not None:
        file = FILE
        plain["contact"] = {**table, "law": FILE}
        plain["laws"] = {FILE: start}
    unformatted(own, (), problems, ("ask",))
    if problems:
        raise AuthorError(map(places.finding, problems))
    plain = with_law_files(plain, lesson.scene_folders)
    try:
        fence = read_fence({"id": own.get("id"), **plain} if "id" in own else plain)
    except SceneError as error:
        raise AuthorError(places.finding(problem) for problem in error.problems) from None
    if file not in fence.scene.written:
        where = ("start",) if start is not None else ("contact", "law")
        message = "no two carts of this scene push each other by this law"
        hint = "the law of the block is that of its contact: two carts without a law of their own"
        raise AuthorError([places.finding(Problem(where, "no-pair", message, hint))])
    ids.claim(fence.id, Finding(lesson.file, *source.place(("id",)), "id", ""))
    text = fence.scene.written[str(file)]
    return LawBlock(fence.id, str(ask), str(file), text, fence, places)
