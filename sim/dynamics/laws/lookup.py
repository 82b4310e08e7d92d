"""From a description of a contact to its law."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

from sim.dynamics.laws.base import FiniteLaw
from sim.dynamics.laws.bumper import Bumper
from sim.dynamics.laws.dashpot import Paper, PushOnly, PushOnlyUncorrected
from sim.dynamics.laws.hertz import Hertz
from sim.scene.model import Contact

FINITE: dict[str, Callable[[float, float], FiniteLaw]] = {
    "bumper": Bumper,
    "paper": Paper,
    "push-only": PushOnly,
    "push-only-uncorrected": PushOnlyUncorrected,
    "hertz": Hertz,
}


@lru_cache(maxsize=1024)
def finite_law(contact: Contact) -> FiniteLaw | None:
    """The law of finite duration, or None for `instant` and `velcro`; one object per contact."""
    make = FINITE.get(contact.law)
    if make is None or contact.stiffness is None or contact.restitution is None:
        return None
    return make(contact.stiffness, contact.restitution)
