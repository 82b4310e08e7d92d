"""What does this scene call for? The ladder of a widget, asked for when a reader opens it.

    {"id": 9, "kind": "relevance", "scene": {...}, "set": {...}}

is answered by `rungs`, the rows of `carts plan --relevance` with sentences as templates, and
`reads`, the reading accuracy of a graph as a part of its height.
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping
from typing import Any

from sim.bridge.protocol import plain_of
from sim.dynamics.relevance.difference import READS
from sim.dynamics.relevance.ranking import ranked_effects, rows
from sim.dynamics.report.document import finite
from sim.scene import read_scene


def relevance_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """Header without numbers; raises SceneError or UnsolvedError for what cannot be run."""
    found = ranked_effects(read_scene(plain_of(request)))
    return {"rungs": finite(rows(found, wired=True)), "reads": READS}, array("d")
