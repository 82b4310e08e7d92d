"""A limit of processor time, for searches that may meet what never ends."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


class TooSlowError(BaseException):
    """The budget is used up. No Exception: whoever catches those must not catch this."""


@contextmanager
def budget(seconds: float) -> Iterator[None]:
    """Raise TooSlowError once the process has worked for so long inside."""

    def stop(_number: int, _frame: Any) -> None:
        raise TooSlowError

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, before)
