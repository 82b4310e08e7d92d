"""The bytes of a file that somebody named on the command line."""

from __future__ import annotations

import sys
from pathlib import Path

import click


def bytes_of(name: str, most: int, what: str) -> bytes:
    """At most so many bytes of a file, or of standard input (-); `what` it should be.

    Raises click's usage error: a wrong path is a wrong call.
    """
    if name == "-":
        return sys.stdin.buffer.read(most)
    try:
        with Path(name).open("rb") as file:
            return file.read(most)
    except FileNotFoundError:
        raise click.UsageError(f"There is no file “{name}”.") from None
    except IsADirectoryError:
        raise click.UsageError(f"“{name}” is a folder, not {what}.") from None
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or error
        raise click.UsageError(f"“{name}” cannot be read: {why}.") from None
