"""Views of forces that a scene opens with no force in it: the page would hold nothing of them."""

from __future__ import annotations

from sim.scene import Fence, Problem
from sim.scene.fence.predict import for_a_time
from sim.scene.reading.effects import all_effects

OF_FORCES = ("free-body", "lens")
"""Of the views: those that show the forces between two."""


def no_forces(fence: Fence) -> list[Problem]:
    """One where `with` lists such a view and no two of the scene have a force that lasts, or none
    is shown. What is hidden until a reader has found it is shown then, and what is switched off can
    be switched on."""
    asked = [view for view in fence.opened if view in OF_FORCES]
    if not asked:
        return []
    no_view, leave = (
        f"so there is no {' or '.join(asked)}",
        f"leave {' and '.join(asked)} out of with",
    )
    if fence.forces == "none":
        message = f"the forces are not shown, {no_view}"
        hint = f"{leave}, or write forces: shown"
    elif _any_force(fence):
        return []
    elif any(fence.scene.contacts):
        message = f"every contact of this scene is over at once, {no_view}"
        hint = f"{leave}, or let a contact last: law: bumper"
    else:
        message = f"nothing in this scene can touch another, {no_view}"
        hint = f"{leave}, or add a cart or a wall to meet"
    return [Problem(("with",), "no-force-to-show", message, hint)]


def _any_force(fence: Fence) -> bool:
    """Whether two push or pull each other for some time, or could."""
    return bool(for_a_time(fence.scene, all_effects(fence.plain, fence.scene)))
