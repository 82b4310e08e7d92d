"""Carts of a lesson that begin where no picture shows them: a slip of the pen, as a mistake."""

from __future__ import annotations

from sim.scene import Problem, Scene


def off_track(scene: Scene) -> list[Problem]:
    """One for each cart whose centre begins beyond an end of the track; none without a length.

    Elsewhere than in a lesson such a scene is a scene: it is computed as any other.
    """
    length = scene.track.length
    return [
        Problem(
            ("carts", cart.name, "position"),
            "off-track",
            f"cart {cart.name} begins at {cart.position:g} m, off the track",
            f"the track is 0 to {length:g} m: change the position, or track.length",
        )
        for cart in scene.carts
        if length is not None and not 0 <= cart.position <= length
    ]
