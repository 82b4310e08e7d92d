"""What friction, a tilt or drag changes beside a contact, and whether readings show it.

Readings judge: the third of each side that is next to the contact is left out and predicted from
the others, without the effect and with it. How far the two predictions are apart is what the effect
changes; how much the readings scatter is what they can show. Of what is above that line the
readings then say which prediction they are nearer to.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from sim.measured.events.brakes import Side, Step, design, slopes_of, solved

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

NEAREST = 0.3
"""Share of each side that is left out and predicted."""

BETTER = 0.95
"""A step is taken if what it predicts is nearer by this factor than what simpler ones do."""

Verdict = Literal["shown", "not-shown", "against"]


@dataclass(frozen=True, slots=True)
class Rung:
    """One effect; root mean squares in m."""

    step: Step
    changes: float  # between its prediction and the one without it
    missed: float  # between its prediction and the readings
    without: float  # the same without it
    verdict: Verdict


def rungs_of(
    predicted: Mapping[Step, Floats], near: Sequence[Side], scatter: float, chance: float
) -> tuple[Rung, ...]:
    """Largest change first. `scatter` m: the line below which readings cannot show a change."""
    bare = predicted["nothing"]
    without = missed(near, bare)
    found = []
    for step, places in predicted.items():
        if step in ("nothing", "both"):  # each effect alone
            continue
        changes, error = _size(places - bare), missed(near, places)
        better = error < min(BETTER, 1.0 - chance) * without
        verdict: Verdict = "shown" if better else "against"
        found.append(
            Rung(step, changes, error, without, verdict if changes > scatter else "not-shown")
        )
    return tuple(sorted(found, key=lambda rung: -rung.changes))


def held_back(sides: Sequence[Side]) -> tuple[list[Side], list[Side]]:
    """What predicts, and the third next to the contact that is predicted."""
    import numpy as np

    far, near = [], []
    for tau, x in sides:
        order = np.argsort(np.abs(tau))
        count = max(1, round(NEAREST * len(tau)))
        count = min(count, len(tau) - 3)
        far.append((tau[np.sort(order[count:])], x[np.sort(order[count:])]))
        near.append((tau[order[:count]], x[order[:count]]))
    return far, near


def predictions(far: Sequence[Side], near: Sequence[Side], step: Step) -> Floats:
    """m. Places of the readings that were left out, side by side."""
    numbers = solved(far, step)[0]
    return design(near, step, slopes_of(far)) @ numbers


def missed(near: Sequence[Side], places: Floats) -> float:
    """m. Root mean square of what the readings that were left out are missed by."""
    import numpy as np

    return _size(places - np.concatenate([x for _, x in near]))


def scatter_of(sides: Sequence[Side], step: Step) -> float:
    """m. Root mean square of all readings beside the formula that is fitted to them."""
    import numpy as np

    left = (
        np.concatenate([x for _, x in sides])
        - design(sides, step, slopes_of(sides)) @ solved(sides, step)[0]
    )
    return _size(left)


def chance_of(sides: Sequence[Side]) -> float:
    """Relative standard deviation of a root mean square of the readings that are predicted."""
    return float((2.0 * NEAREST * sum(len(tau) for tau, _ in sides)) ** -0.5)


def _size(values: Any) -> float:
    import numpy as np

    return float(np.sqrt(np.mean(values**2)))
