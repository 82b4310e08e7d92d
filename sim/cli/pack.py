"""`carts pack`: the whole site as one zip, for a stick or for a learning platform."""

from __future__ import annotations

import tempfile
import zipfile
from pathlib import Path

import click

from sim.cli import site_folder
from sim.cli.build import build_site
from sim.pages.classroom.scorm import scorm_files

DATE = (1980, 1, 1, 0, 0, 0)  # equal sites give equal zips


@click.command("pack")
@click.option("--scorm", is_flag=True, help="As a SCORM 1.2 package, for a learning platform.")
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    help="The zip to write (default: build/site.zip, or build/site.scorm.zip).",
)
@click.pass_context
def command(ctx: click.Context, scorm: bool, out: Path | None) -> None:
    """Build the site and pack it into one zip.

    Students unpack it and double-click index.html. With --scorm a learning platform shows it; the
    platform is told that the lessons were opened and for how long, and no answer.
    """
    here = site_folder.here()
    root = here.root
    out = out or root / "build" / ("site.scorm.zip" if scorm else "site.zip")
    with tempfile.TemporaryDirectory() as folder:
        site = build_site(root, hosted=scorm, strict=True, site_dir=Path(folder) / "site")
        if site is None:
            click.echo("The site was not built, so there is no zip.", err=True)
            ctx.exit(1)
        pack_site(site, out, scorm=(here.title, here.site_id) if scorm else None)
    click.echo(f"{out}: {out.stat().st_size / 1e6:.1f} MB")


def pack_site(site: Path, out: Path, *, scorm: tuple[str, str] | None) -> None:
    """Write the zip of a built site; `scorm`: title and identifier of the package."""
    files = {
        path.relative_to(site).as_posix(): path.read_bytes()
        for path in sorted(site.rglob("*"))
        if path.is_file()
    }
    if scorm:
        files |= scorm_files(*scorm, files)
    out.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, DATE)
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED)
