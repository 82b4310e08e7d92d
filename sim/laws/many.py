"""What many isolated contacts come to at once, as arrays: the laws' part of maps of outcomes.

A law says it in its module `many`; one without such a module is run contact by contact.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING

from sim.scene.laws import folder_of, laws

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Values = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class PerSpeed:
    """One contact at approach speed 1 m/s, as in `contact_law.IsolatedContact`."""

    e: Values
    duration: Values
    force: Values
    overlap: Values
    residual_overlap: Values


ManyFigures = Callable[["Values", "Values", "Values"], PerSpeed]
"""From k, e and mu, arrays that broadcast."""


@cache
def outcome_known(law: str) -> bool:
    """Is the outcome of an isolated contact a formula for arrays?"""
    return laws()[law].stiffness is None or find_spec(_module(law)) is not None


def figures_of_many(law: str) -> ManyFigures:
    """The formula. Raises ImportError for a law without one."""
    found: ManyFigures = import_module(_module(law)).figures
    return found


def _module(law: str) -> str:
    return f"sim.laws.{folder_of(law)}.many"
