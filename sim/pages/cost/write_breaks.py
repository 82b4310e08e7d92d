"""`python -m sim.pages.cost.write_breaks`: the map of where methods break, made anew.

It takes some minutes and is a file, as the tables are: so many steps are too many for a build. What
depends on the computer are last bits, which no letter of the map shows.
"""

from __future__ import annotations

import json

from sim.pages.cost.render import BREAKS


def main() -> None:
    """Write the file."""
    from sim.dynamics.cost.breaks import document  # pulls the numerics

    text = json.dumps(document(), ensure_ascii=False, separators=(",", ":"))
    BREAKS.write_text(text.replace('{"name"', '\n{"name"') + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
