"""What an installed wheel carries, so that a teacher needs neither Node.js nor a network.

In a checkout fonts and KaTeX come from node_modules/ and the runtime is packed when a site is
built. A wheel holds both ready-made in the folder sim/carried/; `python -m sim.pages.site.carried
FOLDER` writes them when the wheel is built.
"""

from __future__ import annotations

import functools
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import sim
from sim.pages import licences
from sim.pages.site.files import FONTS, FONTS_INSIDE

_SIM = Path(sim.__file__).parent
CARRIED = _SIM / "carried"
"""There in an installed wheel only."""
CHECKOUT = _SIM.parent
NPM = "node_modules"
LESSONS = "worksheets"


def node_modules(root: Path) -> Path:
    """Where the packages from npm are for the site in `root`."""
    places = (CARRIED / NPM, root / NPM, CHECKOUT / NPM)
    return next((place for place in places if (place / "katex").is_dir()), root / NPM)


def lessons_folder() -> Path:
    """The lessons of this project, for other sites to begin with."""
    carried = CARRIED / LESSONS
    return carried if carried.is_dir() else CHECKOUT / LESSONS


def npm_files(source: Path) -> Iterator[Path]:
    """Every file of npm's packages that a site or its list of licences is made of."""
    katex = source / "katex" / "dist"
    yield from (source / font for font in (*FONTS, *FONTS_INSIDE))
    yield from (katex / "katex.min.js", katex / "katex.min.css")
    yield from sorted((katex / "fonts").glob("*.woff2"))
    for package in licences.npm_packages():
        yield source / package / "package.json"
        licence = source / package / "LICENSE"
        if licence.is_file():
            yield licence


def write_carried(folder: Path) -> None:
    """Write everything for a wheel into `folder`; raises what the packing of a runtime raises."""
    from sim.pages import runtime

    source = CHECKOUT / NPM
    for path in npm_files(source):
        target = folder / NPM / path.relative_to(source)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, target)
    shutil.copytree(CHECKOUT / LESSONS, folder / LESSONS)
    cache = runtime.default_cache(CHECKOUT)
    report = functools.partial(print, file=sys.stderr)
    runtime.write_ready(folder / "runtime", _SIM, sim.__version__, cache, report)


if __name__ == "__main__":
    if not (CHECKOUT / NPM / "katex").is_dir():
        sys.exit("A wheel needs parts from npm and Node.js: “make wheel” sets them up.")
    write_carried(Path(sys.argv[1]))
