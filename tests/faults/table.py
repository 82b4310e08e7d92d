"""What a fault is: what is done to a copy of the site, to its server, to the browser or to the
machine, and what a reader must then see. Nothing else is a verdict.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass
from http.server import SimpleHTTPRequestHandler
from pathlib import Path
from typing import Literal

LESSON = "worksheets/newtons-third-law.html"
WORD = "an answer"
PACKAGES = "gallery/balls.html"  # scenes that call for numpy and scipy

Mode = Literal["disk", "http"]
Must = Literal["lives", "says", "closed", "either", "blank"]
"""What must be seen.

lives: Python answers and an answer is kept, whatever is said beside it.
says: a message within `SOON`; what still works may work. What was answered before is still there.
closed: a message within `SOON`, and no field takes a key.
either: it lives or it says; where chance decides what a damage hits.
blank: nothing of the lesson is there, so there is no field that could take a key.
"""

Harm = Callable[[Path], None]
Answer = Callable[[SimpleHTTPRequestHandler, str], bool]
"""A server's own answer to a path; False: as ever."""


@dataclass(frozen=True)
class Browser:
    """How a browser of its own is started: its profile's folder, what stands in front
    of its program (`before`), and whether its disk is `full` when the visit begins.
    """

    profile: Path
    before: str = ""
    full: bool = False


Machine = Callable[[Path, Path], AbstractContextManager[Browser]]
"""Changes the machine under (site, an empty folder) while a browser of its own looks."""


@dataclass(frozen=True)
class Fault:
    """A row: its name, what must be seen, and what is done.

    `without`: a script that runs before the page's own. `before`: one that another page of the
    site runs to its end first. `slow`: how many times slower this machine is; its clock goes so
    much slower too. `earlier`: a healthy visit has answered before, and that is seen
    again or its loss is said; `again`: it is seen at a visit after this one too. `word`: what is
    typed. `answer`: the server's. `folder`: the name of the site's folder.
    """

    name: str
    must: Must = "lives"
    harm: Harm = lambda _: None
    without: str = ""
    before: str = ""
    earlier: bool = False
    again: bool = False
    word: str = WORD
    mode: Mode = "disk"
    folder: str = "site"
    answer: Answer | None = None
    page: str = LESSON
    machine: Machine | None = None
    slow: float = 1.0
