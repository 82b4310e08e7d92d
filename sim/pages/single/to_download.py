"""“Download this lesson” on a web server: one file, put together in the reader's browser.

A whole file for each lesson would hold Python once a lesson. So the site has a shell of it: the
file as `of_lesson` writes it, with a mark in the place of each script that the site has anyway. The
page's script (`hosted/download.js`) fetches them, most of them out of its cache, and puts them in.
The policy of the file names every script by its hash: one that is not as it was will not run.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from urllib.parse import quote

from sim.pages.findings import Finding, SiteError
from sim.pages.single.all_inside import runtime_files
from sim.pages.single.of_lesson import single_lesson
from sim.pages.site.files import ASSETS
from sim.pages.teach.doors import END

FOLDER = "download/"
"""Beside the page's scripts. The shells are text there, no pages to be opened or listed."""


def with_place(html: str, assets: str, *, lesson: str, kept: bool) -> str:
    """The page with a place at its foot that its script fills: how to take `lesson` home as a file
    ("": it is no lesson), and how to keep the site on a tablet, if it can be `kept` there."""
    shell = f' data-shell="{assets}{FOLDER}{quote(_file(lesson))}"' if lesson else ""
    place = f'<div class="carts-hosted"{shell}{" data-kept" if kept else ""}></div>'
    return html.replace(END, f"{place}\n{END}", 1)


def write_shells(
    site: Path,
    lessons: Mapping[str, frozenset[str]],
    root: Path,
    report: Callable[[str], None],
    told: Callable[[Finding], None],
) -> None:
    """Write the shells of `lessons` (packages by page) into the built site: none without Python.

    `told`: what pages name and the site has not, each once.
    """
    missing: dict[Finding, None] = {}
    assets = site / ASSETS
    folder = assets / FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    own = {
        path.read_text(encoding="utf-8"): path.relative_to(assets).as_posix()
        for path in sorted(assets.rglob("*.js"))
    }
    runtimes: dict[frozenset[str], dict[str, str]] = {}
    for name, packages in sorted(lessons.items()):
        if packages not in runtimes:
            try:
                runtimes[packages] = runtime_files(packages, root, report)
            except SiteError:
                return  # it cannot be had here; the pages of this site say so themselves
        scripts = runtimes[packages].values()
        text = single_lesson(name, site, scripts, missing.setdefault, own)
        (folder / _file(name)).write_text(text, encoding="utf-8", newline="\n")
    for finding in missing:
        told(finding)


def _file(name: str) -> str:
    return name.rpartition(".")[0].replace("/", "-") + ".txt"
