"""`make test-old`: a lesson in each old browser, and the table of which browsers do what.

The table stands in docs/teachers/index.md; tests/browsers/test_old_table.py holds it equal to what
was seen here last (`seen.json`).
"""

from __future__ import annotations

import json
import sys

from .binaries import PACKAGES, ROOT, program
from .look import look
from .table import SEEN, table


def main() -> None:
    """Look, keep what was seen and print the table."""
    site = ROOT / "site"
    lesson, free = site / "worksheets" / "newtons-third-law.html", site / "index.html"
    seen: dict[str, dict[str, bool]] = {}
    for version in PACKAGES:
        try:
            seen[str(version)] = look(program(version), lesson, free)
        except (RuntimeError, TimeoutError) as error:
            sys.exit(f"Chromium {version}: {error}")
        print(version, seen[str(version)], flush=True)
    SEEN.write_text(json.dumps(seen, indent=1) + "\n", encoding="utf-8")
    print(table(seen))


main()
