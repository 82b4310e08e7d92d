"""A zip that every computer unpacks, the same for the same files."""

from __future__ import annotations

import zipfile
from contextlib import suppress
from pathlib import Path

import click

from sim.cli.write_out import unwritten

DATE = (1980, 1, 1, 0, 0, 0)  # equal sites give equal zips
LONGEST = 120
"""Characters of a path in the zip. Windows takes 260 with the folders around it."""


def write_zip(files: dict[str, bytes], out: Path) -> None:
    """Write the files; a path too long for Windows, or a place that is not ours, is a sentence."""
    long = [name for name in files if len(name) > LONGEST]
    if long:
        raise click.ClickException(
            f"{len(long[0])} characters are too long for Windows ({LONGEST} at most): {long[0]}\n"
            "Give that file a shorter name."
        )
    whole = out.with_name(f"{out.name}.part")  # a full disk must leave no zip that is cut off
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, content in files.items():
                entry = zipfile.ZipInfo(name, DATE)
                entry.external_attr = 0o644 << 16
                archive.writestr(entry, content, zipfile.ZIP_DEFLATED)
        whole.replace(out)
    except OSError as error:
        with suppress(OSError):
            whole.unlink(missing_ok=True)
        raise unwritten(out, error, "carts pack --out FILE.zip") from None


def size_of(path: Path) -> str:
    """The size as it is printed."""
    return f"{path.stat().st_size / 1e6:.1f} MB"
