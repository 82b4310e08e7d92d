"""What happens at one instant."""

from __future__ import annotations

from dataclasses import dataclass

ORDER = ("contact", "release", "peak", "separate", "stick", "stop", "start", "end")
"""Events of one instant are listed in this order of kinds, then from left to right."""


@dataclass(frozen=True, slots=True)
class Event:
    """One event. Velocities are keyed by cart; walls have none.

    `before` are the velocities when this contact began, `after` those at the event, and `impulse`
    [N s], at least 0, is what took one to the other: −impulse on the left body, +impulse on the
    right one. It is nought at a contact of finite duration, partial at the greatest force, whole
    at separation. Of impacts side by side at one instant (`first_struck`) `before` and `after` are
    those around all of them. `force` [N] is that on the right body at the event; None where the
    contact has no duration, so that no force can be named.
    """

    t: float
    kind: str
    bodies: tuple[str, ...]
    before: dict[str, float]
    after: dict[str, float]
    impulse: float
    force: float | None
