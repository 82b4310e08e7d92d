"""Python starts in a page, by double click and served, and says so when it can't."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page

from sim.pages.runtime.payload import write_payload
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import STRICT, write_page
from tests.web.runtime.booted import (
    HURRIED,
    RUNTIME,
    booted,
    read_index,
    scripts,
    write_index,
)

pytestmark = pytest.mark.browser

Server = Callable[[Path], str]


@pytest.fixture(scope="module")
def started(open_for_all: OpenPage, boot_site: Path) -> Page:
    """A double-clicked page in which Python has started, for the tests that only look at it."""
    page = open_for_all(boot_site / "index.html")
    booted(page)
    return page


def hurried(open_page: OpenPage, site: Path) -> Page:
    """A page in which Python has started, and whose seconds are short from now on."""
    page = open_page(site / "index.html")
    booted(page)
    page.evaluate(HURRIED)
    return page


def test_python_answers_from_a_double_clicked_file(started: Page) -> None:
    result = booted(started)
    assert result["start"] == "snapshot"
    assert result["header"]["ok"] is True
    assert result["header"]["id"] == 7
    # one cart at 0.6 m/s for 2 s from 0.4 m: t, x, v, a at both ends
    assert result["numbers"] == pytest.approx([0, 2, 0.4, 1.6, 0.6, 0.6, 0, 0], abs=1e-15)


def test_python_answers_from_a_server(
    open_page: OpenPage, boot_site: Path, site_server: Server
) -> None:
    csp = STRICT.replace("connect-src 'none'", "connect-src 'self'")
    csp = csp.replace("worker-src blob:", "worker-src 'self' blob:")
    write_page(boot_site, name="hosted.html", csp=csp)
    result = booted(open_page(site_server(boot_site) + "/hosted.html"))
    assert result["start"] == "snapshot"
    assert result["header"]["ok"] is True


def test_nothing_of_the_payload_stays_in_the_page(started: Page) -> None:
    assert started.evaluate("Object.keys(window.__cartsParts)") == []
    assert started.evaluate("document.querySelectorAll('script[src*=runtime]').length") == 0


@pytest.mark.one_browser
def test_progress_only_grows(started: Page) -> None:
    fractions = [p["fraction"] for p in started.evaluate("window.progress")]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1


@pytest.mark.one_browser
def test_answers_come_in_the_order_of_the_requests(started: Page) -> None:
    ids = started.evaluate(
        """Promise.all([1, 2, 3].map((id) => runtime.request({ id, kind: "run", scene: {} })
             .then(({ header }) => [header.id, header.ok])))"""
    )
    assert ids == [[1, False], [2, False], [3, False]]


@pytest.mark.one_browser
def test_each_start_has_its_own_random_numbers(open_page: OpenPage, free_site: Path) -> None:
    seen = {booted(open_page(free_site / "index.html"))["header"]["random"] for _ in range(3)}
    assert len(seen) == 3


def test_a_damaged_snapshot_means_the_plain_way(open_page: OpenPage, broken_site: Path) -> None:
    part = scripts(broken_site, "memory.snapshot")[1]
    text = part.read_text(encoding="ascii")
    half = len(text) // 2
    part.write_text(text[:half] + "AAAAAAAA" + text[half + 8 :], encoding="ascii")
    result = booted(open_page(broken_site / "index.html"))
    assert result["start"] == "plain"
    assert result["header"]["ok"] is True


@pytest.mark.one_browser
def test_a_snapshot_of_another_pyodide_means_the_plain_way(
    open_page: OpenPage, broken_site: Path
) -> None:
    index = read_index(broken_site)
    payload = write_payload("memory.snapshot", bytes(31_457_280), broken_site / RUNTIME)
    index["files"]["memory.snapshot"] = payload.as_json()
    write_index(broken_site, index)
    result = booted(open_page(broken_site / "index.html"))
    assert result["start"] == "plain"
    assert result["header"]["ok"] is True


@pytest.mark.one_browser
def test_an_error_in_python_leaves_python_alive(open_page: OpenPage, free_site: Path) -> None:
    page = open_page(free_site / "index.html")
    booted(page)
    reason = page.evaluate("runtime.request({ run: '1 / 0' }).catch((e) => e.reason)")
    assert reason == "request-failed"
    assert page.evaluate("runtime.request({ run: '1 + 1' }).then((a) => a.header.result)") == 2


def test_a_numpy_page_has_numpy(open_page: OpenPage, free_site: Path) -> None:
    page = write_page(
        free_site, name="numpy.html", packages="numpy",
        request={"import": ["numpy"], "run": "__import__('numpy').linalg.det([[1, 2], [3, 4]])"},
    )  # fmt: skip
    header = booted(open_page(page))["header"]
    assert header["versions"] == ["2.4.3"]
    assert header["result"] == pytest.approx(-2, rel=1e-15)


@pytest.mark.one_browser
def test_a_scipy_page_has_scipy(open_page: OpenPage, free_site: Path) -> None:
    run = "float(__import__('scipy').integrate.quad(lambda x: x * x, 0, 3)[0])"
    page = write_page(
        free_site, name="scipy.html", packages="scipy",
        request={"import": ["scipy", "scipy.integrate", "scipy.optimize"], "run": run},
    )  # fmt: skip
    header = booted(open_page(page))["header"]
    assert header["versions"][0] == "1.18.0"
    assert header["result"] == pytest.approx(9, rel=1e-12)


@pytest.mark.one_browser
def test_imports_that_take_long_on_a_slow_laptop_are_waited_for(
    open_page: OpenPage, free_site: Path
) -> None:
    page = hurried(open_page, free_site)
    names = page.evaluate(
        """async () => {
             const write = `[open(f'/home/pyodide/slow{i}.py', 'w').write(
               'import time; time.sleep(0.7)') for i in range(4)] and [__import__('sys')
               .path.append('/home/pyodide')] and None`;
             await runtime.request({ run: write });
             const names = ["slow0", "slow1", "slow2", "slow3"]; // lost, if none were told
             return (await runtime.request({ import: names })).header.versions;
           }"""
    )
    assert names == [""] * 4


@pytest.mark.one_browser
def test_an_answer_that_tells_of_its_parts_may_take_longer_than_a_page_waits(
    open_page: OpenPage, free_site: Path
) -> None:
    page = hurried(open_page, free_site)
    told = page.evaluate(
        """(run) => runtime.request({ run }).then(({ header }) => header.result)""",
        "[__import__('time').sleep(0.7) or told[0]() for _ in range(4)] and 7",
    )
    assert told == 7


@pytest.mark.one_browser
def test_a_fit_may_take_longer_than_a_run_without_a_sign(
    open_page: OpenPage, free_site: Path
) -> None:
    """On a slow laptop readings are fitted for twenty seconds, and no picture waits for them."""
    page = hurried(open_page, free_site)
    ask = """([kind, run]) => runtime.request({ kind, run })
        .then(({ header }) => header.result, ({ reason }) => reason)"""
    silent = "__import__('time').sleep(2.5) or 7"
    assert page.evaluate(ask, ["measured", silent]) == 7
    assert page.evaluate(ask, ["run", silent]) == "worker-lost"


@pytest.mark.one_browser
def test_a_numpy_page_starts_the_plain_way_too(open_page: OpenPage, free_site: Path) -> None:
    index = read_index(free_site)
    parts = index["files"].pop("memory.snapshot")
    write_index(free_site, index)
    page = write_page(
        free_site,
        name="plain.html",
        packages="numpy",
        request={"import": ["numpy", "numpy.random"]},
    )
    result = booted(open_page(page))
    write_index(free_site, index | {"files": index["files"] | {"memory.snapshot": parts}})
    assert result["start"] == "plain"
    assert result["header"]["versions"][0] == "2.4.3"
