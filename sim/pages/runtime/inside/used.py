"""Which modules a page needs: import everything once and look. Runs inside Pyodide."""

import contextlib
import importlib
import json
import pkgutil
import sys
from collections.abc import Iterable


def import_named(names: Iterable[str], must: bool) -> None:
    """Import modules by name; what Pyodide does not have is passed over, unless it `must` be."""
    for name in names:
        with contextlib.suppress(*([] if must else [ImportError])):
            importlib.import_module(name)


def import_package(
    name: str, absent: Iterable[str], apart: Iterable[str], everything: bool
) -> list[str]:
    """Import every module below the package `name` and return those that are for later.

    These are the ones that need a package in `absent`: a page without it has no use for them; and
    those below a name in `apart`, which few pages need. `everything`: import these all the same.
    """
    later = []
    package = importlib.import_module(name)
    for found in pkgutil.walk_packages(package.__path__, name + "."):
        if any(found.name == part or found.name.startswith(f"{part}.") for part in apart):
            later.append(found.name)
            if not everything:
                continue
        try:
            importlib.import_module(found.name)
        except ModuleNotFoundError as error:
            if (error.name or "").split(".")[0] not in absent:
                raise
            later.append(found.name)
    return later


def make_errors() -> None:
    """Provoke what Python imports only when something goes wrong."""
    import traceback

    for text in ("1 / 0", "no_such_name", "''.no_such_attribute", "import no_such_module", "("):
        try:
            exec(compile(text, "<text>", "exec"))
        except Exception as error:
            traceback.format_exception(error)


def files_used(archive: str) -> str:
    """Return the files of the standard library's archive that are in use, as JSON."""
    files = set()
    for module in list(sys.modules.values()):
        file = getattr(module, "__file__", None) or ""
        if file.startswith(archive + "/"):
            name = file.removeprefix(archive + "/")
            files.add(name if name.endswith(".pyc") else name + "c")
    return json.dumps(sorted(files))
