"""What is positive while the formulas of a row hold, as sums of modes (see `guards`)."""

from __future__ import annotations

from collections.abc import Iterator

from sim.dynamics.motion.guards import guards_of, passed
from sim.dynamics.motion.modes.forces import others
from sim.dynamics.motion.modes.modal_sum import ModalSum, plus
from sim.dynamics.motion.modes.state import ModalState
from sim.dynamics.motion.power_series.series import SettledRow
from sim.dynamics.state.body import Body, Gap
from sim.laws.branch import Guard


def guarded(
    bodies: list[Body],
    gaps: list[Gap],
    row: SettledRow,
    state: ModalState,
    contact: list[ModalSum],
    across: list[ModalSum],
) -> Iterator[ModalSum]:
    """All that is positive while the formulas hold."""
    for k, (gap, branch) in enumerate(zip(gaps, row.branches, strict=True)):
        for guard in guards_of(gap, branch):
            yield _along(gap, guard, state.over[k], contact[k])
    for i, body in enumerate(bodies):
        if body.carts and body.held:
            total = others(i, body.load, contact, across)
            static = ModalSum(body.load.static, ())
            yield plus((1.0, static), (-1.0, total))
            yield plus((1.0, static), (1.0, total))
        elif body.sliding and body.load.static:
            yield plus((float(body.sliding), state.speed[i]))


def _along(gap: Gap, guard: Guard, over: ModalSum, force: ModalSum) -> ModalSum:
    """The quantity of a guard: it falls to zero where the guard's event happens."""
    if guard.of == "push":
        assert gap.law is not None
        k, c = gap.law.stiffness, gap.law.damper(gap.mu)
        return plus((-k, over), (-c, over.slope))
    quantity = {"force": force, "overlap": over, "rate": over.slope}[guard.of]
    if guard.rises:
        return plus((1.0, ModalSum(passed(guard), ())), (-1.0, quantity))
    return plus((1.0, quantity), (-1.0, ModalSum(guard.level, ()))) if guard.level else quantity
