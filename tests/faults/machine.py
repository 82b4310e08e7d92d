"""Machines whose disk is full, and folders that are not the reader's own.

As root only: mounts and `setpriv`.
Where one is missing the row says that it was not tried, and is not counted.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from .table import WORD, Browser, Fault, Machine, Must

NOBODY = "setpriv --reuid=65534 --regid=65534 --clear-groups"


class NotHereError(Exception):
    """What this machine lacks for the row."""


@contextmanager
def nothing(_: Path, folder: Path) -> Iterator[Browser]:
    """A browser of its own, and no fault."""
    yield Browser(folder)


@contextmanager
def _mounted(what: list[str], at: Path) -> Iterator[None]:
    if (
        os.geteuid()
        or subprocess.run(["mount", *what, str(at)], capture_output=True, check=False).returncode
    ):
        raise NotHereError("mount")
    try:
        yield
    finally:
        subprocess.run(["umount", "--lazy", str(at)], check=True)


@contextmanager
def full_disk(_: Path, folder: Path) -> Iterator[Browser]:
    """The disk of the profile is filled to its last byte when the visit begins: `Browser.full`."""
    with _mounted(["-t", "tmpfs", "-o", "size=64m", "none"], folder):
        yield Browser(folder, full=True)


@contextmanager
def read_only_site(site: Path, folder: Path) -> Iterator[Browser]:
    """The site, as on a share that nobody may write."""
    with _mounted(["--bind", "-o", "ro", str(site)], site):
        subprocess.run(["mount", "-o", "remount,bind,ro", str(site)], check=True)
        yield Browser(folder)


@contextmanager
def of_nobody(_: Path, folder: Path) -> Iterator[Browser]:
    """The reader is `nobody`; the site is root's and may be read."""
    if os.geteuid() or not shutil.which("setpriv"):
        raise NotHereError("setpriv")
    shutil.chown(folder, "nobody")
    yield Browser(folder, NOBODY)


def closed_to_nobody(pattern: str) -> Machine:
    """The reader is `nobody`, and these files of the site may be read by root alone."""

    @contextmanager
    def done(site: Path, folder: Path) -> Iterator[Browser]:
        for file in site.glob(pattern):
            shutil.copy2(file, file.with_suffix(".own"))  # the copies of the site share their files
            file.with_suffix(".own").replace(file)
            file.chmod(0o600)
        with of_nobody(site, folder) as browser:
            yield browser

    return done


MACHINES: dict[str, tuple[Must, Machine]] = {
    "a browser of its own, nothing wrong": ("lives", nothing),
    "a full disk": ("either", full_disk),
    "a site on a read-only share": ("lives", read_only_site),
    "a reader who owns no file": ("lives", of_nobody),
    "carts.js may not be read": ("says", closed_to_nobody("assets/carts/carts.js")),
    "answers.js may not be read": ("closed", closed_to_nobody("assets/carts/answers.js")),
    "the runtime may not be read": ("says", closed_to_nobody("assets/carts/runtime/*")),
    "the snapshot may not be read": (
        "lives",
        closed_to_nobody("assets/carts/runtime/memory*"),
    ),
}


def of_machines() -> Iterator[Fault]:
    for name, (must, machine) in MACHINES.items():
        yield Fault(name, must, machine=machine)
    # What is short still finds place in a file that the browser has begun.
    name = "a full disk, a long answer in the place of a short one"
    yield Fault(name, "says", machine=full_disk, earlier=True, again=True, word=WORD * 100_000)
