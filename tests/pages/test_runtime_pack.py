"""Packing Python for the page: the same bytes everywhere, checked bytes only, small enough."""

from __future__ import annotations

import base64
import gzip
import io
import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest

from sim.pages.runtime import (
    RuntimeFacts,
    RuntimePackError,
    default_cache,
    pack,
)
from sim.pages.runtime.cache import sha256
from sim.pages.runtime.classic import classic_script
from sim.pages.runtime.lock import release_lock
from tests.pages.given.packed_runtime import quiet, read_index
from tests.web.runtime.boot_site import write_stand_in

ROOT = Path(__file__).parents[2]
# Once per site, without numpy and scipy.
MOST_BYTES = 14_000_000


@pytest.fixture(scope="module")
def packed(tmp_path_factory: pytest.TempPathFactory) -> RuntimeFacts:
    site = tmp_path_factory.mktemp("site")
    return pack(site, packages=frozenset(), cache=default_cache(ROOT), report=quiet)


def payload(folder: Path, name: str) -> bytes:
    """Put a file together as the page does, checking every part."""
    entry = read_index(folder)["files"][name]
    packed = b""
    for number, part in enumerate(entry["parts"]):
        text = (folder / part["src"]).read_text(encoding="ascii")
        assert text.startswith(f'(self.__cartsParts??={{}})["{name}.{number}"]="')
        chunk = base64.b64decode(text.split('"')[3])
        assert sha256(chunk) == part["sha256"]
        packed += chunk
    data = gzip.decompress(packed)
    assert len(data) == entry["size"]
    return data


def contents(folder: Path) -> dict[str, str]:
    return {p.name: sha256(p.read_bytes()) for p in sorted(folder.iterdir())}


def test_the_runtime_fits_on_a_usb_stick_many_times(packed: RuntimeFacts) -> None:
    assert packed.size <= MOST_BYTES
    assert packed.size == sum(p.stat().st_size for p in packed.folder.iterdir())


def test_every_part_has_the_hash_that_the_index_names(packed: RuntimeFacts) -> None:
    names = read_index(packed.folder)["files"]
    assert {"pyodide.js", "pyodide.asm.wasm", "memory.snapshot", "python.zip"} < set(names)
    for name in names:
        assert payload(packed.folder, name)


def test_the_page_gets_bytecode_and_no_sources(packed: RuntimeFacts) -> None:
    import io
    import zipfile

    wheel = read_index(packed.folder)["wheels"]["newtons-carts"]
    for name in ("python.zip", wheel):
        with zipfile.ZipFile(io.BytesIO(payload(packed.folder, name))) as archive:
            assert not [n for n in archive.namelist() if n.endswith(".py")]
            assert [n for n in archive.namelist() if n.endswith(".pyc")]


def test_modules_that_are_not_in_the_picture_have_a_wheel_of_their_own(
    packed: RuntimeFacts,
) -> None:
    index = read_index(packed.folder)
    with zipfile.ZipFile(
        io.BytesIO(payload(packed.folder, index["wheels"][index["rest"]]))
    ) as rest:
        modules = {name for name in rest.namelist() if name.endswith(".pyc")}
    named = {name.replace(".", "/") for name in index["later"]}
    assert modules == {
        f"{name}/__init__.pyc" if f"{name}/__init__.pyc" in modules else f"{name}.pyc"
        for name in named
    }


def test_the_lock_has_the_hash_of_our_wheel(packed: RuntimeFacts) -> None:
    index = read_index(packed.folder)
    entry = index["lock"]["packages"]["newtons-carts"]
    assert entry["sha256"] == sha256(payload(packed.folder, entry["file_name"]))


def test_no_trace_of_this_machine_is_packed(packed: RuntimeFacts) -> None:
    traces = [str(ROOT), str(default_cache(ROOT)), sys.prefix]
    for name in read_index(packed.folder)["files"]:
        data = payload(packed.folder, name)
        assert not [trace for trace in traces if trace.encode() in data], name


PACK = """
import sys
from pathlib import Path
from sim.pages.runtime import pack
site, cache = map(Path, sys.argv[1:])
pack(site, packages=frozenset(), cache=cache, report=lambda _: None)
"""


@pytest.mark.slow
def test_two_packs_are_equal_to_the_last_byte(packed: RuntimeFacts, tmp_path: Path) -> None:
    """Other folder, time zone, language and hash seed; nothing shared, not even the cache."""
    other = {"TZ": "America/St_Johns", "LC_ALL": "C", "PYTHONHASHSEED": "2"}
    site = tmp_path / "quite another folder"
    subprocess.run(
        [sys.executable, "-c", PACK, str(site), str(tmp_path / "cache")],
        env={**os.environ, **other}, cwd=ROOT, check=True,
    )  # fmt: skip
    assert contents(site / "assets" / "carts" / "runtime") == contents(packed.folder)


@pytest.mark.slow
def test_an_edit_of_ours_changes_only_what_holds_it(tmp_path: Path) -> None:
    source = write_stand_in(tmp_path / "source")
    cache = default_cache(ROOT)
    site = tmp_path / "site"
    before = pack(site, packages=frozenset(), cache=cache, report=quiet, source=source).files
    entry = source / "bridge" / "pyodide_entry.py"
    entry.write_text(entry.read_text(encoding="utf-8") + "\nEDITED = 1\n", encoding="utf-8")
    compiled = {p: p.stat().st_mtime_ns for p in cache.glob("stdlib-*/stdlib.zip")}
    after = pack(site, packages=frozenset(), cache=cache, report=quiet, source=source).files
    assert {p: p.stat().st_mtime_ns for p in cache.glob("stdlib-*/stdlib.zip")} == compiled
    changed = {name.split(".")[0] for name in set(before) ^ set(after)}
    assert changed == {"memory", "newtons_carts-0"}
    index = read_index(site / "assets" / "carts" / "runtime")
    entry_of_lock = index["lock"]["packages"]["newtons-carts"]
    wheel = payload(site / "assets" / "carts" / "runtime", entry_of_lock["file_name"])
    assert entry_of_lock["sha256"] == sha256(wheel)  # and not that of the lock before
    assert contents(site / "assets" / "carts" / "runtime").keys() == after.keys()


def test_a_module_that_can_not_be_imported_stops_the_build(tmp_path: Path) -> None:
    source = write_stand_in(tmp_path)
    (source / "scene" / "wrong.py").write_text("import no_such_module\n", encoding="utf-8")
    with pytest.raises(RuntimePackError, match="no_such_module"):
        pack(tmp_path, packages=frozenset(), cache=default_cache(ROOT), report=quiet, source=source)


def test_an_unknown_package_is_refused(tmp_path: Path) -> None:
    with pytest.raises(RuntimePackError, match="pandas"):
        pack(tmp_path, packages=frozenset({"pandas"}), cache=tmp_path, report=quiet)


def test_another_text_of_pyodide_is_noticed() -> None:
    with pytest.raises(RuntimePackError, match="once was expected"):
        classic_script("export const a = 1;", "export default somethingElse;", "0")


def test_without_pyodide_build_the_locks_entries_are_those_of_the_release(tmp_path: Path) -> None:
    """As on Python 3.11: numpy is the distribution's own wheel, ours has an entry of its own."""
    release = tmp_path / "lock.json"
    entry = {"name": "numpy", "file_name": "numpy-2.4.3-x.whl", "sha256": "0" * 64, "depends": []}
    release.write_text(json.dumps({"info": {"python": "3.14.0"}, "packages": {"numpy": entry}}))
    ours = tmp_path / "newtons_carts-0.1.0-py3-none-any.whl"
    ours.write_bytes(b"wheel")
    packages: Any = release_lock(release, {"newtons-carts": ours, "numpy": ours})["packages"]
    assert packages["numpy"]["sha256"] == entry["sha256"]
    assert packages["newtons-carts"]["sha256"] == sha256(b"wheel")
    assert packages["newtons-carts"]["version"] == "0.1.0"
