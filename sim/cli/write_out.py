"""A file or a site that a command was asked to write, and the sentence where a disk says no."""

from __future__ import annotations

import errno
from pathlib import Path

import click

NOT_OURS = {
    *(errno.EACCES, errno.EPERM, errno.EROFS, errno.ENOSPC, errno.EDQUOT),
    *(errno.ENOTDIR, errno.EISDIR, errno.EEXIST, errno.ENAMETOOLONG),
}
"""What a disk refuses, as opposed to a mistake of ours."""

A_SITE = "The site needs a folder that is yours, with room: for example a copy of it in Documents."


def write_out(path: Path, content: str | bytes, another: str = "") -> None:
    """Makes the folder and writes the file; `another`: how to name another place, "--svg FILE".

    Where that cannot be done, a sentence and the end. “-” is the screen for other programs; a file
    of that name would be found by nobody.
    """
    if path.name == "-":
        name_a_file = f" Name a file: {another}" if another else " Name a file."
        raise click.ClickException(f"“-” is not the name of a file here.{name_a_file}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
    except OSError as error:
        raise unwritten(path, error, another) from None


def unwritten(path: Path, error: OSError, another: str) -> click.ClickException:
    """The sentence for a file that cannot be written."""
    why = error.strerror
    if isinstance(error, FileExistsError | NotADirectoryError):
        why = "a folder of its path is a file"
    elsewhere = f" Another place: {another}" if another else ""
    return click.ClickException(f"{path} cannot be written: {why}.{elsewhere}")


def no_place(error: OSError, needs: str = A_SITE) -> str:
    """The sentence where a disk says no, with what is needed; empty for a mistake of ours."""
    if error.errno not in NOT_OURS:
        return ""
    where = f"{error.filename}: " if error.filename else ""
    return f"{where}{error.strerror}. {needs}"
