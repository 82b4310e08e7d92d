"""Where Pyodide's files come from: places in order, checked bytes, a cache that is not believed."""

from __future__ import annotations

import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from sim.pages.runtime import MissingSourceError, pack
from sim.pages.runtime import cache as cache_room
from sim.pages.runtime.cache import Cache, default_cache, sha256
from sim.pages.runtime.ours import NOT_IN_CLASS, NOT_RUN, read_classroom
from sim.pages.runtime.pack import PACKAGE
from sim.pages.runtime.places import Place
from sim.pages.runtime.sources import Wanted, collect
from tests.pages.given.packed_runtime import quiet, read_index


def place(what: str, **files: bytes) -> Place:
    return Place(what, lambda names, _folder, _report: {n: files[n] for n in names if n in files})


def broken_place() -> Place:
    def fetch(*_: object) -> dict[str, bytes]:
        raise OSError("no way out")

    return Place("the network", fetch)


def test_places_are_asked_in_order_and_only_for_what_is_missing(tmp_path: Path) -> None:
    cache = Cache(tmp_path)
    wanted = [Wanted("a", sha256(b"A")), Wanted("b", sha256(b"B"))]
    found = collect(wanted, [place("one", a=b"A"), place("two", a=b"no", b=b"B")], cache, quiet)
    assert {name: path.read_bytes() for name, path in found.items()} == {"a": b"A", "b": b"B"}
    again = collect(wanted, [broken_place()], cache, quiet)
    assert again == found


def test_bytes_with_another_hash_are_never_used(tmp_path: Path) -> None:
    with pytest.raises(MissingSourceError, match="a has the wrong sha256"):
        collect([Wanted("a", sha256(b"A"))], [place("one", a=b"B")], Cache(tmp_path), quiet)


def test_a_damaged_cache_is_not_believed(tmp_path: Path) -> None:
    cache = Cache(tmp_path)
    cache.keep(b"A").write_bytes(b"X")
    found = collect([Wanted("a", sha256(b"A"))], [place("one", a=b"A")], cache, quiet)
    assert found["a"].read_bytes() == b"A"


def test_a_damaged_step_is_made_again(tmp_path: Path) -> None:
    cache = Cache(tmp_path)

    def make(folder: Path) -> None:
        (folder / "result").write_text("right", encoding="utf-8")

    result = cache.step("step", "key", make) / "result"
    result.write_text("wrong", encoding="utf-8")
    assert (cache.step("step", "key", make) / "result").read_text(encoding="utf-8") == "right"


def test_what_is_missing_is_named_with_what_was_tried(tmp_path: Path) -> None:
    with pytest.raises(MissingSourceError) as caught:
        collect([Wanted("a.whl", "0" * 64)], [broken_place()], Cache(tmp_path), quiet)
    text = str(caught.value)
    assert "a.whl" in text
    assert "the network: no way out" in text
    assert "What helps" in text


@pytest.mark.parametrize("cut", [tarfile.ReadError, zipfile.BadZipFile, StopIteration, EOFError])
def test_after_a_cut_download_the_next_place_is_asked(tmp_path: Path, cut: type[Exception]) -> None:
    def fetch(*_: object) -> dict[str, bytes]:
        raise cut

    found = collect(
        [Wanted("a", sha256(b"A"))],
        [Place("one", fetch), place("two", a=b"A")],
        Cache(tmp_path),
        quiet,
    )
    assert found["a"].read_bytes() == b"A"
    with pytest.raises(MissingSourceError, match="one: what came is cut or damaged"):
        collect([Wanted("b", sha256(b"B"))], [Place("one", fetch)], Cache(tmp_path), quiet)


@pytest.fixture
def nothing_to_be_had(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    for name in ("from_node_modules", "from_npm", "from_cdn", "from_carrier"):
        monkeypatch.setattr(f"sim.pages.runtime.sources.{name}", lambda *_: broken_place())
    yield


@pytest.mark.usefixtures("nothing_to_be_had")
def test_a_missing_source_is_an_error_in_an_automatic_build(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CI", "true")
    with pytest.raises(MissingSourceError, match=r"pyodide\.asm\.wasm"):
        pack(tmp_path, packages=frozenset(), cache=tmp_path / "cache", report=quiet)


@pytest.mark.usefixtures("nothing_to_be_had")
def test_elsewhere_the_page_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("CI", raising=False)
    told: list[str] = []
    facts = pack(tmp_path, packages=frozenset(), cache=tmp_path / "cache", report=told.append)
    assert "pyodide.asm.wasm" in facts.missing
    assert any("What helps" in text for text in told)
    assert list(facts.files) == ["index.js"]
    assert "pyodide.asm.wasm" in read_index(facts.folder)["missing"]


def test_the_class_page_carries_only_what_it_runs() -> None:
    """Each module of its package is imported sooner or later by what answers it."""
    carried = {
        name.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
        for name, _ in read_classroom(PACKAGE, "0").files
        if name.endswith(".py")
    }
    said = "import sys, sim.bridge.class_answer; print(*sys.modules)"
    run = [sys.executable, "-c", said]
    imported = subprocess.run(run, capture_output=True, text=True, check=True).stdout.split()
    assert carried - set(imported) == set()


def test_what_a_page_does_not_carry_is_there_to_be_left_out() -> None:
    """A file that has got another name would go along without a word."""
    ours = Path(PACKAGE)
    assert [name for name in NOT_RUN if not any(ours.rglob(name))] == []
    assert [path for path in NOT_IN_CLASS if not (ours / path).is_file()] == []


def test_a_second_site_takes_what_this_copy_of_the_project_has_downloaded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each new site fetched 106 MB again."""
    monkeypatch.delenv("CARTS_CACHE", raising=False)
    ours, site = tmp_path / "ours", tmp_path / "site"
    monkeypatch.setattr(cache_room, "OURS", ours)
    assert default_cache(site) == site / ".cache"  # an installed wheel
    ours.mkdir()
    assert default_cache(site) == ours
    (site / ".cache").mkdir(parents=True)
    assert default_cache(site) == site / ".cache"  # as it was
    monkeypatch.setenv("CARTS_CACHE", str(tmp_path / "told"))
    assert default_cache(site) == tmp_path / "told"
