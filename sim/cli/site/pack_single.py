"""`carts pack --single`: each lesson as one HTML file, all of them in one zip."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sim.cli.check import report
from sim.cli.site.build import build_site
from sim.cli.site.site_folder import SiteFolder
from sim.cli.site.zip_file import size_of, write_zip

if TYPE_CHECKING:
    from sim.pages.site.build import SiteBuild


def pack_lessons(ctx: click.Context, here: SiteFolder, out: Path) -> None:
    """Build the site and write its lessons, one file each, into the zip `out`."""
    from sim.pages.findings import Finding, SiteError
    from sim.pages.single.all_inside import runtime_scripts
    from sim.pages.single.of_lesson import single_lesson
    from sim.pages.text.lesson_places import LESSONS, page_of

    builds: list[SiteBuild] = []
    files: dict[str, bytes] = {}
    missing: dict[Finding, None] = {}
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / "site"
        site = build_site(here.root, hosted=False, strict=True, site_dir=place, seen=builds.append)
        if site is None:
            click.echo("The site was not built, so there is no zip.", err=True)
            ctx.exit(1)
        packed: dict[frozenset[str], list[str]] = {}
        for name, packages in sorted(builds[0].asked.items()):
            if not name.startswith(f"{LESSONS}/") or name in builds[0].languages.made:
                continue  # a translation that is made of a catalogue is in the whole site
            if packages not in packed:
                try:
                    packed[packages] = runtime_scripts(packages, here.root, click.echo)
                except SiteError as error:
                    raise click.ClickException(str(error)) from error
            page = site / page_of(name)
            text = single_lesson(name, site, packed[packages], missing.setdefault)
            inside = page.relative_to(site / LESSONS).as_posix()
            files[inside] = text.encode()
            click.echo(f"  {inside}: {len(files[inside]) / 1e6:.1f} MB")
    if not files:
        raise click.ClickException(
            f"There is no lesson in {LESSONS}/, so there is no zip. Write one: "
            "carts new first-lesson"
        )
    if missing:
        report([*missing])
        click.echo("What is named above is not in the site, so there is no zip.", err=True)
        ctx.exit(1)
    write_zip(files, out)
    click.echo(f"{out}: {size_of(out)}. Each file is a whole lesson and needs no other.")
