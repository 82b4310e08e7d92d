"""Our own package for the page: which files, which modules of the standard library they ask for.

Only the layers that run in a page are packed. The wheel is written file by file with fixed dates,
so that its bytes depend on the sources alone.
"""

from __future__ import annotations

import ast
import sys
import zipfile
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from .cache import key_of, sha256
from .stdlib import DATE

LAYERS = ("scene", "effects", "laws", "dynamics", "bridge")
"""What every live page runs. Questions are marked in JavaScript there."""
CLASSROOM_LAYERS = ("lesson", "classroom")
CLASSROOM_ENTRY = "bridge/class_answer.py"
"""With these a page also reads the files of a class: a package of its own, loaded only there."""
MEASURED_ENTRY = "bridge/measured_answer.py"
"""With this and the layer `measured` a page reads and fits what real carts did."""
WORLDS_ENTRY = "bridge/worlds_answer.py"
"""With this and the layer `worlds` a page runs what is impossible, where a scene names it."""
LAW_ENTRY = "bridge/law_answer.py"
"""With this and the layer `mine` a page runs and judges laws that its reader writes."""
PROOF_ENTRY = "bridge/certify_answer.py"
"""With this and the layer `certify` a page proves digits, once a reader asks for it."""
NOT_RUN = {"page.md", "proof.py", "scenes", "view.js", "views.js", "lesson_set.py", "synthetic.py"}
"""Beside what runs: a page carries no proofs, docs and scenes of effects, nor what makes a
lesson's readings, which holds their truth."""
NOT_IN_CLASS = (
    *("lesson/goal.py", "lesson/schema.py", "classroom/paper.py"),
    *(
        f"classroom/summary/{name}.py"
        for name in ("handed_on", "merge", "numbers", "of_answers", "once", "reading", "written")
    ),
)
"""What checks and builds lessons, and joins what schools hand on: only commands do."""
ENTRY = "sim.bridge.pyodide_entry"
NAME = "newtons-carts"
CLASSROOM = "newtons-carts-class"
TEACHER = "newtons-carts-teacher"
MEASURED = "newtons-carts-measured"
WORLDS = "newtons-carts-worlds"
OWN_LAW = "newtons-carts-law"
PROOF = "newtons-carts-proof"
ENCODINGS = tuple(
    f"encodings.{name}" for name in ("utf_8_sig", "utf_16", "cp1252", "gb18030", "cp950")
)
"""In which spreadsheets and old editors save a table."""
LAWS = Path(__file__).parents[2] / "laws"
APART = (
    *("sim.dynamics.batch", "sim.laws.many", "sim.bridge.map_answer", "sim.scene.schema"),
    *(f"sim.laws.{file.parent.name}.many" for file in sorted(LAWS.glob("*/many.py"))),
)
"""Left out of the picture of the memory: no scene needs them. Pages with maps carry packages too,
and those load the wheel."""


@dataclass(frozen=True)
class Ours:
    """The Python package that goes into the page: path in the wheel -> source."""

    files: tuple[tuple[str, bytes], ...]
    version: str
    name: str = NAME
    begins: tuple[str, ...] = ()  # modules that tell what else is needed; none: all of them
    also: tuple[str, ...] = ()  # modules that are found by name only when they are needed

    @property
    def key(self) -> str:
        """A name for exactly this content."""
        return key_of(self.version, *(f"{name} {sha256(data)}" for name, data in self.files))

    @property
    def wheel_name(self) -> str:
        """The file name of the wheel."""
        return f"{self.name.replace('-', '_')}-{self.version}-py3-none-any.whl"

    def imported_stdlib(self) -> list[str]:
        """Every standard module that is imported anywhere, inside functions too."""
        names: set[str] = set()
        for path, data in self.files:
            if path.endswith(".py"):
                names |= set(_imports(ast.parse(data)))
        return sorted(n for n in names if n.split(".")[0] in sys.stdlib_module_names)

    def write_wheel(self, out: Path) -> None:
        """Write the wheel with its sources; RECORD is left to whoever compiles it."""
        info = f"{self.name.replace('-', '_')}-{self.version}.dist-info"
        metadata = f"Metadata-Version: 2.1\nName: {self.name}\nVersion: {self.version}\n"
        tag = "Wheel-Version: 1.0\nGenerator: carts\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
        extra = {f"{info}/METADATA": metadata, f"{info}/WHEEL": tag, f"{info}/RECORD": ""}
        with zipfile.ZipFile(out, "w") as wheel:
            for name, data in (*self.files, *((n, t.encode()) for n, t in extra.items())):
                wheel.writestr(zipfile.ZipInfo(name, DATE), data)


def read_ours(package: Path, version: str) -> Ours:
    """Return the layers for the page of the package in folder `package`."""
    entries = (CLASSROOM_ENTRY, MEASURED_ENTRY, WORLDS_ENTRY, LAW_ENTRY, PROOF_ENTRY)
    others = [package / entry for entry in entries]
    found = [p for p in _layers(package, LAYERS) if p not in others]
    return _ours(package, version, NAME, [package / "__init__.py", *found])


def read_classroom(package: Path, version: str) -> Ours:
    """Return what the page "Class results" has beside `read_ours`."""
    found = [package / CLASSROOM_ENTRY, *_layers(package, CLASSROOM_LAYERS)]
    found = [p for p in found if not p.as_posix().endswith(NOT_IN_CLASS)]
    return replace(_ours(package, version, CLASSROOM, found), also=ENCODINGS)


def read_measured(package: Path, version: str) -> Ours:
    """Return what a page with readings of real carts has beside `read_ours`."""
    found = [package / MEASURED_ENTRY, *_layers(package, ("measured",))]
    return replace(
        _ours(package, version, MEASURED, found), also=("zipfile", "encodings.cp437", *ENCODINGS)
    )


def read_worlds(package: Path, version: str) -> Ours:
    """Return what a page has beside `read_ours` whose scenes name impossible worlds."""
    found = [package / WORLDS_ENTRY, *_layers(package, ("worlds",))]
    return _ours(package, version, WORLDS, found)


def read_own_law(package: Path, version: str) -> Ours:
    """Return what a page has beside `read_ours` on which somebody writes a law."""
    found = [package / LAW_ENTRY, *_layers(package, ("mine",))]
    return _ours(package, version, OWN_LAW, found)


def read_proof(package: Path, version: str) -> Ours:
    """Return what a page has beside `read_ours` once a reader asks which digits are proved."""
    found = [package / PROOF_ENTRY, *_layers(package, ("certify",))]
    return _ours(package, version, PROOF, found)


def _layers(package: Path, layers: Iterable[str]) -> list[Path]:
    found = (p for layer in layers for p in (package / layer).rglob("*"))
    return [p for p in found if not set(p.relative_to(package).parts) & NOT_RUN]


def _ours(package: Path, version: str, name: str, found: Iterable[Path]) -> Ours:
    kept = sorted(p for p in found if p.is_file() and "__pycache__" not in p.parts)
    files = ((p.relative_to(package.parent).as_posix(), text_bytes(p)) for p in kept)
    return Ours(tuple(files), version, name)


def text_bytes(path: Path) -> bytes:
    """A source with the line ends that every checkout packs."""
    return path.read_bytes().replace(b"\r\n", b"\n")  # a checkout on Windows packs the same bytes


def _imports(tree: ast.AST) -> Iterable[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield node.module
