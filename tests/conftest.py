"""What every folder of tests may use: the real site, built once."""

from __future__ import annotations

import fcntl
import os
import re
import shutil
from collections.abc import Callable, Generator, Mapping
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers

ROOT = Path(__file__).parents[1]

# A helper that fails says both sides, as a test does.
pytest.register_assert_rewrite(*(f"tests.{room.stem}" for room in (ROOT / "tests").iterdir()))


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of this repository's own site, built for double click as `make site` does.
    `make test` has just done so, and says where: `CARTS_SITE_MADE`."""

    def make(folder: Path) -> None:
        if made := os.environ.get("CARTS_SITE_MADE"):
            shutil.copytree(ROOT / made, folder)
        else:
            _build(folder, hosted=False)

    return made_once(tmp_path_factory, "site", make)


@pytest.fixture(scope="session")
def hosted_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same for a web server, as `carts build --hosted` does, in a folder of the server as with
    GitHub's pages; teacher mode opens without a word."""

    def make(server: Path) -> None:
        _build(server / "school" / "p", hosted=True, settings={"teacher_word": ""})

    return made_once(tmp_path_factory, "server", make) / "school" / "p"


def _build(folder: Path, *, hosted: bool, settings: Mapping[str, object] | None = None) -> None:
    from sim.cli.site.build import build_site

    built = build_site(ROOT, hosted=hosted, strict=True, site_dir=folder, settings=settings)
    assert built is not None, "the site cannot be built: see the messages above"


def made_once(factory: pytest.TempPathFactory, name: str, make: Callable[[Path], object]) -> Path:
    """A folder that is not there yet, made by the first worker of a run that needs it. Tests do not
    write into it."""
    own = factory.getbasetemp()
    shared = own.parent if os.environ.get("PYTEST_XDIST_WORKER") else own
    folder = shared / f"shared-{name}"
    with (shared / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        done = shared / f"{name}.built"
        if not done.exists():
            shutil.rmtree(folder, ignore_errors=True)  # of a worker that failed
            make(folder)
            done.touch()
    return folder


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--fuzz", action="store_true", help="random tests, long and random: make fuzz")


def pytest_configure(config: pytest.Config) -> None:
    """Property tests repeat the same cases in CI; `make fuzz` runs many more, and new ones.

    Hypothesis also draws constants that it finds in the modules loaded so far: then the cases of a
    test would depend on which tests ran before it in its process.
    """
    assert hasattr(providers, "is_local_module_file")
    providers.is_local_module_file = lambda _path: False
    common = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow]}
    settings.register_profile("ci", derandomize=True, max_examples=100, **common)
    settings.register_profile("fuzz", max_examples=2_500, print_blob=True, **common)
    settings.load_profile("fuzz" if config.getoption("--fuzz") else "ci")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """A test that fails tells what its pages say, while they are still open."""
    report = yield
    if report.failed and call.when == "call":
        from tests.web.conftest import OPENED

        for number, page in enumerate(item.stash.get(OPENED, []), start=1):
            report.sections.append((f"page {number}", page.tell()))
    return report


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """`make fuzz` runs the random tests only. Files that take long come first: the last of them
    would else run alone, while the other worker has nothing left to do."""
    slow = {item.path for item in items if item.get_closest_marker("slow")}
    items.sort(key=lambda item: item.path not in slow)
    if config.getoption("--fuzz"):
        items[:] = [
            item
            for item in items
            if item.get_closest_marker("hypothesis") or re.search("properties|fuzz", item.nodeid)
        ]
    _in_one_browser(config, items)


def _in_one_browser(config: pytest.Config, items: list[pytest.Item]) -> None:
    """What is marked `one_browser` runs in Chromium only: its path through the page is tested in
    both by another test, and what it looks at is the same code."""
    others = [
        item
        for item in items
        if item.get_closest_marker("one_browser")
        and getattr(item, "callspec", None) is not None
        and item.callspec.params.get("browser_name") == "firefox"  # type: ignore[attr-defined]
    ]
    if others:
        config.hook.pytest_deselected(items=others)
        left = set(map(id, others))
        items[:] = [item for item in items if id(item) not in left]
