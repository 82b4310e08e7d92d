"""numpy and scipy for the page: Pyodide's own wheels, packed again with bytecode.

Their compiled parts are untouched; the modules become .pyc, tests and headers stay out. What only
they need of the standard library goes into a second archive that ships with them.
"""

from __future__ import annotations

import io
import json
import shutil
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from .cache import Cache, key_of
from .lock import tool_works
from .node import code_key, tools_key
from .stdlib import append_selection, compile_archives, used_files

MORE = "python-more.zip"  # the rest of an archive, see more_of_stdlib

# What a scene may import, so that its share of the standard library is known.
IMPORTED = {
    "numpy": ("numpy", "numpy.fft", "numpy.linalg", "numpy.ma", "numpy.polynomial", "numpy.random"),
    "scipy": tuple(
        f"scipy.{part}"
        for part in (
            "constants", "fft", "integrate", "interpolate", "linalg", "ndimage", "optimize",
            "signal", "sparse", "sparse.linalg", "spatial", "special", "stats",
        )
    ),
}  # fmt: skip


Report = Callable[[str], None]


@dataclass(frozen=True)
class Packages:
    """Wheels by package, and the files of the standard library that they need."""

    wheels: dict[str, Path]
    used: tuple[str, ...]


def make_packages(
    originals: dict[str, Path],
    core: Path,
    stdlib: Path,
    cache: Cache,
    report: Callable[[str], None],
) -> Packages:
    """Return `originals` (package -> verified wheel, named by its sha256) packed again.

    The results have the names of the distribution: Pyodide reads name and version from them.
    """
    lock = json.loads((core / "pyodide-lock.json").read_text(encoding="utf-8"))["packages"]
    names = {name: str(lock[name]["file_name"]) for name in originals}

    def make(folder: Path) -> None:
        if tool_works():
            report(f"Compiling {' and '.join(originals)} (once, about a minute)")
            archives: list[dict[str, object]] = [
                {"from": str(path), "to": str(folder / names[name]), "optimize": 0, "wheel": True}
                for name, path in originals.items()
            ]
            compile_archives(core, archives, folder)
        else:
            report("No bytecode for numpy and scipy: that needs pyodide-build, and Python 3.12")
            for name, path in originals.items():
                shutil.copyfile(path, folder / names[name])
        used = used_files(
            core, stdlib, folder,
            wheels=[folder / names[name] for name in originals],
            modules=[module for name in originals for module in IMPORTED[name]],
        )  # fmt: skip
        (folder / "used.txt").write_text("\n".join(used.files), encoding="utf-8")

    code = code_key("packages", "stdlib", "lock")
    key = key_of(tools_key(), code, str(tool_works()), *(p.name for p in originals.values()))
    folder = cache.step("packages", key, make)
    used = (folder / "used.txt").read_text(encoding="utf-8").split()
    return Packages({n: folder / names[n] for n in originals}, tuple(used))


def more_of_stdlib(stdlib: Path, needed: Sequence[str], start: Path) -> tuple[int, bytes]:
    """Return what the packages need beyond the archive `start` that every page has.

    The bytes go on from `start` at the returned place, where its table of contents begins, and end
    in a table of both: put together, they are one archive.
    """
    whole = io.BytesIO(start.read_bytes())
    with zipfile.ZipFile(whole, "a") as target:
        table_at = target.start_dir
        append_selection(stdlib, set(needed) - set(target.namelist()), target)
    return table_at, whole.getvalue()[table_at:]
