"""Machines with a fraction of a processor or little memory, by control groups (of either version).

As root only, where control groups can be made; elsewhere the row says that it was not tried.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from .machine import NotHereError
from .table import Browser, Fault, Machine, Must

GROUPS = Path("/sys/fs/cgroup")
PERIOD = 100_000  # µs in which a share of a processor is given out
LEAVING = 10.0  # s in which a closed browser's processes have left
MB = 1 << 20
ENTER = '#!/bin/sh\necho $$ > "{group}/cgroup.procs"\nexec "$@"\n'

Limits = dict[str, str]
"""Files of a group and what is written into them, in order."""


def _processor(share: float) -> tuple[str, Limits, Limits]:
    quota = str(int(share * PERIOD))
    old = {"cpu.cfs_period_us": str(PERIOD), "cpu.cfs_quota_us": quota}
    return "cpu", old, {"cpu.max": f"{quota} {PERIOD}"}


def _memory(size: int) -> tuple[str, Limits, Limits]:
    return "memory", {"memory.limit_in_bytes": str(size)}, {"memory.max": str(size)}


def _group(name: str, controller: str, old: Limits, new: Limits) -> Path:
    """A new group with its limits. Raises NotHereError."""
    is_old = (GROUPS / controller).is_dir()
    group = (GROUPS / controller if is_old else GROUPS) / name
    try:
        group.mkdir()
        for file, value in (old if is_old else new).items():
            (group / file).write_text(value)
    except OSError as refused:
        with suppress(OSError):
            group.rmdir()
        raise NotHereError("control groups") from refused
    return group


def limited(controller: str, old: Limits, new: Limits) -> Machine:
    """All processes of the browser share the limit."""

    @contextmanager
    def done(_: Path, folder: Path) -> Iterator[Browser]:
        group = _group(f"carts-{folder.parent.name}", controller, old, new)
        enter = folder.parent / "enter"
        enter.write_text(ENTER.format(group=group))
        enter.chmod(0o755)
        try:
            yield Browser(folder, str(enter))
        finally:
            _left(group)

    return done


def _left(group: Path) -> None:
    end = time.monotonic() + LEAVING
    while time.monotonic() < end:
        with suppress(OSError):
            group.rmdir()
            return
        time.sleep(0.1)


SLOW = (4, 10, 20)
"""Times slower: an old laptop, one that also looks for viruses, and one that does nothing else."""
SMALL: dict[int, Must] = {800: "lives", 500: "lives"}
"""MB of the whole browser, and what must be seen."""


def of_limits() -> Iterator[Fault]:
    for times in SLOW:
        machine = limited(*_processor(1 / times))
        yield Fault(f"{times} times slower", "either", machine=machine, slow=times)
    for size, must in SMALL.items():
        machine = limited(*_memory(size * MB))
        yield Fault(f"{size} MB for the whole browser", must, machine=machine)
