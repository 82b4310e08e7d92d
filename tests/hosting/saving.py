"""A file that is changed and saved; again and again, for a server that looks from time to time."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

EVERY = 2.0
"""s. A server that saw the first edit has shown it by then."""


def edit(path: Path, old: str, new: str) -> None:
    """The first of these words is another one, saved."""
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


@contextmanager
def saved_again(path: Path) -> Iterator[None]:
    """Nobody outside knows when a watcher has taken its first look: one that took it only after
    the edit is told of it by the next time that the file is saved."""
    over = threading.Event()

    def save() -> None:
        while not over.wait(EVERY):
            os.utime(path)

    saving = threading.Thread(target=save, daemon=True)
    saving.start()
    try:
        yield
    finally:
        over.set()
        saving.join()
