"""Every author's mistake in lessons and scene files, found without building the site."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from sim.pages.blocks.bake import bake
from sim.pages.blocks.law_files import with_law_files
from sim.pages.blocks.scene_block import Lesson, SiteIds, read_scene_block, read_scene_text
from sim.pages.checks.blocks import CHECKS, Around
from sim.pages.checks.heading_ids import heading_ids
from sim.pages.checks.hidden_forces import forces_nobody_finds
from sim.pages.checks.large_numbers import large_numbers
from sim.pages.checks.left_over import left_over
from sim.pages.checks.markdown_slips import markdown_slips
from sim.pages.checks.never_touch import forces_that_never_act
from sim.pages.checks.preset_reach import presets_beyond_sliders
from sim.pages.checks.quoted_options import quoted_options
from sim.pages.checks.relevance import relevance_hints
from sim.pages.checks.steep import steep_slopes
from sim.pages.checks.titles_twice import title_twice
from sim.pages.checks.unbuilt import makes_page, no_lesson, no_page, no_text
from sim.pages.findings import AuthorError, Finding
from sim.pages.question import PageItems, read_question_block, read_quiz_block
from sim.pages.question.by_default import open_by_default, waits_by_default, watched_by_default
from sim.pages.question.challenge import read_challenge_block
from sim.pages.question.closed import closed_already
from sim.pages.question.quiz import read_bank_text
from sim.pages.teach.withheld import withheld_findings
from sim.pages.text.author_text import author_text
from sim.pages.text.fence_scan import Block, scan
from sim.pages.text.lesson_places import BANK_FOLDER, LESSONS, described, is_hidden, shown
from sim.pages.text.lesson_text import minutes_last, text_findings
from sim.pages.text.plain_lines import lines_of
from sim.pages.text.sections import in_sections
from sim.pages.translate.check import catalogue_findings
from sim.pages.translate.translation import Translation
from sim.scene import SceneError, read_fence

LESSON_SUFFIXES = (".md",)
HIDDEN_SUFFIX = ".md.txt"  # an editor adds it, a file manager hides it
NEAR_SUFFIXES = (".md", ".markdown", ".mdown", ".mdwn", ".mkd", ".mkdn")  # .MD too: as no lesson
OFFICE_SUFFIXES = (".docx", ".doc", ".odt", ".rtf", ".pages")  # inside, they are no plain text
WRITTEN = (*OFFICE_SUFFIXES, ".text", ".txt")  # by a program for letters
SCENE_SUFFIXES = (".yml", ".yaml")
USUAL_PLACES = ("worksheets", "docs", "tests/scenes", "sim/effects")


def check_lesson(text: str, lesson: Lesson, ids: SiteIds, *, hints: bool = False) -> list[Finding]:
    """Everything that is wrong with the blocks of one lesson, in the order of its lines.

    `hints`: also effects of a scene that it hardly calls for, missing ones that it does, and what
    is so by default.
    """
    findings: list[Finding] = []
    items = PageItems()
    lines = lines_of(text)
    blocks = tuple(scan(lines))
    around = Around(lesson, ids, blocks)
    for block, section in in_sections(lines, blocks):
        if section.new:
            items.asking = ""
        try:
            if check := CHECKS.get(block.name):
                check(block, around)
            else:
                findings += _read(block, lesson, ids, items, hints=hints)
                if hints and block.name == "scene" and (asking := items.scenes[-1]).predict:
                    findings += open_by_default(lines, blocks, block, asking.id, lesson.file)
        except AuthorError as error:
            items.give_up(block)
            findings += error.findings
    of_text = [*text_findings(text, lesson), *heading_ids(text, lesson.file, ids)]
    return minutes_last([*items.first_causes(findings), *of_text])


def _read(
    block: Block, lesson: Lesson, ids: SiteIds, items: PageItems, *, hints: bool
) -> list[Finding]:
    """Read one block and add it to `items`, and give hints; raises `AuthorError`."""
    if block.name == "question":
        items.ask(read_question_block(block, lesson, ids, first_line=1))
        return waits_by_default(items.questions[-1], items) if hints else []
    if block.name == "challenge":
        read_challenge_block(block, lesson, ids, items.scenes, first_line=1)
        return []
    if block.name == "quiz":
        items.quizzes.append(read_quiz_block(block, lesson, ids, first_line=1))
        return closed_already(items.quizzes[-1]) if hints else []
    scene = read_scene_block(block, lesson, ids, first_line=1)
    run = bake(scene.fence.plain)
    if isinstance(run, list):
        raise AuthorError(map(scene.places.finding, run))
    items.scenes.append(scene.fence)
    if scene.fence.predict:
        items.asking = scene.fence.id
    found = [
        *forces_nobody_finds(scene, run.header),
        *forces_that_never_act(scene, run.header),
    ]
    if hints:
        called_for = relevance_hints(scene.fence.scene, scene.places)
        doubts = [*presets_beyond_sliders(scene), *steep_slopes(scene), *large_numbers(scene)]
        return [*found, *watched_by_default(scene), *called_for, *doubts]
    return found


def check_bank(text: str, file: str) -> list[Finding]:
    """Everything that is wrong with one bank of questions."""
    return read_bank_text(text, file)[1]


def check_scene(
    text: str, file: str, *, hints: bool = False, folder: Path | None = None
) -> list[Finding]:
    """Everything that is wrong with one scene file; `folder`: where laws of its own lie."""
    try:
        plain, places = read_scene_text(text, file)
        fence = read_fence(with_law_files(plain, [folder] if folder else []), named=False)
    except AuthorError as error:
        return sorted(error.findings)
    except SceneError as error:
        return sorted(places.finding(problem) for problem in error.problems)
    run = bake(fence.plain)
    if isinstance(run, list):
        return sorted(map(places.finding, run))
    return relevance_hints(fence.scene, places) if hints else []


def check_paths(paths: Iterable[Path], root: Path, *, hints: bool = False) -> list[Finding]:
    """The findings in all lessons and scene files under `paths`; names are shown from `root`."""
    ids, titles = SiteIds(), dict[str, str]()
    findings: list[Finding] = []
    for path in paths:
        for file in files_in(path):
            name = shown(file, root)
            if _nearly_lesson(file):
                findings.append(_not_seen(name))
                continue
            try:
                text = author_text(file, name)
            except AuthorError as error:
                findings += error.findings
                continue
            if file.suffix in LESSON_SUFFIXES:
                lesson = described(file, root)
                built = makes_page(file, root)
                used = ids if built else SiteIds()  # of others, no page has the ids
                own = check_lesson(text, lesson, used, hints=hints)
                own += withheld_findings(text, lesson.file)
                own += left_over(text, lesson.file, own)
                own += [*markdown_slips(text, name), *quoted_options(text, name)]
                if built and file.is_relative_to(root / LESSONS):
                    own += title_twice(text, name, titles)
                findings += own + _in_other_languages(file, root, used, own, hints=hints)
                findings += [*no_page(file, root), *no_text(text, lesson.file)]
            elif file.parent.name == BANK_FOLDER:
                own = check_bank(text, name)
                findings += own + _in_other_languages(file, root, ids, own, hints=hints)
            else:
                findings += check_scene(text, name, hints=hints, folder=file.parent)
        if path.is_dir():
            findings += no_lesson(path, root)
    return list(dict.fromkeys(findings))  # several lessons may show one scene file


def _in_other_languages(
    file: Path, root: Path, ids: SiteIds, own: list[Finding], *, hints: bool
) -> list[Finding]:
    """What is wrong with the catalogues of a lesson or a bank; `own`: with itself."""

    def check(text: str, one: Translation) -> list[Finding]:
        return check_lesson(text, one.described(root), ids)

    alone = any(finding.severity == "error" for finding in own)
    return catalogue_findings(file, root, None if alone else check, hints=hints)


def files_in(path: Path) -> Iterator[Path]:
    """What is looked at of a file or a folder that somebody named."""
    if path.is_file():
        yield path
    elif path.is_dir():
        # A YAML file counts only in a folder of scenes or of banks: others are settings.
        for file in sorted(path.rglob("*")):
            if is_hidden(file.relative_to(path)):
                continue
            ours = file.suffix in SCENE_SUFFIXES and file.parent.name in ("scenes", BANK_FOLDER)
            lesson = file.suffix in LESSON_SUFFIXES or _nearly_lesson(file)
            if file.is_file() and (lesson or ours):
                yield file


def _nearly_lesson(file: Path) -> bool:
    """Markdown by its name, of which no lesson is made."""
    if file.name.lower().endswith(HIDDEN_SUFFIX):
        return True
    near = file.suffix.lower() in NEAR_SUFFIXES and file.suffix not in LESSON_SUFFIXES
    written = file.suffix.lower() in WRITTEN and file.parent.name == LESSONS
    return (near or written) and file.stem.lower() != "readme"


def _not_seen(file: str) -> Finding:
    name = file.rpartition("/")[2]
    if name.lower().endswith(HIDDEN_SUFFIX):
        right = f"{name[: -len(HIDDEN_SUFFIX)]}.md"
        message = "this is no lesson: its name ends in .txt, and many computers hide that"
    else:
        stem, _, ending = name.rpartition(".")
        right = f"{stem}.md"
        message = f"this is no lesson: its name ends in .{ending}, that of a lesson in .md"
        if f".{ending.lower()}" in OFFICE_SUFFIXES:
            hint = f"save it as plain text (UTF-8) under the name {right}"
            return Finding(file, 1, 1, "hidden-ending", message, hint)
    return Finding(file, 1, 1, "hidden-ending", message, f"rename it to {right}")
