"""Files that are missing, cut, altered, empty, or another's: every kind of file of a page."""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path

from .table import PACKAGES, Fault, Harm, Mode, Must

LOGIN = b"<!doctype html><title>Log in</title><p>Log in to this network"
CARTS = "assets/carts"
RUNTIME = f"{CARTS}/runtime"
PARTS = ("index.js", "pyodide.js.*", "pyodide.asm.wasm.*", "memory.snapshot.*", "python.zip.*")
WHEELS = ("numpy*", "scipy*", "python-more.zip.*")
ALONE = ("pyodide.asm.wasm.1.*", "memory.snapshot.2.*", "newtons_carts-*")
OURS = ("carts.js", "answers.js")
ASIDE = ("tour.js", "challenge.js", "worlds.js", "iframe-worker.js", "formula-fonts.js")
STYLES = ("carts.css", "site.css", "katex/katex.min.css", "katex/sizes.css")
THEME = ("javascripts/*.js", "stylesheets/main*.css", "stylesheets/palette*.css", "images/*")
PLACES = (0.02, 0.1, 0.25, 0.5, 0.75, 0.9, 0.97, 0.99)  # of a page, where its copy ended


def missing(file: Path) -> None:
    file.unlink()


def cut(file: Path) -> None:
    _write(file, file.read_bytes()[: file.stat().st_size // 2])


def altered(file: Path) -> None:
    """One bit, at a place that is the same in every run."""
    content = bytearray(file.read_bytes())
    place = random.Random(file.name.partition(".")[0]).randrange(len(content))
    content[place] ^= 4
    _write(file, bytes(content))


def empty(file: Path) -> None:
    _write(file, b"")


def login(file: Path) -> None:
    """What a network gives to those who have not logged in, under every address."""
    _write(file, LOGIN)


HARMS = (missing, cut, altered, empty, login)


def _write(file: Path, content: bytes) -> None:
    """Never in place: the copies of the site share their files."""
    file.unlink()
    file.write_bytes(content)


def to(harm: Harm, pattern: str) -> Harm:
    """The harm done to each file of this pattern. Raises ValueError where there is none."""

    def done(site: Path) -> None:
        found = sorted(site.glob(pattern))
        if not found:
            raise ValueError(f"no file is called {pattern}")
        for file in found:
            harm(file)

    return done


def of_files() -> Iterator[Fault]:
    """From a disk and from a server."""
    ways: tuple[tuple[Mode, str], ...] = (("disk", ""), ("http", ", http"))
    for mode, where in ways:
        for harm in HARMS:
            told = harm.__name__
            for name in OURS:
                must: Must = "either" if harm is altered else _of(name)
                does = to(harm, f"{CARTS}/{name}")
                yield Fault(f"{name} {told}{where}", must, does, mode=mode)
            for name in PARTS:
                must = "lives" if name.startswith("memory") else "says"
                does = to(harm, f"{RUNTIME}/{name}")
                yield Fault(f"{name} {told}{where}", must, does, mode=mode)
    for harm in (missing, cut, altered):
        for name in STYLES:
            yield Fault(f"{name} {harm.__name__}", harm=to(harm, f"{CARTS}/{name}"))
        for name in ALONE[:2]:
            must = "lives" if name.startswith("memory") else "says"
            yield Fault(f"{name} {harm.__name__}", must, to(harm, f"{RUNTIME}/{name}"))
        for name in WHEELS:
            does = to(harm, f"{RUNTIME}/{name}")
            yield Fault(f"{name} {harm.__name__}", "says", does, page=PACKAGES)
    for harm in (missing, cut):
        for name in ASIDE:
            yield Fault(f"{name} {harm.__name__}", "either", to(harm, f"{CARTS}/{name}"))
        for name in THEME:
            yield Fault(f"{name} {harm.__name__}", harm=to(harm, f"assets/{name}"))
    yield Fault("prepared/* missing", harm=to(missing, f"{CARTS}/prepared/*"))
    yield Fault("fonts missing", harm=to(missing, f"{CARTS}/fonts/*"))
    yield from _of_page()


def _of(name: str) -> Must:
    return "closed" if name == "answers.js" else "says"


def _of_page() -> Iterator[Fault]:
    def shortened(place: float) -> Harm:
        def done(file: Path) -> None:
            content = file.read_bytes()
            _write(file, content[: int(len(content) * place)])

        return to(done, Fault.page)

    for place in PLACES:
        must: Must = "blank" if place < PLACES[1] else "either"
        yield Fault(f"the page ends after {place:.0%}", must, shortened(place))
    yield Fault("the page is empty", "blank", to(empty, Fault.page))
    yield Fault("a login page for the page", "blank", to(login, Fault.page))
    yield Fault("a scene's run is no JSON", "either", to(_unreadable_runs, Fault.page))


def _unreadable_runs(file: Path) -> None:
    """What a bad copy makes of the run that a scene brought along."""
    mark = b'class="carts-baked">'
    _write(file, file.read_bytes().replace(mark, mark + b"\x00?"))
