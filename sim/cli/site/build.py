"""`carts build`: check the lessons, make the site, say which file to double-click."""

from __future__ import annotations

import logging
import os
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sim.cli.check import report
from sim.cli.progress import pages_on_terminal
from sim.cli.site import site_folder
from sim.cli.write_out import no_place
from sim.pages.checks.lessons import USUAL_PLACES, check_paths

if TYPE_CHECKING:
    from mkdocs.config.defaults import MkDocsConfig

    from sim.pages.site.build import SiteBuild


@click.command("build")
@click.option(
    "--hosted", is_flag=True, help="For a web server. Without it: for opening by double click."
)
@click.option(
    "--strict/--no-strict",
    default=True,
    help="Stop at mistakes (default), or build all the same and show them in the pages.",
)
@click.pass_context
def command(ctx: click.Context, hosted: bool, strict: bool) -> None:
    """Build the site into the folder site/ and print the file to double-click.

    \b
    carts build
    carts build --hosted
    """
    root = site_folder.here().root
    started = time.monotonic()
    if mistakes_told(root, strict=strict) and strict:
        ctx.exit(1)
    site = build_site(root, hosted=hosted, strict=strict)
    if site is None:
        click.echo("The site was not built.", err=True)
        ctx.exit(1)
    pages = len(list(site.rglob("*.html"))) - 1  # the page for missing pages is none
    click.echo(f"{pages} pages in {time.monotonic() - started:.0f} s.")
    if hosted:
        click.echo(f"Put everything in this folder on your web server:\n  {site}")
    else:
        click.echo(f"Open it with a double click, no network needed:\n  {site / 'index.html'}")


def mistakes_told(root: Path, *, strict: bool = True) -> bool:
    """Whether there are mistakes in the lessons of a site, which are then printed as `carts check`
    does, with warnings. `strict`: nothing is built with mistakes."""
    found = check_paths([root / place for place in USUAL_PLACES], root)
    if found:
        report(found)
    wrong = any(finding.severity == "error" for finding in found)
    if wrong and strict:
        click.echo("The site was not built. Mend what is named above and try again.")
    return wrong


def build_site(
    root: Path,
    *,
    hosted: bool,
    strict: bool,
    site_dir: Path | None = None,
    seen: Callable[[SiteBuild], None] | None = None,
    settings: Mapping[str, object] | None = None,
) -> Path | None:
    """Run MkDocs in `root`; the absolute path of the site, or None after messages on stderr.

    `site_dir` is where the site goes; None: where mkdocs.yml says. `seen` is told what was built.
    `settings`: of the plugin, in place of those in mkdocs.yml.
    """
    if wrong := site_folder.findings(root):
        click.echo("\n".join(map(str, wrong)), err=True)
        return None
    os.environ["NO_MKDOCS_2_WARNING"] = "1"  # the theme's notice to programmers
    from mkdocs.commands.build import build
    from mkdocs.config import load_config
    from mkdocs.exceptions import Abort, MkDocsException

    try:
        elsewhere = {"site_dir": str(site_dir)} if site_dir else {}
        with messages_to_stderr():
            config: MkDocsConfig = load_config(str(root / "mkdocs.yml"), strict=strict, **elsewhere)
            plugin: Any = config.plugins["carts"]
            plugin.config.update({"hosted": hosted, **(settings or {})})
            with pages_on_terminal(config):
                config.plugins.on_startup(command="build", dirty=False)
                for one in config.plugins.values():  # MkDocs keeps them from a preview before
                    if hasattr(one, "search_index_prev"):
                        one.search_index_prev = None
                build(config)
                config.plugins.on_shutdown()
        if seen:
            seen(plugin.build)
    except (Abort, MkDocsException) as error:
        click.echo(str(error), err=True)
        return None
    except OSError as error:
        refused = no_place(error)
        if not refused:
            raise
        click.echo(refused, err=True)
        return None
    return Path(config.site_dir).resolve()


@contextmanager
def messages_to_stderr() -> Iterator[None]:
    """Warnings, errors and the runtime's progress; MkDocs' remarks on itself are left out."""
    mkdocs, runtime = (
        logging.getLogger(name) for name in ("mkdocs", "mkdocs.plugins.carts.runtime")
    )
    before = mkdocs.level, runtime.level
    handler = logging.StreamHandler()
    handler.setFormatter(logging.Formatter("%(message)s"))
    handler.addFilter(lambda record: not str(record.msg).startswith("A 'dirty' build"))  # serve's
    mkdocs.addHandler(handler)
    mkdocs.setLevel(logging.WARNING)
    runtime.setLevel(logging.INFO)
    try:
        yield
    finally:
        mkdocs.removeHandler(handler)
        mkdocs.setLevel(before[0])
        runtime.setLevel(before[1])
