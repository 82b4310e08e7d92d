"""Of several impacts without a duration that are due at one instant: which are struck first?

Newton's laws do not say. Here those that close fastest are struck, equally fast ones at once, and
then it is asked again. That order is the same in a mirror, and whatever the carts are called.
"""

from __future__ import annotations

from sim.dynamics.state.body import Gap
from sim.dynamics.state.chain import Chain, moved, velocity
from sim.dynamics.state.clock import Time, elapsed
from sim.laws.rounding import AS_FAST, LAST_BIT

AT_ONCE = LAST_BIT
"""Of the time. Touches that are foreseen no further apart are due at once."""


def is_alone(chain: Chain, gap: Gap, now: Time) -> bool:
    """Does nobody else touch the two of a gap at this instant, by a law without a duration?

    The gaps beside it are up to date.
    """
    for near in chain.neighbours(gap):
        if near is None or (near.room > 0.0 and near.due[0] > now[0] + AT_ONCE * now[0]):
            continue  # as nearly always
        if touches(near, now):
            return False
    return True


def first_struck(chain: Chain, gap: Gap, now: Time) -> list[list[Gap]]:
    """Gaps that are struck first where this one is due: neighbours together, from left to right."""
    row = [gap]
    while (before := chain.neighbours(row[0])[0]) is not None and touches(before, now):
        row.insert(0, before)
    while (after := chain.neighbours(row[-1])[1]) is not None and touches(after, now):
        row.append(after)
    due = [one for one in row if one is gap or _is_due(one, now) or closes_on_springs(one, now)]
    return fastest_of(due, now) or [[gap]]


def fastest_of(row: list[Gap], now: Time) -> list[list[Gap]]:
    """Those of a row of gaps that close fastest; none where none closes."""
    speeds = [velocity(gap.left, now) - velocity(gap.right, now) for gap in row]
    fastest = max(speeds)
    blocks: list[list[Gap]] = []
    for gap, speed in zip(row, speeds, strict=True):
        if speed <= 0.0 or speed < fastest * (1.0 - AS_FAST):
            continue
        if blocks and blocks[-1][-1].right is gap.left:
            blocks[-1].append(gap)
        else:
            blocks.append([gap])
    return blocks


def touches(gap: Gap, now: Time) -> bool:
    """Does a gap touch at this instant by a law without a duration?"""
    if gap.law is not None or gap.joined:
        return False
    if gap.solver is not None:  # at rest, pressed together; or springs hold the two
        return gap.touching is not None or closes_on_springs(gap, now)
    if gap.room > 0.0:
        return _is_due(gap, now)
    return gap.room + moved(gap.right, gap.time, now) - moved(gap.left, gap.time, now) <= 0.0


def closes_on_springs(gap: Gap, now: Time) -> bool:
    """Do two that springs hold touch at this instant, by a law without a duration?"""
    motion = gap.solver
    return (
        gap.law is None
        and motion is not None
        and abs(motion.time_left(now)) <= AT_ONCE * now[0]
        and any(end.cause == "touch" and motion.members[end.k] is gap for end in motion.ends)
    )


def _is_due(gap: Gap, now: Time) -> bool:
    return gap.solver is None and abs(elapsed(gap.due, now)) <= AT_ONCE * now[0]
