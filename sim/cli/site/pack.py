"""`carts pack`: the whole site as one zip, for a stick, a web server or a learning platform."""

from __future__ import annotations

import tempfile
from pathlib import Path

import click

from sim.cli.site import site_folder
from sim.cli.site.build import build_site, mistakes_told
from sim.cli.site.zip_file import size_of, write_zip
from sim.pages.classroom.scorm import scorm_files
from sim.pages.language import of_page
from sim.pages.offline.files import WORKER
from sim.pages.offline.open_me import NAME as OPEN_ME
from sim.pages.offline.open_me import open_me

KINDS = {"scorm": "site.scorm.zip", "hosted": "site.hosted.zip", "stick": "site.zip"}
HOW = {
    "stick": f"Students unpack it and double-click “{OPEN_ME}”.",
    "hosted": "Unpack it into a folder of a web server; any address will do.",
}

YOURS = (
    "“Class results” is not in it: that page is for you. Your own copy has it: carts build, or "
    "carts pack --teacher."
)


@click.command("pack")
@click.option("--hosted", is_flag=True, help="For a web server.")
@click.option("--scorm", is_flag=True, help="SCORM 1.2, for a learning platform.")
@click.option("--single", is_flag=True, help="Each lesson as one HTML file; a zip of them.")
@click.option("--teacher", is_flag=True, help="With “Change this lesson” in every lesson.")
@click.option("--teacher-word", help="With it, behind this word of yours.")
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    help="The zip to write (default: build/site.zip, build/site.hosted.zip …).",
)
@click.pass_context
def command(
    ctx: click.Context,
    hosted: bool,
    scorm: bool,
    single: bool,
    teacher: bool,
    teacher_word: str | None,
    out: Path | None,
) -> None:
    """Build the site and pack it into one zip.

    Students unpack it and double-click OPEN ME, which checks the browser and leads to the lessons.
    With --hosted: for whoever has a web server. With --scorm a learning platform shows it; the
    platform is told that the lessons were opened, that something was handed in and for how long
    they were open, and no answer.

    Students get no “Change this lesson”, which shows right answers, unless you ask for it with
    --teacher or --teacher-word. Nor do they get the page Class results, if your mkdocs.yml names
    it; with --hosted it is there.

    \b
    carts pack
    carts pack --out mechanics.zip
    carts pack --hosted
    carts pack --scorm
    carts pack --single
    carts pack --teacher-word OWL
    """
    here = site_folder.here()
    kind = _kind({"hosted": hosted, "scorm": scorm, "single": single})
    if teacher_word is not None and not teacher_word.strip():
        raise click.UsageError("--teacher-word is empty. A word of yours: --teacher-word OWL")
    if out and out.suffix.lower() != ".zip":  # no computer would know how to open it
        raise click.UsageError(f"--out {out}: the name of a zip ends in .zip: {out.name}.zip")
    if single and (teacher or teacher_word):
        raise click.UsageError("--teacher and --teacher-word belong to a whole site: no --single.")
    if mistakes_told(here.root):
        ctx.exit(1)
    if single:
        from sim.cli.site.pack_single import pack_lessons

        pack_lessons(ctx, here, out or here.root / "build" / "lessons.single.zip")
        return
    out = out or here.root / "build" / KINDS[kind]
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / "site"
        settings = _settings(kind, teacher, teacher_word or "")
        on_web = kind != "stick"
        site = build_site(here.root, hosted=on_web, strict=True, site_dir=place, settings=settings)
        if site is None:
            click.echo("The site was not built, so there is no zip.", err=True)
            ctx.exit(1)
        if kind == "stick":
            page = open_me(here.title, of_page(None, "", here.language))
            (site / OPEN_ME).write_text(page, encoding="utf-8", newline="\n")
        pack_site(site, out, scorm=(here.title, here.site_id) if kind == "scorm" else None)
    left_out = here.class_results and not settings["class_results"]
    told = (f"{out}: {size_of(out)}", HOW.get(kind), YOURS if left_out else None)
    click.echo("\n".join(filter(None, told)))


def _settings(kind: str, teacher: bool, word: str) -> dict[str, object]:
    """Of the site in the zip, in place of those in mkdocs.yml."""
    shown = teacher or bool(word)
    settings: dict[str, object] = {
        "teacher_mode": shown,
        "class_results": shown or kind == "hosted",  # on the web it is the teacher's copy too
    }
    if shown:  # --teacher alone asks for no word, whatever mkdocs.yml says
        settings["teacher_word"] = word
    if kind == "scorm":  # a platform asks for a login: no browser need keep all of it
        settings["offline"] = False
    return settings


def _kind(forms: dict[str, bool]) -> str:
    """Of the zip: the one that is asked for."""
    asked = [name for name, wanted in forms.items() if wanted]
    if len(asked) > 1:
        told = " and ".join(f"--{name}" for name in asked)
        raise click.UsageError(f"{told} do not go together: each is a zip of its own.")
    return asked[0] if asked else "stick"


def pack_site(site: Path, out: Path, *, scorm: tuple[str, str] | None) -> None:
    """Write the zip of a built site; `scorm`: title and identifier of the package.

    What pages ask for comes before them, and the list of all files last: unpacked over an older
    site, in this order, no page that is new meets a script that is not there yet."""
    names = [path.relative_to(site).as_posix() for path in site.rglob("*") if path.is_file()]
    names.sort(key=lambda name: (name == WORKER, name.endswith(".html"), name))
    files = {name: (site / name).read_bytes() for name in names}
    if scorm:
        files |= scorm_files(*scorm, files)
    write_zip(files, out)
