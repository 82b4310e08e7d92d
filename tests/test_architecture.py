"""Boundaries are tests: layers, light imports, small modules."""

from __future__ import annotations

import ast
import itertools
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from sim.scene.effects import kinds
from sim.scene.laws import laws

ROOT = Path(__file__).parents[1]
SIM = ROOT / "sim"

# A layer may import those to its right and itself: cli, pages, bridge -> classroom -> lesson and
# cli, pages, bridge -> measured -> dynamics -> effects, laws -> scene. `pages` computes only in
# bake.py, and inside functions.
MAY_IMPORT = {
    "scene": {"scene"},
    "effects": {"effects", "scene"},
    "laws": {"laws", "scene"},
    "dynamics": {"dynamics", "effects", "laws", "scene"},
    "worlds": {"worlds", "dynamics", "effects", "laws", "scene"},
    "mine": {"mine", "dynamics", "effects", "laws", "scene"},
    "certify": {"certify", "effects", "scene"},  # nothing of the run that it proves, see below
    "lesson": {"lesson", "scene"},
    "classroom": {"classroom", "lesson", "scene"},
    "country": {"country", "classroom", "lesson", "scene"},
    "measured": {"measured", "dynamics", "effects", "laws", "scene"},
    "bridge": {
        *("bridge", "certify", "classroom", "measured", "lesson", "mine", "worlds"),
        *("dynamics", "effects", "laws", "scene"),
    },
    "pages": {
        "pages",
        "bridge",
        "classroom",
        "measured",
        "lesson",
        "dynamics",
        "effects",
        "laws",
        "scene",
    },
    "cli": {
        "cli",
        "pages",
        "bridge",
        "classroom",
        "country",
        "certify",
        "measured",
        "mine",
        "worlds",
        "lesson",
        "dynamics",
        "effects",
        "scene",
    },
}
STANDARD_LIBRARY_ONLY = ("scene", "effects", "lesson", "mine", "worlds", "bridge")
ONLY_IN = {"js": "bridge/pyodide_entry.py", "pyodide": "bridge/pyodide_entry.py"}


def modules(layer: str) -> Iterator[Path]:
    return (SIM / layer).rglob("*.py")


def imported(path: Path) -> Iterator[str]:
    """Full names of everything that a module imports, inside functions too."""
    package = path.relative_to(ROOT).with_suffix("").parts[:-1]
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else ()
            module = ".".join([*base, *([node.module] if node.module else [])])
            yield module
            yield from (f"{module}.{name.name}" for name in node.names)


@pytest.mark.parametrize("layer", MAY_IMPORT)
def test_a_layer_imports_only_what_lies_further_in(layer: str) -> None:
    for path in modules(layer):
        for name in imported(path):
            parts = name.split(".")
            if parts[0] == "sim" and len(parts) > 1 and (SIM / parts[1]).is_dir():
                assert parts[1] in MAY_IMPORT[layer], f"{path.relative_to(ROOT)} imports {name}"


def test_a_proof_takes_no_force_of_the_run_that_it_proves() -> None:
    """Of effects it knows what is constant or linear in them: numbers, as the scene has them."""
    names = {name for path in modules("certify") for name in imported(path)}
    ours = {".".join(name.split(".")[:3]) for name in names if name.startswith("sim.effects")}
    assert ours == {"sim.effects.constant", "sim.effects.linear", "sim.effects.where"}
    for kind, part in itertools.product(kinds(), ("constant", "linear")):
        path = SIM / "effects" / kind / f"{part}.py"
        inside = set(imported(path)) if path.exists() else set()
        assert not [name for name in inside if name.endswith((".force", ".model", ".forces"))]


@pytest.mark.parametrize("layer", STANDARD_LIBRARY_ONLY)
def test_the_inner_layers_need_only_the_standard_library(layer: str) -> None:
    allowed = set(sys.stdlib_module_names) | {"sim", "__future__", "js", "pyodide"}
    for path in modules(layer):
        for name in imported(path):
            assert name.split(".")[0] in allowed, f"{path.relative_to(ROOT)} imports {name}"


def test_the_browsers_own_modules_are_imported_in_one_file_only() -> None:
    for path in SIM.rglob("*.py"):
        inside = path.relative_to(SIM).as_posix()
        for name in imported(path):
            only = ONLY_IN.get(name.split(".")[0])
            in_the_page = inside.startswith("pages/runtime/inside/")  # runs in Pyodide's Node
            assert only in (None, inside) or in_the_page, f"{inside} imports {name}"


@pytest.mark.parametrize("layer", ["dynamics", "laws", "measured"])
def test_numerics_import_numpy_and_scipy_only_when_used(layer: str) -> None:
    for path in modules(layer):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            names = (
                [a.name for a in getattr(node, "names", [])] if isinstance(node, ast.Import) else []
            )
            if isinstance(node, ast.ImportFrom):
                names = [node.module or ""]
            heavy = {name.split(".")[0] for name in names} & {"numpy", "scipy"}
            assert not heavy, f"{path.relative_to(ROOT)} imports {heavy} at its top"


def test_no_effect_is_named_outside_its_folder() -> None:
    """Code that decides by the name of a kind is code that a new effect has to change."""
    chains = re.compile(r"(?:kind|name) (?:==|!=|in) \(?[\"'](?:" + "|".join(kinds()) + r")[\"']")
    for layer in ("scene", "dynamics", "bridge", "cli", "certify"):
        for path in modules(layer):
            found = chains.findall(path.read_text(encoding="utf-8"))
            allowed = ['kind == "release"'] if path.name in EVENTS_CALLED_RELEASE else []
            assert [one for one in found if one not in allowed] == [], path.relative_to(ROOT)


EVENTS_CALLED_RELEASE = ("energy_parts.py",)
"""A kind of event has the name of the effect that it tells of."""


def test_no_law_is_named_outside_its_folder() -> None:
    names = "|".join(laws())
    chains = re.compile(rf"law\w* (?:==|!=|in) [\[(]?[\"'](?:{names})[\"']|startswith\([\"']push")
    of_a_contact = re.compile(rf"contact.*law[\"'\])]+ (?:==|!=|in) [\"'](?:{names})[\"']")
    for layer in ("scene", "dynamics", "bridge", "cli", "certify", "pages"):
        for path in modules(layer):
            text = path.read_text(encoding="utf-8")
            found = chains.findall(text) + of_a_contact.findall(text)
            assert not found, path.relative_to(ROOT)


ROOMS = {
    "state": {"state"},
    "motion": {"motion", "state", "result"},  # of `result` only what is refused
    "result": {"result", "state"},
    "loop": {"loop", "motion", "result", "state"},
    "report": {"report", "result", "motion", "state"},
}


@pytest.mark.parametrize("room", ROOMS)
def test_the_rooms_of_the_numerics_import_in_one_direction(room: str) -> None:
    for path in modules(f"dynamics/{room}"):
        for name in imported(path):
            if name.startswith("sim.dynamics."):
                assert name.split(".")[2] in ROOMS[room], f"{path.relative_to(ROOT)}: {name}"
    for path in modules("dynamics/motion"):
        assert {n for n in imported(path) if ".result." in n} <= {
            "sim.dynamics.result.outcome",
            "sim.dynamics.result.outcome.UnsolvedError",
        }


@pytest.mark.parametrize("layer", sorted(room.parent.name for room in SIM.glob("*/__init__.py")))
def test_no_modules_import_each_other_in_a_circle(layer: str) -> None:
    """Imports for types only and those inside functions count too."""
    names = {
        path.relative_to(ROOT).with_suffix("").as_posix().replace("/", "."): path
        for path in modules(layer)
        if path.name != "__init__.py"
    }
    open_: dict[str, set[str]] = {
        name: {other for other in imported(path) if other in names} - {name}
        for name, path in names.items()
    }
    while free := [name for name, needs in open_.items() if not needs]:
        for name in free:
            del open_[name]
        for needs in open_.values():
            needs.difference_update(free)
    assert not open_, f"in or behind a circle: {sorted(open_)}"


def test_no_module_holds_two_ideas() -> None:
    long = {
        path.relative_to(ROOT).as_posix(): count
        for pattern in ("**/*.py", "view/*.js", "web/src/**/*.js", "web/site/*.js")
        for path in SIM.glob(pattern)
        if (count := len(path.read_text(encoding="utf-8").splitlines())) > 250
    }
    assert not long, f"above 250 lines: {long}"


def test_no_function_is_longer_than_one_can_hold_in_the_head() -> None:
    long = {
        f"{path.relative_to(ROOT)}:{node.lineno} {node.name}": count
        for path in SIM.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))
        and (count := (node.end_lineno or 0) - node.lineno + 1) > 60
    }
    assert not long, f"above 60 lines: {long}"


def test_no_function_takes_more_than_one_can_tell_apart() -> None:
    many = {
        f"{path.relative_to(ROOT)}:{node.lineno} {node.name}": count
        for path in SIM.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))
        and (count := sum(map(len, (node.args.posonlyargs, node.args.args, node.args.kwonlyargs))))
        > 10
    }
    assert not many, f"above 10 parameters: {many}"


def test_no_test_module_is_imported_by_another_module() -> None:
    """What two of them need has a module of its own, named by what it holds."""
    for path in (ROOT / "tests").rglob("*.py"):
        for name in imported(path):
            room, *parts = name.split(".")
            ours = room == "tests" and any(part.startswith("test_") for part in parts)
            assert not ours, f"{path.relative_to(ROOT)} imports {name}"
