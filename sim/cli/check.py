"""`carts check`: every author's mistake as file:line:col, with a hint."""

from __future__ import annotations

import json
from pathlib import Path

import click

from sim.cli.site.site_folder import findings, nearest_site
from sim.pages.checks.lessons import USUAL_PLACES, check_paths, files_in
from sim.pages.findings import Finding
from sim.pages.question.by_default import CODE, TEXT
from sim.pages.site.settings_file import SETTINGS


@click.command("check")
@click.argument("paths", nargs=-1, type=click.Path(path_type=Path))
@click.option("--json", "as_json", is_flag=True, help="Print the findings as a JSON list.")
@click.option(
    "--format",
    "form",
    type=click.Choice(["text", "json", "github"]),
    default="text",
    help="github: as notes on the lines of a commit, for a fork's automatic build.",
)
@click.option("--defaults", is_flag=True, help="List what is so by default, scene by scene.")
@click.pass_context
def command(
    ctx: click.Context, paths: tuple[Path, ...], as_json: bool, form: str, defaults: bool
) -> None:
    """Look for mistakes in lessons (.md) and scene files (.yml).

    PATH is a file or a folder. Without one, mkdocs.yml and the folders worksheets, docs and
    tests/scenes are checked, of the site in or above the current folder. Exit code 1 means that a
    mistake was found, 2 that there is nothing to check.
    A warning stops nothing: an empty lesson, or one in a folder that is not built, a catalogue
    whose lesson is not there, two lessons of one title, hidden forces that no reader can find,
    words of ours that you have not replaced, a text in quotes of a word processor, a list, a table,
    a picture or a formula that the page would print as it is typed. A hint is no finding: an
    effect that a scene lists in vain, or one that it misses much, a form whose last day is over.
    Nor is what is so by default: it is counted, and listed with --defaults.

    \b
    carts check
    carts check worksheets/newtons-third-law.md
    carts check --format github
    """
    if as_json and form == "github":
        raise click.UsageError("--json and --format github exclude each other.")
    root = Path.cwd() if paths else nearest_site(Path.cwd()) or Path.cwd()
    places = _places(paths, root)
    readable = [place for place in places if place != root / SETTINGS]
    found = check_paths(readable, root, hints=True)
    if not paths or root / SETTINGS in places:
        found = [*findings(root), *found]
    counted = [] if defaults else [finding for finding in found if finding.code in (CODE, TEXT)]
    found = [finding for finding in found if finding not in counted]
    if form == "github":
        for finding in found:
            click.echo(finding.as_annotation())
    if as_json or form == "json":
        click.echo(
            json.dumps([finding.as_row() for finding in found], ensure_ascii=False, indent=2)
        )
    else:
        report(found)
        if counted and not any(finding.severity == "error" for finding in found):
            click.echo(_by_default(counted))
    ctx.exit(1 if any(finding.severity == "error" for finding in found) else 0)


def _places(paths: tuple[Path, ...], root: Path) -> list[Path]:
    """Where to look; raises UsageError where there is nothing to check."""
    for path in paths:
        if not path.exists():
            raise click.UsageError(f"There is no file or folder “{path}”.")
    places = [path.resolve() for path in paths] or [root / place for place in USUAL_PLACES]
    if not any(place.exists() for place in places):
        usual = ", ".join(USUAL_PLACES)
        raise click.UsageError(
            f"There are no lessons here (looked for {usual}). Go to the folder of your site first, "
            "or name a file: carts check my-lesson.md"
        )
    for path in paths:
        if path.is_dir() and next(files_in(path.resolve()), None) is None:
            raise click.UsageError(
                f"Nothing in “{path}” was looked at: no lesson (.md) is in it, and scene files "
                "(.yml) are looked for in folders called scenes. Or name a file: carts check "
                "my-scene.yml"
            )
    return places


def _by_default(counted: list[Finding]) -> str:
    """What waits because nobody says otherwise, counted."""
    texts = sum(finding.code == TEXT for finding in counted)
    waiting = len(counted) - texts
    opens = "1 scene or question opens" if waiting == 1 else f"{waiting} scenes and questions open"
    told = [f"{opens} to a student who has watched the run"] if waiting else []
    told += [f"text below {texts} prediction{'s' * (texts > 1)} is read before it"] if texts else []
    return (
        f"Good to know: {', and '.join(told)}. That can be changed: carts check --defaults lists "
        "each with how."
    )


def report(found: list[Finding]) -> None:
    """Print findings for people, the count last."""
    for finding in found:
        click.echo(str(finding))
    if any(finding.code == "relevance" for finding in found):
        click.echo("Of hints about effects, carts plan --relevance LESSON.md#ID tells more.")
    wrong = [finding for finding in found if finding.severity != "hint"]
    if wrong:
        click.echo(f"{len(wrong)} finding{'s' if len(wrong) > 1 else ''}")
    else:
        click.echo("no findings")
