"""`carts words`: the texts of a lesson as catalogues for other languages."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import NoReturn

import click

from sim.cli.check import report
from sim.cli.named_file import GivenFile
from sim.cli.write_out import write_out
from sim.pages.findings import AuthorError
from sim.pages.language import LANGUAGES, UnknownLanguageError, language_of
from sim.pages.text.author_text import author_text
from sim.pages.text.lesson_places import BANK_FOLDER
from sim.pages.text.lesson_places import shown as shown_from
from sim.pages.translate.catalogues import OTHERS, is_bank, lessons_folder, source_of
from sim.pages.translate.po_file import read_words, updated
from sim.pages.translate.put_in import units_of


class _Spoken(click.Choice[str]):
    """A language that there is a catalogue of, also as others call it (zh); what to do about
    another one.
    """

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        with suppress(UnknownLanguageError):
            value = language_of(value)
        return super().convert(value, param, ctx)

    def fail(
        self, message: str, param: click.Parameter | None = None, ctx: click.Context | None = None
    ) -> NoReturn:
        guide = "A new language is a catalogue and a line: docs/developers/add-a-language.md."
        super().fail(f"{message} {guide}", param, ctx)


@click.command("words")
@click.argument(
    "paths",
    nargs=-1,
    required=True,
    type=GivenFile("a lesson or a bank"),
)
@click.option(
    "--language",
    "languages",
    multiple=True,
    type=_Spoken(OTHERS),
    help="Only this one; may be given several times. Without it: all.",
)
@click.pass_context
def command(ctx: click.Context, paths: tuple[Path, ...], languages: tuple[str, ...]) -> None:
    """Write or update the catalogues of lessons, one for each language.

    PATH is a lesson (.md) or a bank of questions (.yml). Beside the lessons stands then
    words/LANGUAGE/LESSON.po with every text that readers read: free programs such as Poedit
    open it. The next build makes a page of it; what is not translated stays as it is.

    \b
    carts words worksheets/newtons-third-law.md
    carts words worksheets/newtons-third-law.md --language ms
    """
    root = Path.cwd()
    for path in (path.resolve() for path in paths):
        bank = is_bank(path)
        if path.suffix not in ((".yml", ".yaml") if bank else (".md",)):
            raise click.UsageError(
                f"“{path.name}” is neither a lesson (.md) nor in {BANK_FOLDER}/."
            )
        try:
            _update(path, root, languages or OTHERS)
        except AuthorError as error:
            report(list(error.findings))
            ctx.exit(1)


def _update(path: Path, root: Path, languages: Iterable[str]) -> None:
    """Write the catalogues of one lesson or bank; raises `AuthorError`."""
    folder = lessons_folder(path)
    name = shown_from(path, root)
    text = author_text(path, name)
    units = units_of(path, text)
    if not units:
        click.echo(f"{name}: no text to translate is in it, so no catalogue is written")
        return
    for language in languages:
        target = source_of(path, folder, language).catalogue
        shown = shown_from(target, root)
        write_out(target, updated(target, shown, units, language, name))
        said = read_words(target, shown)
        texts = {unit.text for unit in units}
        left = len(texts - set(said.words))
        click.echo(
            f"{shown}: {len(texts)} text{'s' * (len(texts) != 1)}, "
            f"{left} not in {LANGUAGES[language]} yet"
            + (f", {len(said.fuzzy)} of them with an old translation" if said.fuzzy else "")
        )
