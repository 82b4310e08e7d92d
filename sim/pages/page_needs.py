"""What a page needs beside the theme, and which Python packages its elements load."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from sim.pages.language import ENGLISH

STATISTICS = {"numpy", "scipy"}


@dataclass(frozen=True, slots=True)
class Needs:
    """What a page needs beside the theme."""

    scenes: bool = False
    formulas: bool = False
    outline: Mapping[str, Any] | None = None  # of what can be answered here; None: nothing
    classroom: bool = False
    measured: bool = False  # readings of real carts
    language: str = ENGLISH  # of the interface words
    stated: bool = False  # whether the page itself says its language
    challenge: bool = False  # a goal for the runs of a scene
    worlds: bool = False  # impossible ones, beside a scene
    hosted: bool = False  # on a web server: how to take it home
    law: bool = False  # a law that a reader writes
    tools: bool = False  # that a reader works in a scene


def needs_of(html: str, known: Needs) -> Needs:
    """What a rendered page needs: what is `known`, and what stands in it."""
    return replace(
        known,
        formulas='class="arithmatex"' in html,
        classroom="<carts-class" in html,
        measured="<carts-measured" in html,
        challenge="<carts-challenge" in html,
        worlds="<carts-worlds" in html,
        law="<carts-law" in html,
        tools='class="carts-tools"' in html,
    )


def own_packages(needs: Needs) -> frozenset[str]:
    """What the elements of a page load, beside what its scenes call for."""
    if not needs.classroom and not needs.measured:
        return frozenset()
    from sim.pages import runtime  # only where a page has such an element

    own = {runtime.CLASSROOM: needs.classroom, runtime.MEASURED: needs.measured}
    return frozenset({*STATISTICS, *(name for name, asked in own.items() if asked)})
