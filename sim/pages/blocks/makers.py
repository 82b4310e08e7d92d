"""From a block of a lesson to its HTML: one maker for each name that a block can have."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from html import escape

from sim.pages.blocks.bake import bake
from sim.pages.blocks.scene_block import Lesson, SceneBlock, SiteIds, read_scene_block
from sim.pages.drawing import DrawingError
from sim.pages.findings import AuthorError, Finding
from sim.pages.language import ENGLISH, speaking, words
from sim.pages.map.block import read_map_block
from sim.pages.question import PageItems, read_question_block, read_quiz_block
from sim.pages.question.challenge import read_challenge_block
from sim.pages.question.on_page import FORCES
from sim.pages.text.fence_scan import Block
from sim.pages.text.sections import Section

WITHOUT_ID = ("picture", "evidence")
"""Teacher mode finds these in the page by their number among its blocks."""


@dataclass(slots=True)
class Page:
    """One page in the making. `first_line`: the line of the file that the Markdown begins with."""

    lesson: Lesson
    first_line: int = 1
    ids: SiteIds = field(default_factory=SiteIds)
    report: Callable[[Finding], None] | None = None
    scenes: int = 0
    pictures: int = 0
    title: str = ""  # its first heading
    section: Section = field(default_factory=Section)  # where the block that is made stands
    packages: set[str] = field(default_factory=set)
    blocks: tuple[Block, ...] = ()
    items: PageItems = field(default_factory=PageItems)
    language: str = ENGLISH
    late: dict[str, str] | None = None  # what is to be put in after the theme's work; None: nothing
    prepares: bool = False  # whether runs are prepared for its sliders
    prepared: dict[str, str] = field(default_factory=dict)  # scripts that hold them, by name


def made(block: Block, page: Page) -> str:
    """The HTML of a block in the page's language; raises `AuthorError`."""
    with speaking(words(page.language)):
        try:
            html = MAKERS.get(block.name, _scene)(block, page)
            if block.name in WITHOUT_ID and block in page.blocks:
                html = html.replace("<div", f'<div data-block="{page.blocks.index(block)}"', 1)
            return with_headings(html, page.section.level + 1)
        except DrawingError as error:
            line = page.first_line + block.start
            finding = Finding(page.lesson.file, line, 1, "not-drawn", str(error), "")
            raise AuthorError([finding]) from error


def with_headings(html: str, level: int) -> str:
    """Titles of scenes and numbers of questions as headings of that level: who hears the page goes
    from one to the next."""
    for name in ("carts-title", "carts-q-number"):
        mark = f'class="{name}"'
        html = html.replace(mark, f'{mark} role="heading" aria-level="{level}"')
    return html


def _scene(block: Block, page: Page) -> str:
    """A `scene` block; it also says what is wrong with the form of any other."""
    return _widget(read_scene_block(block, page.lesson, page.ids, first_line=page.first_line), page)


def _question(block: Block, page: Page) -> str:
    """A `question` block, numbered through the page."""
    from sim.pages.question.render import render_question

    read = read_question_block(block, page.lesson, page.ids, first_line=page.first_line)
    page.items.ask(read)
    if page.section.optional:
        page.items.optional.add(read.question.id)
    gate = page.items.gate(read.question)
    number = len(page.items.questions)
    return render_question(
        read.question,
        number=number,
        after=gate,
        runs=page.items.runs(gate),
        found=read.question.common.after.endswith(FORCES),
    )


def _quiz(block: Block, page: Page) -> str:
    """A `quiz` block: a form of items from a bank."""
    from sim.pages.question.render import render_quiz

    read = read_quiz_block(block, page.lesson, page.ids, first_line=page.first_line)
    page.items.quizzes.append(read)
    return render_quiz(read.form)


def _challenge(block: Block, page: Page) -> str:
    """A `challenge` block: a goal for the runs of a scene above."""
    from sim.pages.question.render import render_challenge

    scenes = page.items.scenes
    return render_challenge(
        read_challenge_block(block, page.lesson, page.ids, scenes, first_line=page.first_line)
    )


def _map(block: Block, page: Page) -> str:
    """A `map` block: its figure, and what the page needs to compute it anew."""
    from sim.pages.map.bake import bake_map
    from sim.pages.map.render import render_map

    read = read_map_block(
        block, page.lesson, page.ids, first_line=page.first_line, blocks=page.blocks
    )
    run = bake_map(read.map, read.plain)
    if isinstance(run, list):
        raise AuthorError(map(read.places.finding, run))
    page.scenes += 1
    page.packages |= set(run.packages)
    made = render_map(read.map, read.plain, run)
    return made.replace("<carts-map", "<carts-map data-search-exclude", 1)


def _cost(block: Block, page: Page) -> str:
    """A `cost` block: stepping methods beside the exact solution."""
    from sim.pages.cost.block import read_cost_block
    from sim.pages.cost.render import render_cost

    read = read_cost_block(block, page.lesson, page.ids, first_line=page.first_line)
    page.scenes += 1
    page.packages |= {"numpy", "scipy"}
    return render_cost(read).replace("<carts-cost", "<carts-cost data-search-exclude", 1)


def _hard_cases(block: Block, page: Page) -> str:
    """A `hard-cases` block: the table of scenes that break step-by-step engines."""
    from sim.pages.hard_cases.block import read_hard_cases_block
    from sim.pages.hard_cases.render import render_hard_cases

    read = read_hard_cases_block(block, page.lesson, page.ids, first_line=page.first_line)
    page.scenes += 1
    page.packages |= {"numpy", "scipy"}
    return render_hard_cases(read).replace("<carts-hard", "<carts-hard data-search-exclude", 1)


def _measured(block: Block, page: Page) -> str:
    """A `measured` block: readings of real carts beside the model."""
    from sim.pages.measured.block import read_measured_block
    from sim.pages.measured.render import render_measured

    read = read_measured_block(block, page.lesson, page.ids, first_line=page.first_line)
    made = render_measured(read)
    return made.replace("<carts-measured", "<carts-measured data-search-exclude", 1)


def _evidence(block: Block, page: Page) -> str:
    """An `evidence` block: a table of the paper."""
    from sim.pages.classroom.evidence import evidence_block

    return evidence_block(block, page.lesson, first_line=page.first_line)


def _law(block: Block, page: Page) -> str:
    """A `law` block: a law of force that a reader writes."""
    from sim.pages.law.block import read_law_block
    from sim.pages.law.render import render_law

    read = read_law_block(block, page.lesson, page.ids, first_line=page.first_line)
    run = bake(read.fence.plain)
    if isinstance(run, list):
        raise AuthorError(map(read.finding, run))
    page.items.laws.append((read.id, read.hash))
    page.packages |= run.packages
    return render_law(read, run).replace("<carts-law", "<carts-law data-search-exclude", 1)


def _picture(block: Block, page: Page) -> str:
    """A `picture` block: the carts of a scene at one instant. Nothing is loaded for it."""
    from sim.pages.picture.block import read_picture_block
    from sim.pages.picture.render import render_picture

    read = read_picture_block(block, page.lesson, first_line=page.first_line)
    page.pictures += 1
    made = render_picture(read, page.pictures)
    return made.replace("<div", "<div data-search-exclude", 1)


MAKERS: dict[str, Callable[[Block, Page], str]] = {
    "scene": _scene,
    "map": _map,
    "cost": _cost,
    "hard-cases": _hard_cases,
    "question": _question,
    "quiz": _quiz,
    "challenge": _challenge,
    "evidence": _evidence,
    "measured": _measured,
    "law": _law,
    "picture": _picture,
}


def _widget(block: SceneBlock, page: Page) -> str:
    """The live scene as HTML, with its default run; raises `AuthorError` if it cannot run."""
    from sim.pages.prepared import prepare
    from sim.pages.widget import render  # Jinja2 and its templates: only where a scene is drawn
    from sim.pages.widget.worlds import WORLDS

    run = bake(block.fence.plain)
    if isinstance(run, list):
        raise AuthorError(map(block.places.finding, run))
    page.scenes += 1
    page.items.scenes.append(block.fence)
    if block.fence.predict:
        page.items.asking = block.fence.id
    own = {WORLDS} if block.fence.worlds else set()
    page.packages |= run.packages | set(block.fence.packages) | own
    made = render(block.fence, run.header, run.numbers)
    if page.prepares and (found := prepare(block.fence, run)):
        page.prepared.update(found.scripts)
        told = escape(json.dumps({"parts": found.parts, "stops": found.stops}))
        made = made.replace("<carts-scene", f'<carts-scene data-prepared="{told}"', 1)
    # Readings of a run are no words to search for, and must not give an answer away. The theme
    # leaves out an element with this mark; it must be one that does not occur inside itself.
    return made.replace("<carts-scene", "<carts-scene data-search-exclude", 1)
