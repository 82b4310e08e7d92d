"""From opening the page to Python's first answer, against Pyodide as it is published.

The reference is the same page and the same worker with npm's unmodified standard library, Pyodide's
own numpy wheel and no snapshot. Both are opened in turn, so that what else the computer does hits
both alike; ratios of medians are compared, never seconds.
"""

from __future__ import annotations

import json
import shutil
import statistics
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, sync_playwright

from sim.pages.runtime import default_cache, pins
from sim.pages.runtime.cache import Cache
from sim.pages.runtime.payload import write_payload
from sim.pages.runtime.sources import core_files, package_wheels
from tests.web.conftest import CONTEXT, launch
from tests.web.runtime.boot_site import ROOT, build_site, write_page

RUNS = 5
RUNTIME = Path("assets") / "carts" / "runtime"

Row = dict[str, Any]


def rows() -> list[Row]:
    """Boot, numpy, size and memory."""
    with tempfile.TemporaryDirectory() as name, sync_playwright() as driver:
        sites = _sites(Path(name))
        found = [_size(sites["ours"])]
        for browser_name in ("chromium", "firefox"):
            browser = launch(driver, browser_name)
            found += _boots(browser, browser_name, sites)
            if browser_name == "chromium":
                found.append(_memory(browser, sites["ours"]))
            browser.close()
    return found


def _sites(folder: Path) -> dict[str, Path]:
    """Sites to compare: ours and published, without and with numpy."""
    ours = build_site(folder / "ours")
    with_numpy = build_site(folder / "ours-numpy", packages=frozenset({"numpy"}))
    write_page(with_numpy, packages="numpy")
    sites = {"ours": ours, "ours-numpy": with_numpy}
    for name in ("ours", "ours-numpy"):
        copy = shutil.copytree(sites[name], folder / name.replace("ours", "published"))
        _publish(copy)
        sites[copy.name] = copy
    return sites


def _publish(site: Path) -> None:
    """Put npm's and the distribution's files in place of ours, and take the snapshot away."""
    cache = Cache(default_cache(ROOT))
    core = core_files(cache, ROOT, _quiet)
    folder = site / RUNTIME
    text = (folder / "index.js").read_text(encoding="utf-8")
    index = json.loads(text.partition("=")[2].rstrip().rstrip(";"))
    index["files"].pop("memory.snapshot")
    replaced = {"python.zip": core[pins.STDLIB].read_bytes()}
    if "numpy" in index["wheels"]:
        name = index["wheels"]["numpy"]
        lock, loader = core[pins.LOCK], core[pins.LOADER]
        replaced[name] = package_wheels(["numpy"], lock, loader, cache, _quiet)[
            "numpy"
        ].read_bytes()
        index["tableAt"] = 0  # npm's standard library is whole
    for name, data in replaced.items():
        index["files"][name] = write_payload(name, data, folder).as_json()
    (folder / "index.js").write_text(f"self.__cartsRuntime = {json.dumps(index)};\n")


def _quiet(_: str) -> None:
    pass


def _boots(browser: Browser, browser_name: str, sites: dict[str, Path]) -> list[Row]:
    medians = _alternate(
        {name: lambda site=site: _live(browser, browser_name, site) for name, site in sites.items()}
    )
    plain, numpy = medians["published"], medians["published-numpy"]
    against = "npm's standard library, no snapshot"
    return [
        {
            "name": f"Python answers, {browser_name}, file://", "value": medians["ours"] / plain,
            "unit": f"ratio ({medians['ours']:.0f} ms / {plain:.0f} ms)", "goal": 0.20,
            "reference": against,
        },
        {
            "name": f"numpy live, {browser_name}, file://", "value": medians["ours-numpy"] / numpy,
            "unit": f"ratio ({medians['ours-numpy']:.0f} ms / {numpy:.0f} ms)", "goal": 0.33,
            "reference": f"{against}, Pyodide's wheel",
        },
        {
            "name": f"numpy live / bare Python, {browser_name}", "goal": None,
            "value": medians["ours-numpy"] / plain, "unit": "ratio",
            "reference": f"{against}, without numpy",
        },
    ]  # fmt: skip


def _alternate(measures: dict[str, Callable[[], float]]) -> dict[str, float]:
    """Return the median of each measure; one unmeasured round warms the disk."""
    found: dict[str, list[float]] = {name: [] for name in measures}
    for measured in range(RUNS + 1):
        for name, measure in measures.items():
            value = measure()
            if measured:
                found[name].append(value)
    return {name: statistics.median(values) for name, values in found.items()}


def _live(browser: Browser, browser_name: str, site: Path, *, again: bool = True) -> float:
    """Milliseconds from navigation to the first answer, in a fresh profile.

    A start that the page gave up, as other work left it no time, is no measurement: once more then.
    """
    context = browser.new_context(**CONTEXT[browser_name])
    try:
        page = context.new_page()
        page.goto((site / "index.html").as_uri())
        result = page.evaluate("window.booted")
        if again and result.get("reason") == "stalled":
            return _live(browser, browser_name, site, again=False)
        assert result.get("header", {}).get("ok"), result
        assert result["start"] == ("snapshot" if site.name.startswith("ours") else "plain")
        return float(result["ms"])
    finally:
        context.close()


def _size(site: Path) -> Row:
    size = sum(p.stat().st_size for p in (site / RUNTIME).iterdir())
    return {
        "name": "runtime files, without numpy", "value": size / 1e6, "unit": "MB on disk",
        "goal": 14, "reference": "once per site",
    }  # fmt: skip


def _memory(browser: Browser, site: Path) -> Row:
    """Resident memory of the page's process, above that of an empty page, after things settled."""
    (site / "empty.html").write_text("<!doctype html><title>Empty</title>", encoding="utf-8")
    used = {}
    for name in ("empty.html", "index.html"):
        context = browser.new_context()
        page = context.new_page()
        page.goto((site / name).as_uri())
        page.evaluate("window.booted")
        page.wait_for_timeout(3000)
        used[name] = max(_renderers(browser).values())
        context.close()
    return {
        "name": "memory of the page's process", "value": used["index.html"] - used["empty.html"],
        "unit": f"MB ({used['index.html']:.0f} − {used['empty.html']:.0f})", "goal": 150,
        "reference": "an empty page, Chromium",
    }  # fmt: skip


def _renderers(browser: Browser) -> dict[int, float]:
    """Resident memory in MB of Chromium's page processes, by process id."""
    session = browser.new_browser_cdp_session()
    found = {}
    for process in session.send("SystemInfo.getProcessInfo")["processInfo"]:
        if process["type"] == "renderer":
            status = Path(f"/proc/{process['id']}/status").read_text(encoding="ascii")
            line = next(line for line in status.splitlines() if line.startswith("VmRSS"))
            found[process["id"]] = int(line.split()[1]) * 1024 / 1e6
    session.detach()
    return found
