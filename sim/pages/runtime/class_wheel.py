"""The package of the page "Class results": questions and statistics, loaded by that page alone."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from . import pins
from .cache import Cache, key_of
from .node import code_key, tools_key
from .ours import CLASSROOM, Ours
from .stdlib import NO_DOCSTRINGS, compile_archives, used_files


@dataclass(frozen=True)
class ClassWheel:
    """The compiled wheel, and the files of the standard library that it needs."""

    wheel: Path
    used: tuple[str, ...]


def make_class_wheel(
    core: Path, stdlib: Path, ours: Path, classroom: Ours, cache: Cache
) -> ClassWheel:
    """Return the wheel of `classroom`; `ours` is the wheel that every page has."""

    def make(folder: Path) -> None:
        source, wheel = folder / "source.zip", folder / classroom.wheel_name
        classroom.write_wheel(source)
        archive = {
            "from": str(source), "to": str(wheel), "optimize": NO_DOCSTRINGS, "wheel": True
        }  # fmt: skip
        compile_archives(core, [archive], folder)
        source.unlink()
        modules = [
            name.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
            for name, _ in classroom.files
            if name.endswith(".py")
        ]
        used = used_files(core, stdlib, folder, wheels=[ours, wheel], modules=modules)
        (folder / "used.txt").write_text("\n".join(used.files), encoding="utf-8")

    code = code_key("class_wheel", "stdlib", "ours")
    key = key_of(tools_key(), code, classroom.key, ours.parent.name, *pins.CORE.values())
    folder = cache.step(CLASSROOM, key, make)
    used = (folder / "used.txt").read_text(encoding="utf-8").split()
    return ClassWheel(folder / classroom.wheel_name, tuple(used))
