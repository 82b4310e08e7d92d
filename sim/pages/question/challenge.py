"""A `challenge` block: something to be reached with the sliders of a scene, and a counter of tries.

```challenge
id: stop-dead
scene: two-carts
ask: Make cart A stop dead.
goal: v.A = 0
```
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sim.lesson import keys
from sim.lesson.goal import EXAMPLE, Goal, read_goal
from sim.lesson.keys import PROSE, Key
from sim.pages.blocks.scene_block import Lesson, Places, SiteIds, load_block
from sim.pages.findings import AuthorError, Finding
from sim.pages.text.fence_scan import Block
from sim.scene import Fence, Problem
from sim.scene.fence.presentation import ID
from sim.scene.tables import unknown_keys

KEYS = (
    Key("id", "name of the challenge; default: the scene's and -challenge", "stop-dead"),
    Key("scene", "id of a scene above with sliders", "two-carts", required=True),
    Key("ask", "what is to be reached, in Markdown", "Make cart A stop dead.", PROSE, True),
    Key("goal", "what must hold", "v.A = 0", required=True),
)


@dataclass(frozen=True, slots=True)
class Challenge:
    """A challenge that makes sense."""

    id: str
    ask: str  # Markdown
    goal: Goal
    scene: Fence


def read_challenge_block(
    block: Block, lesson: Lesson, ids: SiteIds, scenes: Sequence[Fence], *, first_line: int
) -> Challenge:
    """The challenge of `block`; raises `AuthorError`. `scenes`: those above it on the page."""
    source = load_block(block, lesson.file, first_line=first_line)
    places, table = Places(lesson.file, source), source.plain
    problems: list[Problem] = []
    unknown_keys(table, keys.names(KEYS), (), problems)
    ask = keys.needed(table, "ask", (), problems, "ask: Make cart A stop dead.")
    name = keys.needed(table, "scene", (), problems, "scene: two-carts")
    identity = str(table.get("id", usual_id(name)))
    if not ID.fullmatch(identity):
        problems.append(Problem(("id",), "bad-name", f"“{identity[:40]}” cannot be an id", "id: a"))
    goal = read_goal(table.get("goal"), ("goal",), problems)
    scene = next((scene for scene in scenes if scene.id == name), None)
    if scene is None and name:
        known = ", ".join(scene.id for scene in scenes) or "none"
        message = f"there is no scene “{name[:40]}” above"
        problems.append(Problem(("scene",), "no-such-scene", message, f"scenes above: {known}"))
    if scene is not None and not (scene.controls or scene.switches):
        message = f"the scene “{scene.id}” has no sliders: nothing can be tried"
        problems.append(Problem(("scene",), "no-controls", message, "add controls to the scene"))
    for quantity in goal.quantities if goal and scene else ():
        if scene and quantity.partition(".")[2] not in _names(scene, quantity):
            hint = f"it has {', '.join(_names(scene, quantity))}; {EXAMPLE}"
            message = f"the scene “{scene.id}” has no {quantity}"
            problems.append(Problem(("goal",), "unknown-path", message, hint))
    if problems or goal is None or scene is None:
        raise AuthorError(map(places.finding, problems))
    ids.claim(identity, Finding(lesson.file, *source.place(("id",)), "id", ""))
    return Challenge(identity, ask, goal, scene)


def usual_id(scene: str) -> str:
    """Of a challenge that states none."""
    return f"{scene}-challenge"


def _names(scene: Fence, quantity: str) -> list[str]:
    """What may stand behind the point of a quantity."""
    carts = [cart.name for cart in scene.scene.carts]
    if not quantity.startswith("F"):
        return carts
    held = enumerate(scene.scene.contacts)
    return carts + ["-".join(scene.scene.names_at(k)) for k, c in held if c is not None]
