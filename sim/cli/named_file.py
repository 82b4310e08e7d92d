"""A file that somebody named on the command line: its bytes, or its path where a command reads it.

Whatever is wrong with the name is said in one sentence, the same one by every command.
"""

from __future__ import annotations

import sys
from pathlib import Path
from stat import S_ISDIR
from typing import Any

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
        raise _unreadable(name, error) from None


class GivenFile(click.Path):
    """A path that is there; `what` it should be. `folders`: it may be a folder too."""

    def __init__(self, what: str, *, folders: bool = False) -> None:
        super().__init__(exists=True, path_type=Path)
        self.what, self.folders = what, folders

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Path:
        """The path, or click's usage error."""
        path = Path(value)
        try:
            folder = S_ISDIR(path.stat().st_mode)
        except FileNotFoundError:
            there = "file or folder" if self.folders else "file"
            raise click.UsageError(f"There is no {there} “{value}”.", ctx) from None
        except (OSError, ValueError) as error:
            raise _unreadable(value, error) from None
        if folder and not self.folders:
            raise click.UsageError(f"“{value}” is a folder, not {self.what}.", ctx)
        super().convert(value, param, ctx)
        return path


def _unreadable(name: str, error: OSError | ValueError) -> click.UsageError:
    why = getattr(error, "strerror", None) or error
    return click.UsageError(f"“{name}” cannot be read: {why}.")
