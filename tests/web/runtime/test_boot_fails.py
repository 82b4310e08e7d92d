"""A start that fails is told within ten seconds, and what failed is named."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import STRICT, write_page
from tests.web.runtime.booted import HURRIED, HURRY, RUNTIME, TOLD_WITHIN, booted, scripts

pytestmark = pytest.mark.browser


AGAIN = pytest.mark.one_browser  # the same code as for the first of them


LOADED = ["pyodide.js", *(pytest.param(n, marks=AGAIN) for n in ("pyodide.asm.wasm", "python.zip"))]


@pytest.mark.parametrize("name", LOADED)
def test_a_truncated_file_is_named_as_damaged(
    open_page: OpenPage, broken_site: Path, name: str
) -> None:
    part = scripts(broken_site, name)[0]
    text = part.read_bytes()
    part.write_bytes(text[: len(text) // 2])
    result = booted(open_page(broken_site / "index.html"))
    assert result["reason"] == "payload-damaged"
    assert "damaged" in result["message"]
    assert result["waited"] < TOLD_WITHIN


@pytest.mark.parametrize("name", ["index", *LOADED])
def test_a_missing_file_is_named_as_missing(
    open_page: OpenPage, broken_site: Path, name: str
) -> None:
    (
        broken_site / RUNTIME / "index.js" if name == "index" else scripts(broken_site, name)[0]
    ).unlink()
    result = booted(open_page(broken_site / "index.html"))
    assert result["reason"] == "payload-missing"
    assert "missing" in result["message"]
    assert result["waited"] < TOLD_WITHIN


@pytest.mark.one_browser
def test_a_page_whose_package_was_not_packed_says_so(open_page: OpenPage, boot_site: Path) -> None:
    page = write_page(boot_site, name="numpy.html", packages="numpy")
    result = booted(open_page(page))
    assert result["reason"] == "not-packed"
    assert "without Python" in result["message"]


def test_wasm_refused_by_the_policy_is_told(open_page: OpenPage, boot_site: Path) -> None:
    page = write_page(boot_site, name="refused.html", csp=STRICT.replace(" 'wasm-unsafe-eval'", ""))
    result = booted(open_page(page))
    assert result["reason"] == "wasm-refused"
    assert result["waited"] < TOLD_WITHIN


def test_a_worker_refused_by_the_policy_is_told(open_page: OpenPage, boot_site: Path) -> None:
    csp = STRICT.replace("worker-src blob:", "worker-src 'none'")
    result = booted(open_page(write_page(boot_site, name="no-worker.html", csp=csp)))
    assert result["reason"] == "worker-refused"
    assert result["waited"] < TOLD_WITHIN


@pytest.mark.one_browser
@pytest.mark.parametrize(
    ("lost", "reason"), [("WebAssembly", "no-wasm"), ("DecompressionStream", "too-old")]
)
def test_an_older_browser_is_told(
    open_page: OpenPage, boot_site: Path, lost: str, reason: str
) -> None:
    (boot_site / "older.js").write_text(f"delete window.{lost};\n", encoding="utf-8")
    page = write_page(boot_site, name="older.html", before='<script src="older.js"></script>')
    result = booted(open_page(page))
    assert result["reason"] == reason
    assert result["waited"] < TOLD_WITHIN


@pytest.mark.one_browser
def test_a_worker_that_dies_while_it_starts_is_told(open_page: OpenPage, boot_site: Path) -> None:
    """First that it takes long, as of a computer that is only slow; then that it is given up."""
    (boot_site / "dying.js").write_text(
        HURRIED + "window.Worker = class extends Worker {\n"
        "  constructor(...given) { super(...given); setTimeout(() => this.terminate(), 50); }\n"
        "};\n"
        "window.bootPatience = 6;\n",
        encoding="utf-8",
    )
    page = open_page(
        write_page(boot_site, name="dying.html", before='<script src="dying.js"></script>')
    )
    assert booted(page)["reason"] == "stalled"
    assert page.evaluate("window.slowAfter") < TOLD_WITHIN


def test_a_worker_killed_later_is_told_and_can_be_replaced(
    open_page: OpenPage, boot_site: Path
) -> None:
    page = open_page(boot_site / "index.html")
    booted(page)
    page.evaluate(HURRIED)
    lost = page.evaluate(
        """async () => {
             const told = new Promise((resolve) => { runtime.onlost = resolve; });
             const before = waited;
             runtime.worker.terminate();
             const reason = await runtime.request({ kind: "run" }).catch((e) => e.reason);
             return { reason, told: (await told).reason, waited: waited - before };
           }"""
    )
    assert lost["reason"] == lost["told"] == "worker-lost"
    assert lost["waited"] * HURRY < TOLD_WITHIN
    again = page.evaluate(
        """async () => {
             const runtime = await startRuntime({ base: runtimeBase });
             return (await runtime.request({ id: 9, kind: "run" })).header.id;
           }"""
    )
    assert again == 9


def test_an_endless_run_is_ended(open_page: OpenPage, free_site: Path) -> None:
    page = open_page(free_site / "index.html")
    booted(page)
    page.evaluate(HURRIED)
    lost = page.evaluate(
        """async () => {
             const before = waited;
             const request = { run: "[0 for i in iter(int, 1)]" };
             const reason = await runtime.request(request).catch((e) => e.reason);
             return { reason, waited: waited - before };
           }"""
    )
    assert lost["reason"] == "worker-lost"
    assert lost["waited"] * HURRY < TOLD_WITHIN
