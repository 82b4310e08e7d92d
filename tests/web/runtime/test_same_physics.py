"""The same cases run natively and inside the page: equal headers, equal numbers."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page

from sim.bridge.end_state import read
from sim.bridge.protocol import answer
from sim.pages.hard_cases import ALL
from tests import registry
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import build_site

pytestmark = pytest.mark.browser

LAST_BITS = 1e-13
"""Relative to the largest number of a column. Two math libraries may differ in the last bit of an
exponential or a sine, and a chain of contacts passes that on."""

WITHOUT_PACKAGES = [name for name in registry.NAMES if not name.startswith("hertz")]
"""Those need scipy: tests/web/scene/test_hertz.py."""

CASES: dict[str, dict[str, Any]] = {name: registry.plain(name) for name in WITHOUT_PACKAGES} | {
    "mass ratio 1e9": registry.two_carts(masses=(1e9, 1), velocities=(1, 0), law="paper"),
    "no restitution": registry.two_carts(law="bumper", restitution=0),
    "hardly any restitution": registry.two_carts(law="push-only", restitution="1e-6"),
    "a microsecond": registry.two_carts(velocities=("1e-9", 0), gap=0, stiffness=1e13, until=1e9),
    "a mistake": {"carts": {"A": {"mass": -1, "position": "here"}}, "colour": 1},
}


@pytest.fixture(scope="module")
def case_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build_site(tmp_path_factory.mktemp("cases") / "site")


@pytest.fixture(scope="module")
def page(case_site: Path, open_for_all: OpenPage) -> Page:
    """One start of Python for all cases."""
    opened = open_for_all(case_site / "index.html")
    opened.evaluate("window.booted")
    return opened


def test_every_case_gives_the_same_in_the_page(page: Page) -> None:
    for name, plain in CASES.items():
        request = {"id": 1, "kind": "run", "scene": plain}
        got = page.evaluate(
            """async (request) => {
                const { header, numbers } = await window.runtime.request(request);
                return { header, numbers: [...numbers] };
            }""",
            request,
        )
        header, numbers = answer(request)
        same(got["header"], header, name)
        assert len(got["numbers"]) == len(numbers), name
        rows = max(header.get("rows", 0), 1)
        for start in range(0, len(numbers), rows):
            column = numbers[start : start + rows]
            scale = max(map(abs, column)) or 1.0
            there = got["numbers"][start : start + rows]
            worst = max(abs(a - b) for a, b in zip(there, column, strict=True))
            assert worst <= LAST_BITS * scale, (name, header["columns"][start // rows])


def test_hard_cases_end_in_the_page_as_their_sources_say(page: Page) -> None:
    """Only the header crosses, no drawing."""
    rows = [case for case in ALL if case.events and case.has_formulas]  # few events, no scipy
    assert len(rows) >= 40
    for case in rows:
        header = page.evaluate(
            "async (request) => (await window.runtime.request(request)).header",
            {"id": 1, "kind": "run", "scene": case.plain, "samples": 2},
        )
        assert header["ok"], (case.name, header)
        for expected in case.expected:
            got = read(header, expected.what)
            assert abs(got - expected.value) <= expected.tolerance, (case.name, expected, got)


def same(there: Any, here: Any, where: str) -> None:
    """Equal word for word; numbers equal to the last bits of the larger ones around them."""
    if isinstance(here, dict):
        assert set(there) == set(here), where
        for key, value in here.items():
            same(there[key], value, f"{where}.{key}")
    elif isinstance(here, (list, tuple)):
        assert len(there) == len(here), where
        for k, (a, b) in enumerate(zip(there, here, strict=True)):
            same(a, b, f"{where}[{k}]")
    elif isinstance(here, (int, float)) and not isinstance(here, bool):
        assert math.isclose(there, here, rel_tol=LAST_BITS, abs_tol=LAST_BITS), where
    else:
        assert there == here, where
