"""`carts new`: a site, a lesson or a bank of questions to begin with, which already builds."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from pathlib import Path

import click

from sim.cli import starter_files as starter
from sim.cli.windows_names import why_not_on_windows
from sim.pages.site.carried import lessons_folder
from sim.pages.text.front_matter import LAST, lesson_order

WORKSHEETS = "worksheets"
BANKS = "banks"
FIRST = "first-lesson"


@click.command("new")
@click.argument("name")
@click.option("--title", help="The title (default: made from NAME).")
@click.option("--site", "kind", flag_value="site", help="Make a site, whatever is here.")
@click.option("--lesson", "kind", flag_value="lesson", help="Write a lesson into worksheets/.")
@click.option("--bank", "kind", flag_value="bank", help="Write a bank of questions.")
@click.option("--like", metavar="LESSON", help="Begin with a lesson of ours: newtons-third-law.")
def command(name: str, title: str | None, kind: str | None, like: str | None) -> None:
    """Make a site in the new folder NAME; in a site: write the lesson worksheets/NAME.md.

    A site is mkdocs.yml, worksheets/ with a first lesson, and what GitHub needs to publish it.

    \b
    carts new my-lessons                        a site; then: cd my-lessons
    carts new two-trains                        in a site: a lesson
    carts new two-trains --title "Two trains meet"
    carts new third-law --like newtons-third-law
    carts new forces --bank                     in a site: worksheets/banks/forces.yml
    """
    here = Path.cwd()
    if kind != "site" and here.name == WORKSHEETS and (here.parent / "mkdocs.yml").is_file():
        here = here.parent  # in the folder of lessons: a lesson of that site, no site in a site
    in_a_site = (here / "mkdocs.yml").is_file() or (here / WORKSHEETS).is_dir()
    kind = kind or ("lesson" if in_a_site else "site")
    if reason := why_not_on_windows(Path(name).name):
        raise click.UsageError(reason)
    if like and kind == "bank":
        raise click.UsageError("--like is for lessons.")
    if kind == "site":
        _site(name, title, like)
        return
    if not re.fullmatch(r"[a-z][a-z0-9-]{0,40}", name):
        raise click.UsageError(
            "NAME is a small letter, then small letters, digits and hyphens, 41 in all; any title"
            ' goes beside it: carts new two-trains --title "Two trains"'
        )
    if not (here / WORKSHEETS).is_dir():
        raise click.UsageError(
            "There is no folder worksheets here. Go to the folder of your site, or make one first:"
            " carts new my-lessons"
        )
    title_ = title or starter.title_of(name)
    if kind == "bank":
        files = {f"{WORKSHEETS}/{BANKS}/{name}.yml": starter.bank_text(name, title_)}
        what = "How a lesson uses it stands at its top."
    else:
        files = _lesson(here, name, title, like)
        what = "Edit it, then: carts check, carts serve"
    _write(here, files)
    shown = next(iter(files))
    if here != Path.cwd():
        shown, what = os.path.relpath(here / shown), what.replace("then: ", "then: cd .., ")
    click.echo(f"{shown} is written. {what}")


def _site(typed: str, title: str | None, like: str | None) -> None:
    folder = Path.cwd() / Path(typed).expanduser()
    name = folder.resolve().name
    if folder.is_file() or (folder.is_dir() and any(folder.iterdir())):
        raise click.ClickException(
            f"“{name}” is there already and not empty. Nothing was changed. Choose another name."
        )
    title = title or starter.title_of(name)
    files = starter.site_files(title, starter.new_site_id(name))
    files |= _lesson(folder, like or FIRST, None, like)
    _write(folder, files)
    click.echo(f"The site “{title}” is written into the folder {folder}:")
    for path in sorted(files):
        click.echo(f"  {path}")
    way = str(folder) if typed.startswith("~") else typed  # in quotes ~ would be a name
    click.echo(f"Now: cd {way}" if re.fullmatch(r"[\w./\\:-]+", way) else f'Now: cd "{way}"')
    click.echo("Then: carts serve   (shows the pages while you write)")


def _lesson(root: Path, name: str, title: str | None, like: str | None) -> dict[str, str]:
    """The files of a new lesson, its own first."""
    lessons = list((root / WORKSHEETS).glob("*.md"))
    order = 1 + max((n for n, _ in map(lesson_order, lessons) if n < LAST), default=0)
    path = f"{WORKSHEETS}/{name}.md"
    if not like:
        return {path: starter.lesson_text(name, title or starter.title_of(name), order)}
    ours = lessons_folder()
    source = ours / f"{like}.md"
    if "/" in like or not source.is_file():
        known = ", ".join(sorted(p.stem for p in ours.glob("*.md")))
        raise click.UsageError(f"There is no lesson “{like}” of ours. There are: {known}")
    text = source.read_text(encoding="utf-8")
    if same := next(
        (path for path in lessons if _ids(path.read_text("utf-8", "replace")) & _ids(text)), None
    ):
        raise click.UsageError(
            f"{WORKSHEETS}/{same.name} is that lesson, or has ids of it: each id would be there "
            "twice. Change it, or take it away first."
        )
    beside = {
        f"{WORKSHEETS}/{file}": (ours / file).read_text(encoding="utf-8")
        for file in starter.files_of(text)
        if not (root / WORKSHEETS / file).exists()
    }
    return {path: starter.copied(text, title, order), **beside}


def _ids(text: str) -> set[str]:
    """Of the blocks of a lesson."""
    return set(re.findall(r"^id: *(\S+)", text, re.MULTILINE))


def _write(root: Path, files: Mapping[str, str]) -> None:
    """Write all files, or none where one of them is there already."""
    for path in files:
        if (root / path).exists():
            raise click.ClickException(f"{path} is there already. Nothing was changed.")
    try:
        for path, text in files.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text, encoding="utf-8", newline="\n")
    except OSError as error:
        raise click.ClickException(
            f"Nothing can be written into {root}: {error.strerror}. Go to a folder that is yours,"
            " for example in Documents."
        ) from None
