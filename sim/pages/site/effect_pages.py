"""The pages of the effects: each stands in its effect's folder and joins the docs at build time.

sim/effects/drag/page.md  ->  physics/effects/drag.html, a line in the navigation and one in the
                              table of `physics/effects/index.md`, from the front matter of the page
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import yaml

import sim.effects
from sim.scene.effects import kinds

PLACE = "physics/effects/"
INDEX = f"{PLACE}index.md"
ROWS = "<!-- one row for each effect -->"
EFFECTS = "sim/effects/"
SCENES = f"{EFFECTS}*/scenes"
"""Where effects keep their scenes, from the root of the project."""


def effect_pages() -> dict[str, Path]:
    """The page of each effect by its address, in the order of lists."""
    folder = Path(sim.effects.__path__[0])
    return {f"{PLACE}{name}.md": folder / name / "page.md" for name in kinds()}


def with_effects(nav: list[Any]) -> list[Any]:
    """The navigation with the entry `physics/effects/` replaced by the pages of all effects."""
    found: list[Any] = []
    for item in nav:
        if item == PLACE:
            found += effect_pages()
        elif isinstance(item, Mapping):
            found.append(
                {k: with_effects(v) if isinstance(v, list) else v for k, v in item.items()}
            )
        else:
            found.append(item)
    return found


def index_text(text: str) -> str:
    """The text of the index with a row for each effect in its table."""
    return text.replace(ROWS, "\n".join(_row(path) for path in effect_pages().values()))


def _row(page: Path) -> str:
    name = page.parent.name
    _, front, _ = page.read_text(encoding="utf-8").split("---\n", 2)
    said = yaml.safe_load(front)
    return f"| [{name}]({name}.md) | {said['force']} | {said['acts_on']} | {said['energy']} |"
