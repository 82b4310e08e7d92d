"""What a site takes of the runtimes that an installed wheel carries ready-made."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sim.pages.runtime import ready
from sim.pages.runtime.cache import sha256
from sim.pages.runtime.ours import PROOF, TEACHER, WORLDS, Ours

OURS = Ours((), "1")
PACKAGES = {"numpy": "numpy-2.whl", TEACHER: "teacher-1.whl", WORLDS: "worlds-1.whl"}


@pytest.fixture
def carried(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """One set with all of them, each a file of one script."""
    monkeypatch.setattr(ready, "_sources", lambda *_: "made from these")
    files: dict[str, Any] = {}
    for name in ("pyodide.js", "ours.whl", "proof.whl", *PACKAGES.values()):
        (tmp_path / f"{name}.0.js").write_text(name, encoding="utf-8")
        files[name] = {"parts": [{"src": f"{name}.0.js"}]}
    entry = {
        "packages": sorted({PROOF, *PACKAGES}),
        "sources": "made from these",
        "scripts": {path.name: sha256(path.read_bytes()) for path in tmp_path.glob("*.js")},
        "index": {
            "files": files,
            "wheels": {"newtons-carts": "ours.whl", PROOF: "proof.whl", **PACKAGES},
        },
        "versions": {"pyodide": "314", "numpy": "2"},
    }
    (tmp_path / "0.json").write_text(json.dumps(entry), encoding="utf-8")
    return tmp_path


def taken(folder: Path, *packages: str) -> tuple[set[str], dict[str, Any], set[str]]:
    found = ready.find_ready(folder, frozenset({PROOF, *packages}), OURS, folder)
    assert found is not None
    return set(found.scripts), dict(found.index), set(found.versions)


def test_a_site_gets_the_packages_that_it_asks_for_and_no_other(carried: Path) -> None:
    """Teacher mode's carry works of others, whose licences only a site with teacher mode lists."""
    scripts, index, versions = taken(carried)
    assert scripts == {f"{name}.0.js" for name in ("pyodide.js", "ours.whl", "proof.whl")}
    assert set(index["wheels"]) == {"newtons-carts", PROOF}
    assert set(index["files"]) == {"pyodide.js", "ours.whl", "proof.whl"}
    assert versions == {"pyodide"}


def test_what_a_site_asks_for_is_there(carried: Path) -> None:
    scripts, index, _ = taken(carried, TEACHER, "numpy")
    assert {"teacher-1.whl.0.js", "numpy-2.whl.0.js"} <= scripts
    assert set(index["wheels"]) == {"newtons-carts", PROOF, TEACHER, "numpy"}
    assert "worlds-1.whl.0.js" not in scripts
