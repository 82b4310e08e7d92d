"""`carts cost SCENE.yml --json | python -m sim.pages.cost.write_measured NAME`: a table made anew.

It is kept rounded, with what `carts` leaves out: when and with which Python it was measured.
"""

from __future__ import annotations

import json
import platform
import sys
from collections.abc import Mapping
from datetime import date
from typing import Any

from sim.pages.cost.render import MEASURED, WHEN

FIGURES = 4
"""Of errors and times: the next one differs from run to run."""


def rounded(value: Any) -> Any:
    """A number, or those of a list."""
    if isinstance(value, list):
        return [rounded(one) for one in value]
    return float(f"{value:.{FIGURES}g}") if isinstance(value, float) else value


def text_of(document: Mapping[str, Any], day: date) -> str:
    """The file: a line for each row; steps are kept whole, they are asked for by their length."""
    values = {
        "day": f"{day.day} {day:%B %Y}",
        "python": f"CPython {platform.python_version().rpartition('.')[0]}",
    }
    head = {
        "format": document["format"],
        "scene": document["scene"],
        "measured": {"code": WHEN, "values": values},
        "proved": document["proved"],
        "floor": rounded(document["floor"]),
        "digits": document["digits"],
    }
    rows = [
        {key: value if key == "step" else rounded(value) for key, value in row.items()}
        for row in document["rows"]
    ]
    lines = ",\n".join(json.dumps(row) for row in rows)
    return json.dumps(head)[:-1] + f', "rows": [\n{lines}\n]}}\n'


def main() -> None:
    """Read the document, write the file."""
    (name,) = sys.argv[1:]
    text = text_of(json.load(sys.stdin), date.today())
    (MEASURED / f"{name}.json").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
