"""The files that may stand in a page: those of the built site, and no other of this computer.

An address is written by whoever wrote the lesson. One that leads to nothing, or out of the site (to
a file of the person who builds it), is told and left out.
"""

from __future__ import annotations

import html
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import unquote

from sim.pages.findings import Finding
from sim.pages.text.elsewhere import leads_elsewhere
from sim.pages.text.lesson_places import page_of


def is_far(address: str) -> bool:
    """Whether an address leads to no file beside the page: data in it, or another server."""
    return leads_elsewhere(html.unescape(address))


@dataclass(frozen=True, slots=True)
class Beside:
    """Finds what the page of a lesson names. `lesson`: its file, as messages name it."""

    site: Path
    lesson: str
    report: Callable[[Finding], None]

    @property
    def page(self) -> Path:
        """The built page."""
        return self.site / page_of(self.lesson)

    def at(self, file: Path, address: str) -> Path | None:
        """What `address` in a file of the site leads to; None, and told, where it is not in it."""
        plain = html.unescape(address).split("?")[0].split("#")[0]
        home = self.site.resolve()
        try:
            found = (file.parent / unquote(plain)).resolve()
            if found.is_file() and found.is_relative_to(home):
                return found
        except (OSError, ValueError):  # too long for a name, or a sign that no name has
            pass
        sheet = file.suffix == ".css"  # of the site, not of this lesson alone
        self.report(
            Finding(
                file.resolve().relative_to(home).as_posix() if sheet else self.lesson,
                1,
                1,
                "not-in-the-site",
                f"“{address}” leads to no file of the site: a lesson as one file cannot hold it",
                "put the file beside this one and write its name, without a folder",
            )
        )
        return None
