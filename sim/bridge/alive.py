"""A sign of life while an answer takes long.

A page waits some seconds for a sign of Python, then it takes it for lost and starts another. An
answer that has several parts tells after each that it is at work: on a slow laptop one part may
take as long as all of them elsewhere. Outside a page nobody listens.
"""

from __future__ import annotations

from collections.abc import Callable

_listener: Callable[[], object] | None = None


def listen(call: Callable[[], object]) -> None:
    """Set the one listener; it replaces any earlier one."""
    global _listener  # noqa: PLW0603
    _listener = call


def alive() -> None:
    """Tell that the answer is at work."""
    if _listener:
        _listener()
