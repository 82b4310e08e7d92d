"""`carts key`: the right answers of a lesson, for the teacher only."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import click

from sim.cli.check import report
from sim.cli.named_file import GivenFile
from sim.cli.site import site_folder
from sim.cli.write_out import write_out
from sim.pages.findings import AuthorError
from sim.pages.language import language_folder
from sim.pages.question.key_page import Key, lesson_key
from sim.pages.site.settings_file import SETTINGS
from sim.pages.text.front_matter import stated_language
from sim.pages.text.lesson_list import lessons_in
from sim.pages.text.lesson_places import LESSONS, shown
from sim.pages.translate.catalogues import is_bank
from sim.pages.translate.in_languages import in_languages


@click.command("key")
@click.argument("paths", nargs=-1, type=GivenFile("a lesson"))
@click.option(
    "--out",
    default=Path("build/keys"),
    type=click.Path(file_okay=False, path_type=Path),
    help="Folder for the keys (default: build/keys). Never one that students get.",
)
@click.pass_context
def command(ctx: click.Context, paths: tuple[Path, ...], out: Path) -> None:
    """Write the keys of lessons: LESSON.key.json for programs, LESSON.key.html to read and print.

    PATH is a lesson (.md). Without one, all lessons in the folder worksheets are taken, those in
    folders of languages too. A lesson in another language, translated by a catalogue or by hand,
    gets the language in its name, LESSON.ms.key.html.

    \b
    carts key
    carts key worksheets/test-forces-and-motion.md
    """
    root = Path.cwd()
    site = site_folder.read(root) if (root / SETTINGS).is_file() else None
    if site:
        _not_to_students(out, site)
    for path in paths:
        if path.suffix != ".md":
            raise click.UsageError(_no_lesson(path))
    named = dict.fromkeys(path.resolve() for path in paths)
    lessons = [*named] or lessons_in(root / LESSONS)
    if not lessons:
        raise click.UsageError(
            f"There are no lessons here (looked for {LESSONS}). Go to the folder of your site "
            "first, or name a file: carts key my-lesson.md"
        )
    written: dict[str, Path] = {}
    for path in lessons:
        try:
            for name, key in _keys(path, root, site.site_id if site else ""):
                if name in written:
                    raise click.UsageError(_same_name(name, written[name], path, root))
                text = json.dumps(key.content, ensure_ascii=False, indent=1, allow_nan=False)
                write_out(out / f"{name}.key.json", f"{text}\n", "--out DIR")
                write_out(out / f"{name}.key.html", key.page, "--out DIR")
                written[name] = path
                click.echo(f"{out / name}.key.html")
        except AuthorError as error:
            report(list(error.findings))
            ctx.exit(1)
    if not written:
        click.echo("There is no question in these lessons.")


def _not_to_students(out: Path, site: site_folder.SiteFolder) -> None:
    """A sentence and the end where the keys would lie in the site, or be copied into it."""
    for folder in site.handed_out:
        if out.resolve().is_relative_to(folder):
            raise click.UsageError(
                f"{out} is in the folder “{folder.name}”, which students get, and a key holds the"
                " right answers. Another place: --out build/keys"
            )


def _same_name(name: str, one: Path, other: Path, root: Path) -> str:
    """Why one key would take the place of another, and what to do."""
    return (
        f"{name}.key.html would be the key of {shown(one, root)} and of {shown(other, root)}."
        " Write one of them elsewhere: --out DIR"
    )


def _no_lesson(path: Path) -> str:
    """What to do with a file that is no lesson."""
    if not is_bank(path.resolve()):
        return f"{path} is no lesson (.md)."
    return (
        f"{path} is a bank. A key belongs to a lesson (.md) that asks its questions: carts key"
        f" LESSON.md. The bank itself, with its answers: carts export {path}"
    )


def _keys(path: Path, root: Path, site_id: str) -> Iterator[tuple[str, Key]]:
    """The keys of a lesson by the names of their files: its own first, then its translations."""
    name = path.stem
    folder = language_folder(f"{path.parent.name}/{path.name}")
    for language, (text, lesson) in in_languages(path, root).items():
        if key := lesson_key(text, lesson, name, site_id):
            own = language or stated_language(text) or folder
            yield ".".join(part for part in (name, own) if part), key
