"""`carts export`: the questions of a bank or a lesson for a learning platform."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import click

from sim.cli.check import report
from sim.cli.named_file import GivenFile
from sim.cli.write_out import write_out
from sim.lesson import Question
from sim.pages.classroom.gift import gift
from sim.pages.classroom.losses import Target, fitting, losses
from sim.pages.classroom.moodle import moodle_xml
from sim.pages.classroom.pictures import pictures_of
from sim.pages.classroom.portable import portable
from sim.pages.classroom.qti.mathml import formulas_by
from sim.pages.classroom.qti.package import qti_package
from sim.pages.findings import AuthorError
from sim.pages.language import ENGLISH, speaking, words
from sim.pages.language.catalogue import of_page
from sim.pages.question.of_lesson import lesson_asks
from sim.pages.question.quiz import read_bank_text
from sim.pages.site.carried import node_modules
from sim.pages.text.author_text import author_text
from sim.pages.text.formulas import KATEX
from sim.pages.text.front_matter import stated_language
from sim.pages.translate.catalogues import OTHERS, lessons_folder, source_of
from sim.pages.translate.in_languages import in_languages
from sim.pages.translate.translation import part_of

ENDINGS = {"moodle": ".moodle.xml", "gift": ".gift.txt", "qti": ".qti.zip"}


@dataclass(frozen=True, slots=True)
class _Asked:
    """What a file asks: `forms` by name, each with its questions; `stays`: what cannot go along;
    `language`: "" where nothing says it; `exams`: forms that give no feedback."""

    title: str
    questions: Mapping[str, Question]
    forms: Mapping[str, Iterable[str]]
    about: Mapping[str, str] = field(default_factory=dict)
    stays: tuple[str, ...] = ()
    language: str = ""
    exams: frozenset[str] = frozenset()

    def is_exam(self, form: str | None) -> bool:
        """Whether the form is one; without a form, whether there is nothing else."""
        return form in self.exams if form else bool(self.exams) and self.exams >= set(self.forms)


@click.command("export")
@click.argument("path", type=GivenFile("a lesson or a bank"))
@click.option("--form", help="Only the questions of this form, in its order.")
@click.option(
    "--to",
    "target",
    type=click.Choice(sorted(ENDINGS)),
    default="moodle",
    show_default=True,
    help="Moodle XML, GIFT, or a package of QTI 3.0.",
)
@click.option(
    "--language",
    type=click.Choice(sorted(OTHERS)),
    help="In the language of one of its catalogues.",
)
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    help="The file to write (default: build/export/NAME and an ending).",
)
@click.pass_context
def command(
    ctx: click.Context,
    path: Path,
    form: str | None,
    target: Target,
    language: str | None,
    out: Path | None,
) -> None:
    """Write questions for Moodle and other learning platforms.

    PATH is a lesson (.md), with all that it asks, or a bank of questions (worksheets/banks). The
    file holds the right answers: import it, and do not hand it out.

    \b
    carts export worksheets/newtons-second-law.md
    carts export worksheets/newtons-second-law.md --form worksheet --language ms
    carts export worksheets/banks/forces-and-motion.yml --form test-15 --to gift
    carts export worksheets/banks/forces-and-motion.yml --language ta
    carts export worksheets/banks/forces-and-motion.yml --to qti
    """
    try:
        asked = _of_lesson(path, language) if path.suffix == ".md" else _of_bank(path, language)
    except AuthorError as error:
        report(list(error.findings))
        ctx.exit(1)
    if form is not None and form not in asked.forms:
        known = ", ".join(asked.forms) or "none"
        raise click.UsageError(f"there is no form “{form}” in it; its forms: {known}")
    ids = asked.forms[form] if form else asked.questions
    with speaking(words(language or ENGLISH)):
        found, left = portable((asked.questions[name] for name in ids), asked.about)
    taken, refused = fitting(found, target)
    if not taken:
        nothing = ["there is no question in it that a platform could take", *left, *refused]
        raise click.ClickException("\n".join(nothing))
    name = ".".join(filter(None, (path.stem, form, language)))
    out = out or Path("build/export") / f"{name}{ENDINGS[target]}"
    # a bank lies in a folder beside the lessons that show its questions
    shown_from = path.parent if path.suffix == ".md" else path.parent.parent
    pictures = pictures_of(shown_from, Path.cwd())
    formulas = formulas_by(node_modules(Path.cwd()) / KATEX)
    made: str | bytes
    if target == "qti":
        feedback = not asked.is_exam(form)
        made = qti_package(
            asked.title, taken, pictures, formulas,
            name=name, language=asked.language, feedback=feedback,
        )  # fmt: skip
    elif target == "gift":
        made = gift(asked.title, taken)
    else:
        made = moodle_xml(asked.title, taken, pictures)
    write_out(out, made, "--out FILE")
    click.echo(f"{out}: {len(taken)} {'question' if len(taken) == 1 else 'questions'}")
    for sentence in (*left, *refused, *losses(taken, target, pictures, formulas), *asked.stays):
        click.echo(sentence, err=True)


def _of_bank(path: Path, language: str | None) -> _Asked:
    text, file, part = author_text(path, path.as_posix()), path.as_posix(), None
    if language:
        whole = path.resolve()
        source = source_of(whole, lessons_folder(whole), language)
        if source.by_hand or not source.catalogue.is_file():
            raise click.UsageError(f"{path.name} is not translated: no catalogue in “{language}”")
        part = part_of(source, Path.cwd())
        text, file = part.made.text, part.file
    found, findings = read_bank_text(text, file)
    if found is None:
        raise AuthorError([part.finding(one) if part else one for one in findings])
    return _Asked(found.title, found.items, found.forms, language=language or "")


def _of_lesson(path: Path, language: str | None) -> _Asked:
    """A question that stands in several forms is taken once."""
    found = in_languages(path.resolve(), Path.cwd()).get(language or "")
    if found is None:
        raise click.UsageError(f"{path.name} is not translated: no catalogue in “{language}”")
    asks = lesson_asks(*found)
    text, lesson = found
    spoken = language or of_page(stated_language(text) or None, lesson.file, ENGLISH)
    questions = {q.id: q for part in asks.parts.values() for q in part}
    forms = {name: [q.id for q in part] for name, part in asks.parts.items()}
    stays = tuple(f"{scene}: what is predicted before its run stays here"
                  for scene in asks.predicted)  # fmt: skip
    exams = frozenset(one.form for one in asks.forms if one.mode == "exam")
    return _Asked(asks.title or path.stem, questions, forms, asks.about, stays, spoken, exams)
