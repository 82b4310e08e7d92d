"""friction: its size is constant while a cart slides, and bounded while it rests."""

from __future__ import annotations

from sim.effects.constant import Constant
from sim.scene.effects import Effect


def constant(effect: Effect) -> Constant:
    """Kinetic and static coefficient; static is never less: that is refused."""
    kinetic = effect.numbers["coefficient"]
    return Constant(friction=(kinetic, effect.numbers.get("static", kinetic)))
