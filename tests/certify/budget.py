"""A limit of processor time for one scene: a run of ten thousand may not stand still at one."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

# CPU-seconds. A scene takes a tenth of a second; a hundred times that is one whose equations blow
# up in the oracle's forty digits, not a slow machine.
MOST_SECONDS = 20.0


class OutOfTimeError(Exception):
    """The scene has used its processor time."""


@contextmanager
def limited(seconds: float = MOST_SECONDS) -> Iterator[None]:
    """Raises OutOfTimeError inside the block after so much processor time of this process."""

    def over(_signal: int, _frame: FrameType | None) -> None:
        raise OutOfTimeError

    before = signal.signal(signal.SIGPROF, over)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
