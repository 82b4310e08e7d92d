"""What came out of every hard case, kept in a file so that a build need not run them all.

python -m sim.pages.hard_cases.measured     writes it anew
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sim.pages.hard_cases import ALL
from sim.pages.hard_cases.row import HardCase

FILE = Path(__file__).with_suffix(".json")
DIGITS = 10
"""Of what stepping methods say; the exact solver's numbers are kept whole."""


def measured() -> dict[str, Any]:
    """By the name of the case: `exact` and `stepped`, as the page's request is answered."""
    found: dict[str, Any] = json.loads(FILE.read_text(encoding="utf-8"))
    return found


def request(case: HardCase) -> dict[str, Any]:
    """What the page asks for a case."""
    return {
        "kind": "hard",
        "scene": case.plain,
        "expected": [[one.what, one.value] for one in case.expected],
        "events": case.events,
    }


def measure(case: HardCase) -> dict[str, Any]:
    """Run it now; times are left out, they are of one computer."""
    from sim.bridge.protocol import answer

    header, _ = answer({"id": 1, **request(case)})
    assert header["ok"], header
    return {
        "exact": {"got": header["exact"]["got"]},
        "stepped": [_short(one) for one in header["stepped"]],
    }


def _short(stepped: Mapping[str, Any]) -> dict[str, Any]:
    def digits(value: float | None) -> float | None:
        return None if value is None else float(f"{value:.{DIGITS}g}")

    got = [digits(value) for value in stepped["got"]]
    return {**stepped, "got": got, "made": digits(stepped["made"])}


def main() -> None:
    """Write the file."""
    lines = [f"{json.dumps(case.name)}: {json.dumps(measure(case))}" for case in ALL]
    FILE.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
