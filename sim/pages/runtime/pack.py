"""Pack everything that runs Python in a page into `assets/carts/runtime/` of a site."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from sim import __version__

from . import pins
from .cache import Cache
from .contents import Contents, make_contents
from .extras import EXTRAS, read_extras
from .node import RuntimePackError
from .ours import Ours, read_ours
from .payload import write_index
from .ready import find_ready
from .sources import MissingSourceError, core_files, in_ci, package_wheels
from .stdlib import core_folder

Report = Callable[[str], None]

PACKAGE = Path(__file__).parents[2]
READY = PACKAGE / "carried" / "runtime"  # in an installed wheel
RUNTIME = Path("assets") / "carts" / "runtime"
FORMAT = 1


@dataclass(frozen=True)
class RuntimeFacts:
    """What was packed: bytes by file name, versions by component, and what could not be had."""

    folder: Path
    files: dict[str, int]
    versions: dict[str, str]
    missing: str

    @property
    def size(self) -> int:
        """All bytes on disk."""
        return sum(self.files.values())


def pack(
    site_dir: Path, *, packages: frozenset[str], cache: Path, report: Report, source: Path = PACKAGE
) -> RuntimeFacts:
    """Write the runtime into `site_dir` and return what it is.

    `packages`: those of "numpy" and "scipy" that pages need, and of EXTRAS.
    `source`: the folder of the package that runs in the page. Raises RuntimePackError. What can't
    be fetched is an error in an automatic build; elsewhere the pages are told to say so, and show
    their baked runs.
    """
    if unknown := packages - {*pins.PACKAGES, *EXTRAS}:
        raise RuntimePackError(f"no such package for the page: {', '.join(sorted(unknown))}")
    ours = read_ours(source, __version__)
    contents, missing = find_ready(READY, packages, ours, source), ""
    if contents is None:
        extras = read_extras(packages, source, __version__)
        contents, missing = _make(packages, Cache(cache), ours, extras, report)
    folder = site_dir / RUNTIME
    _write(folder, contents, missing)
    sizes = {p.name: p.stat().st_size for p in sorted(folder.iterdir())}
    return RuntimeFacts(folder, sizes, dict(contents.versions) if contents else {}, missing)


def _make(
    packages: frozenset[str], store: Cache, ours: Ours, extras: list[Ours], report: Report
) -> tuple[Contents | None, str]:
    """The runtime made from its sources, and in words what could not be had."""
    wanted = [n for n in pins.PACKAGES if n in packages or (n == "numpy" and "scipy" in packages)]
    missing = ""
    try:
        files = core_files(store, PACKAGE.parent, report)
        core = core_folder(files, store)
        try:
            wheels = package_wheels(wanted, files[pins.LOCK], files[pins.LOADER], store, report)
        except MissingSourceError as error:
            wheels, missing = {}, _noted(error, report)
        return make_contents(core, ours, wheels, store, report, extras), missing
    except MissingSourceError as error:
        return None, _noted(error, report)


def _noted(error: MissingSourceError, report: Report) -> str:
    if in_ci():
        raise error
    report(str(error))
    return str(error)


def _write(folder: Path, contents: Contents | None, missing: str) -> None:
    """Replace what is in `folder`, copying only what is not there yet."""
    folder.mkdir(parents=True, exist_ok=True)
    scripts = contents.scripts if contents else {}
    for path in folder.iterdir():
        if path.name not in scripts:
            path.unlink()
    for name, path in scripts.items():
        if not (folder / name).is_file() or (folder / name).stat().st_size != path.stat().st_size:
            shutil.copyfile(path, folder / name)
    index: Mapping[str, object] = contents.index if contents else {}
    write_index({"format": FORMAT, **index, "missing": missing}, folder)
