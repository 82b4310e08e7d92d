"""`<carts-worlds>`: the worlds that a scene names.

The element stands empty until the run was watched: which world is impossible tells how ours is.
What happens there is computed when a reader asks for it.
"""

from __future__ import annotations

from html import escape
from typing import Any

from sim.pages.language import told
from sim.pages.templates import script_json

WORLDS = "newtons-carts-worlds"
"""The package of the runtime that runs them."""


def render_worlds(fence: Any) -> str:
    """The element behind the scene; empty where it names no world."""
    if not fence.worlds:
        return ""
    facts = {
        "worlds": [
            {
                "name": world.kind.name,
                "numbers": dict(world.numbers),
                "says": told(world.kind.says),
            }
            for world in fence.worlds
        ]
    }
    return (
        f'\n<carts-worlds class="carts carts-worlds" data-for="{escape(fence.id)}" hidden>'
        f'<script type="application/json">{script_json(facts)}</script></carts-worlds>'
    )
