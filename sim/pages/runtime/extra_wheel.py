"""Packages of ours that few pages load: see extras.py."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from . import pins
from .cache import Cache, key_of
from .node import code_key, tools_key
from .ours import Ours
from .stdlib import NO_DOCSTRINGS, compile_archives, used_files


@dataclass(frozen=True)
class ExtraWheel:
    """The compiled wheel, and the files of the standard library that it needs."""

    wheel: Path
    used: tuple[str, ...]


def make_extra_wheel(core: Path, stdlib: Path, ours: Path, extra: Ours, cache: Cache) -> ExtraWheel:
    """Return the wheel of `extra`; `ours` is the wheel that every page has."""

    def make(folder: Path) -> None:
        source, wheel = folder / "source.zip", folder / extra.wheel_name
        extra.write_wheel(source)
        archive = {
            "from": str(source), "to": str(wheel), "optimize": NO_DOCSTRINGS, "wheel": True
        }  # fmt: skip
        compile_archives(core, [archive], folder)
        source.unlink()
        modules = extra.begins or tuple(
            name.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
            for name, _ in extra.files
            if name.endswith(".py")
        )
        named = [*modules, *extra.also]
        used = used_files(core, stdlib, folder, wheels=[ours, wheel], modules=named)
        (folder / "used.txt").write_text("\n".join(used.files), encoding="utf-8")

    code = code_key("extra_wheel", "stdlib", "ours")
    key = key_of(tools_key(), code, extra.key, ours.parent.name, *pins.CORE.values())
    folder = cache.step(extra.name, key, make)
    used = (folder / "used.txt").read_text(encoding="utf-8").split()
    return ExtraWheel(folder / extra.wheel_name, tuple(used))
