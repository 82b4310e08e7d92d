"""A lesson as the build would make it: every block by the generator's own code, and every finding.

What takes long (running a scene, writing out its element) is remembered by the block's own text, so
that a change in one block costs one block.
"""

from __future__ import annotations

import hashlib
import math
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

from sim.pages.blocks.bake import bake
from sim.pages.blocks.scene_block import Lesson, SiteIds, load_block, read_scene_block
from sim.pages.findings import AuthorError, Finding
from sim.pages.language import speaking
from sim.pages.question import PageItems, read_question_block, read_quiz_block
from sim.pages.question.challenge import read_challenge_block
from sim.pages.teach.frame import Site, frame_of
from sim.pages.text.fence_scan import Block, scan
from sim.pages.text.held_back import mark_held
from sim.pages.text.lesson_text import minutes_last, text_findings
from sim.pages.text.plain_lines import lines_of, without_code
from sim.pages.text.sections import in_sections
from sim.scene import Problem

State = Literal["shown", "wrong", "kept", "needs", "later"]
MOST_REMEMBERED = 200
NUMERICS = ("numpy", "scipy")


@dataclass(frozen=True, slots=True)
class Shown:
    """One block: `shown` as `html`; `wrong` (findings say why); `kept` as it is on the page,
    because only the build can make it; or it `needs` packages that this Python does not have; or it
    comes `later`, when the time for this look was over."""

    state: State
    html: str = ""

    @property
    def key(self) -> str:
        """A name for exactly this HTML."""
        return hashlib.sha256(self.html.encode()).hexdigest()[:16]


@dataclass(frozen=True, slots=True)
class Preview:
    """`frame`: the text between the blocks as HTML, with `<carts-place data-block="0">` for the
    first block, and so on. None where it cannot be made here."""

    findings: tuple[Finding, ...]
    blocks: tuple[Shown, ...]
    frame: str | None


class _LaterError(Exception):
    """The time for this look is over."""


@dataclass(slots=True)
class Desk:
    """Makes previews, and remembers what it made."""

    made: dict[str, str | list[Problem]] = field(default_factory=dict)
    until: float = math.inf

    def look(self, text: str, lesson: Lesson, site: Site, *, seconds: float = math.inf) -> Preview:
        """The lesson as it is now. What is not made within `seconds` is made at the next look."""
        self.until = time.monotonic() + seconds
        ids, items = SiteIds(used=dict(site.ids)), PageItems()
        found: list[Finding] = []
        shown = []
        lines = lines_of(text)
        read = "\n".join(lines)  # as the build reads the file, however it was saved
        marked, plain, done = list(lines), without_code(read).split("\n"), 0
        parts = tuple(scan(lines))
        for block, section in in_sections(lines, parts):
            mark_held(marked, plain, done, block.start, items.asking, items.scene_ids)
            done = block.end
            if section.new:
                items.asking = ""
            try:
                with speaking(site.words):
                    shown.append(self._block(block, lesson, ids, items, parts))
            except AuthorError as error:
                items.give_up(block)
                found += error.findings
                shown.append(Shown("wrong"))
            except _LaterError:
                shown.append(Shown("later"))
            except ModuleNotFoundError as error:
                if (error.name or "").split(".")[0] not in NUMERICS:
                    raise
                shown.append(Shown("needs"))
        mark_held(marked, plain, done, len(lines), items.asking, items.scene_ids)
        found = [*items.first_causes(found), *text_findings(read, lesson)]
        return Preview(
            tuple(minutes_last(found)), tuple(shown), frame_of(marked, parts, items, site)
        )

    def _block(
        self,
        block: Block,
        lesson: Lesson,
        ids: SiteIds,
        items: PageItems,
        parts: tuple[Block, ...],
    ) -> Shown:
        if block.name == "question":
            return self._question(block, lesson, ids, items)
        if block.name == "quiz":
            return self._quiz(block, lesson, ids, items)
        if block.name == "challenge":
            from sim.pages.question.render import render_challenge

            read = read_challenge_block(block, lesson, ids, items.scenes, first_line=1)
            return Shown("shown", render_challenge(read))
        if block.name == "map":
            return self._map(block, lesson, ids, parts)
        if block.name == "measured":
            return self._measured(block, lesson, ids)
        if meant_elsewhere(block):
            load_block(block, lesson.file, first_line=1)
            return Shown("kept")
        # As in the build, a block that is none of ours is refused where scenes are read.
        return self._scene(block, lesson, ids, items)

    def _scene(self, block: Block, lesson: Lesson, ids: SiteIds, items: PageItems) -> Shown:
        from sim.pages.widget import render

        read = read_scene_block(block, lesson, ids, first_line=1)

        def make() -> str | list[Problem]:
            run = bake(read.fence.plain)
            if isinstance(run, list):
                return run
            return render(read.fence, run.header, run.numbers, drawn=False)

        items.scenes.append(read.fence)
        asking = items.asking
        if read.fence.predict:
            items.asking = read.fence.id
        made = self._remembered(f"scene {block.body}\n{read.fence.plain}", make)
        if isinstance(made, list):
            items.scenes.remove(read.fence)
            items.asking = asking
            raise AuthorError(map(read.places.finding, made))
        return Shown("shown", made)

    def _question(self, block: Block, lesson: Lesson, ids: SiteIds, items: PageItems) -> Shown:
        from sim.pages.question.render import render_question

        read = read_question_block(block, lesson, ids, first_line=1)
        items.ask(read)
        number = len(items.questions)
        made = self._remembered(
            f"question {number} {block.body}", lambda: render_question(read.question, number=number)
        )
        return Shown("shown", str(made))

    def _quiz(self, block: Block, lesson: Lesson, ids: SiteIds, items: PageItems) -> Shown:
        """Banks stay out of the page, with their keys: then the form stands as it was built."""
        from sim.pages.question.render import render_quiz

        source = load_block(block, lesson.file, first_line=1)
        bank = source.plain.get("bank")
        if isinstance(bank, str) and not lesson.bank_folders:
            return Shown("kept")
        read = read_quiz_block(block, lesson, ids, first_line=1)
        items.quizzes.append(read)
        return Shown("shown", render_quiz(read.form))

    def _map(self, block: Block, lesson: Lesson, ids: SiteIds, parts: tuple[Block, ...]) -> Shown:
        from sim.pages.map.bake import bake_map
        from sim.pages.map.block import read_map_block
        from sim.pages.map.render import render_map

        read = read_map_block(block, lesson, ids, first_line=1, blocks=parts)

        def make() -> str | list[Problem]:
            run = bake_map(read.map, read.plain)
            return (
                run if isinstance(run, list) else render_map(read.map, read.plain, run, drawn=False)
            )

        made = self._remembered(f"map {block.body}\n{read.plain}", make)
        if isinstance(made, list):
            raise AuthorError(map(read.places.finding, made))
        return Shown("shown", made)

    def _measured(self, block: Block, lesson: Lesson, ids: SiteIds) -> Shown:
        from sim.pages.measured.block import read_measured_block
        from sim.pages.measured.render import render_measured

        read = read_measured_block(block, lesson, ids, first_line=1)
        return Shown("shown", render_measured(read, drawn=False))

    def _remembered(
        self, what: str, make: Callable[[], str | list[Problem]]
    ) -> str | list[Problem]:
        made = self.made.pop(what, None)
        if made is None:
            if time.monotonic() > self.until:
                raise _LaterError
            made = make()
        self.made[what] = made  # the newest last
        while len(self.made) > MOST_REMEMBERED:
            del self.made[next(iter(self.made))]
        return made


def meant_elsewhere(block: Block) -> bool:
    """Blocks that only the build can make: they compute for long, or read other files."""
    return block.name in ("cost", "hard-cases", "evidence", "law", "picture")
