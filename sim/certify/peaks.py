"""When a contact pushes most, over all the motions that it takes part in.

A bumper does so where it turns: its force grows with the overlap, and on its way back it stays
below. Any other law pushes most where its force stops growing, or where a motion begins with a
falling force; so does a bumper that is met again on its way back.
"""

from __future__ import annotations

from sim.certify.coupled import CoupledPhase
from sim.certify.instants import Instant
from sim.certify.numbers.balls import ZERO, Ball, NotProvableError, is_zero
from sim.certify.numbers.roots import first_root
from sim.certify.phases import ContactPhase
from sim.certify.touches import BUMPER, Touch
from sim.scene.said import said


def note_peak(touch: Touch, phase: ContactPhase | CoupledPhase, now: Instant, cause: str) -> None:
    """The greatest force of a motion that ended at `now`; `cause`: what ended it in this gap."""
    if isinstance(phase, ContactPhase):
        _of_a_pair(touch, phase, now, cause)
    elif cause == "turn":
        touch.peaks.append((now, phase.force(touch.gap, now.minus(phase.begun))))
    elif touch.law != BUMPER or touch.elastic or (touch.stage == "back" and not touch.turned):
        for tau, force in phase.crests(touch.gap, now.minus(phase.begun)):
            touch.peaks.append((phase.begun.after(tau), force))


def _of_a_pair(touch: Touch, phase: ContactPhase, now: Instant, cause: str) -> None:
    swing, tau = phase.swing, now.minus(phase.begun)
    if cause == "turn":
        touch.peaks.append((now, swing.force(tau)[0]))
        return
    if touch.stage == "back" and (touch.turned or is_zero(swing.r0)):
        if not touch.turned:
            touch.peaks.append((phase.begun, swing.force(ZERO)[0]))
        return
    first, rate = swing.force(ZERO)
    if rate <= 0:
        touch.peaks.append((phase.begun, first))
        return
    alone = cause == "apart" and touch.fresh and phase.unloaded
    if alone and touch.elastic and touch.law == BUMPER:
        when: Ball | None = tau / 2
    else:
        when = first_root(
            lambda t: swing.force(t)[1],
            lambda t: swing.line.kappa * swing.all(t)[2] + swing.line.gamma * swing.all(t)[3],
            tau,
            said("when the force between {pair} is greatest", pair=touch.gap.shown),
        )
    at = (now, tau) if when is None else (phase.begun.after(when), when)
    touch.peaks.append((at[0], swing.force(at[1])[0]))


def greatest(touch: Touch) -> Instant | None:
    """When the force was greatest; None where it never pushed."""
    best: tuple[Instant, Ball] | None = None
    for when, force in touch.peaks:
        if best is None or force > best[1]:
            best = (when, force)
        elif not force < best[1] and when is not best[0]:
            raise NotProvableError(
                said("when the force between {pair} is greatest", pair=touch.gap.shown)
            )
    return best[0] if best is not None and best[1] > 0 else None
