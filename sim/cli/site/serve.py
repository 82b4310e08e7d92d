"""`carts serve`: the pages while they are written. A saved file is on the page in a second."""

from __future__ import annotations

import errno
import os
import time
import webbrowser
from collections.abc import Mapping
from contextlib import suppress
from os.path import relpath
from pathlib import Path
from stat import S_ISREG
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import click

from sim.cli.progress import pages_on_terminal
from sim.cli.site import site_folder
from sim.cli.site.build import messages_to_stderr
from sim.cli.write_out import no_place
from sim.pages.site.settings_file import SETTINGS
from sim.pages.text.lesson_places import LESSONS

if TYPE_CHECKING:
    from mkdocs.config.defaults import MkDocsConfig

    from sim.cli.site.page_server import PageServer

PORTS = range(8000, 8010)
"""Tried in this order where no port is asked for."""

MOST_FIRST = 3
"""Builds before the server begins; who saves on and on is answered by it."""

Seen = Mapping[Path, tuple[int, int]]  # time of the last change in ns, and size


@click.command("serve")
@click.option("--port", type=click.IntRange(1, 65535), help="The port (default: the first free).")
@click.option("--open", "show", is_flag=True, help="Open the first page in your browser.")
def command(port: int | None, show: bool) -> None:
    """Show the site on this computer, and again at each change of a file.

    Mistakes stand on the page, in the place of the block, and here. End it with Ctrl+C. Nobody else
    can see the pages.

    \b
    carts serve
    carts serve --open
    carts serve --port 8123
    """
    root = site_folder.here().root
    with TemporaryDirectory(prefix="carts-") as folder, messages_to_stderr():
        previewer = Previewer(root, Path(folder).resolve())
        server = None
        for number in [port] if port else PORTS:
            try:
                server = previewer.server(number)
                break
            except OSError as error:
                if error.errno not in (errno.EADDRINUSE, errno.EACCES):
                    raise
        if server is None:
            taken = f"Port {port} is" if port else f"The ports {PORTS[0]} to {PORTS[-1]} are"
            raise click.ClickException(f"{taken} taken. Another one: carts serve --port 8123")
        try:
            previewer.begin()
            click.echo(f"Open {server.url} in your browser. Ctrl+C ends it.")
            if show:
                webbrowser.open(server.url)
            server.serve()
        except KeyboardInterrupt:
            click.echo("\nThe pages are no longer shown.")
        finally:
            server.shutdown()
            previewer.close()


def look(*places: Path) -> Seen:
    """The files at and under these places. One that is gone before it is looked at was none: an
    editor's own, beside the page that it saves."""
    seen = {}
    for path in (inside for place in places for inside in (place, *place.rglob("*"))):
        with suppress(OSError):
            fact = path.stat()
            if S_ISREG(fact.st_mode):
                seen[path] = fact.st_mtime_ns, fact.st_size
    return seen


class Previewer:
    """Builds `root` into `site` again and again; what cannot be built becomes `trouble`."""

    def __init__(self, root: Path, site: Path) -> None:
        self.root, self.site = root.resolve(), site
        self.docs = site_folder.read(root).handed_out[1]
        self.folders = {self.root / LESSONS: None, self.docs: None}  # which may be the same
        self.trouble = ""
        self.url = ""
        self.seen: Seen = {}  # of the last build that went well
        self.looked: Seen = {}  # of the last one
        self.config: MkDocsConfig | None = None

    def server(self, port: int) -> PageServer:
        """The server of the pages, bound to its port."""
        from sim.cli.site.page_server import PageServer

        made = PageServer(self.make, lambda: self.trouble, self.site, port)
        self.url = made.url
        for path in (self.root / SETTINGS, *self.folders):
            if path.exists():
                made.watch(str(path))
        return made

    def make(self) -> None:
        """Build what has changed since the last time, and say how long it took."""
        began = time.perf_counter()
        try:
            seen = self.looked = look(self.root / SETTINGS, *self.folders)
            both = {*seen, *self.seen}
            changed = {path for path in both if seen.get(path) != self.seen.get(path)}
            partial = self._partial(seen, changed)
            self._build(changed, partial=partial)
            self.trouble, self.seen = "", seen
        except (Exception, SystemExit) as error:
            refused = isinstance(error, OSError) and no_place(error)
            self.trouble = refused or str(error) or type(error).__name__
            self.seen = {}  # next time everything
            click.echo(self.trouble, err=True)
            return
        names = ", ".join(sorted(Path(relpath(p, self.root)).as_posix() for p in changed)[:3])
        what = names if partial else "The site"
        click.echo(f"{what}: {time.perf_counter() - began:.1f} s")

    def begin(self) -> None:
        """Build, and again what was saved meanwhile: only the server looks for changes."""
        for _ in range(MOST_FIRST):
            self.make()
            with suppress(OSError):
                if look(self.root / SETTINGS, *self.folders) == self.looked:
                    return

    def close(self) -> None:
        """Tell the plugins that it is over."""
        if self.config:
            self.config.plugins.on_shutdown()

    def _partial(self, seen: Seen, changed: set[Path]) -> bool:
        """Whether the menu stays as it is, so that only some pages need to be made again."""
        same_files = bool(self.seen) and seen.keys() == self.seen.keys()
        return same_files and self.root / SETTINGS not in changed

    def _build(self, changed: set[Path], *, partial: bool) -> None:
        from mkdocs.commands.build import build
        from mkdocs.config import load_config

        if wrong := site_folder.findings(self.root):  # in sentences with a line, as of a build
            raise click.ClickException("\n".join(map(str, wrong)))
        config = load_config(str(self.root / SETTINGS), site_dir=str(self.site))
        if self.config is None:
            config.plugins.on_startup(command="serve", dirty=True)
        self.config = config
        plugin: Any = config.plugins["carts"]
        plugin.partial = partial
        config.site_url = self.url
        if partial:
            self._forget_pages(changed)
        with pages_on_terminal(config):
            build(config, serve_url=self.url, dirty=partial)

    def _forget_pages(self, changed: set[Path]) -> None:
        """The generator makes a page again whose file is older than its source."""
        from sim.pages.site.last_build import touched
        from sim.pages.text.lesson_places import page_of

        for source in touched(changed, (p for p in self.seen if p.suffix == ".md")):
            home = self.root if source.is_relative_to(self.root / LESSONS) else self.docs
            page = self.site / page_of(source.relative_to(home).as_posix())
            if page.exists():
                os.utime(page, (0, 0))
