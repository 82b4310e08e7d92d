"""From our sources to what a page starts from: wheel, standard library, picture of the memory.

The three are one set: the picture remembers where in the archive each module stands. An edit of
ours makes these again (a few seconds) and leaves the compiled standard library alone.
"""

from __future__ import annotations

import json
import zipfile
from dataclasses import asdict, dataclass
from pathlib import Path

from . import pins
from .cache import Cache, key_of
from .node import INSIDE, code_key, run_script, tools_key
from .ours import APART, ENTRY, Ours
from .stdlib import NO_DOCSTRINGS, Used, append_selection, compile_archives, used_files


@dataclass(frozen=True)
class Start:
    """What every live page loads; `used.files` are in the archive `stdlib`."""

    wheel: Path
    stdlib: Path
    snapshot: Path
    used: Used


def make_start(core: Path, stdlib: Path, ours: Ours, cache: Cache) -> Start:
    """Return the set for `ours`. Raises RuntimePackError if our package can't be imported."""

    def make(folder: Path) -> None:
        source, wheel = folder / "source.zip", folder / ours.wheel_name
        ours.write_wheel(source)
        archive = {
            "from": str(source), "to": str(wheel), "optimize": NO_DOCSTRINGS, "wheel": True
        }  # fmt: skip
        compile_archives(core, [archive], folder)
        source.unlink()
        used = used_files(
            core, stdlib, folder,
            wheels=[wheel], perhaps=ours.imported_stdlib(), packages=["sim"],
            absent=pins.PACKAGES, apart=APART, entry=ENTRY,
        )  # fmt: skip
        (folder / "used.json").write_text(json.dumps(asdict(used)), encoding="utf-8")
        with zipfile.ZipFile(folder / "python.zip", "w") as target:
            append_selection(stdlib, used.files, target)
        job = {
            "core": f"{core}/", "stdlib": str(folder / "python.zip"), "wheel": str(wheel),
            "programs": [str(INSIDE / "used.py"), str(INSIDE / "warm.py")],
            "packages": ["sim"], "absent": list(pins.PACKAGES), "apart": list(APART),
            "entry": ENTRY,
            "out": str(folder / "memory.snapshot"),
        }  # fmt: skip
        run_script("snapshot.mjs", job, folder)

    code = code_key("snapshot", "stdlib", "ours")
    folder = cache.step("start", key_of(tools_key(), code, ours.key, *pins.CORE.values()), make)
    used = Used(**json.loads((folder / "used.json").read_text(encoding="utf-8")))
    return Start(folder / ours.wheel_name, folder / "python.zip", folder / "memory.snapshot", used)
