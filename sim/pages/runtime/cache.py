"""A folder that remembers downloads by their sha256 and build steps by what went into them.

Everything in it can be deleted at any time. Whatever is damaged is made again, and a build that is
cut off leaves nothing half-finished behind: results appear under their name in one move.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

STAMP = "stamp.json"
OURS = Path(__file__).parents[3] / ".cache"
"""Of the copy of this project that runs; an installed wheel has none, and needs none."""


def sha256(data: bytes) -> str:
    """Return the sha256 of `data` in hexadecimal."""
    return hashlib.sha256(data).hexdigest()


def key_of(*parts: str) -> str:
    """Return one name for everything a step depends on."""
    return sha256(json.dumps(parts).encode())[:24]


@dataclass(frozen=True)
class Cache:
    """The cache below `root`, which is made when it is first used."""

    root: Path

    def find(self, digest: str) -> Path | None:
        """Return the file with this sha256, or None if it is not here or no longer what it was."""
        path = self.root / "sources" / digest
        if path.is_file() and sha256(path.read_bytes()) == digest:
            return path
        return None

    def keep(self, data: bytes) -> Path:
        """Store `data` under its sha256 and return the file."""
        path = self.root / "sources" / sha256(data)
        with self.workspace() as folder:
            (folder / "file").write_bytes(data)
            path.parent.mkdir(parents=True, exist_ok=True)
            (folder / "file").replace(path)
        return path

    def step(self, name: str, key: str, make: Callable[[Path], None]) -> Path:
        """Return the folder of the step's results, calling `make(folder)` only if it is not here.

        `key` must change whenever the results could.
        """
        target = self.root / f"{name}-{key}"
        if _intact(target):
            return target
        with self.workspace() as folder:
            work = folder / name
            work.mkdir()
            make(work)
            stamp = {p.name: sha256(p.read_bytes()) for p in sorted(work.iterdir()) if p.is_file()}
            (work / STAMP).write_text(json.dumps(stamp, indent=1), encoding="utf-8")
            if target.exists() and not _intact(target):
                shutil.rmtree(target)
            try:
                work.rename(target)
            except OSError:
                if not _intact(target):  # or another build was quicker, with the same result
                    raise
        self._forget_old(name, target)
        return target

    @contextmanager
    def workspace(self) -> Iterator[Path]:
        """Yield a new folder on the same disk as the cache; it is gone afterwards."""
        self.root.mkdir(parents=True, exist_ok=True)
        folder = Path(tempfile.mkdtemp(prefix="work-", dir=self.root))
        try:
            yield folder
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def _forget_old(self, name: str, newest: Path, kept: int = 4) -> None:
        """Keep the last few results of a step: an edit should not fill the disk."""
        found = [p for p in self.root.glob(f"{name}-*") if p != newest and p.is_dir()]
        found.sort(key=lambda p: p.stat().st_mtime, reverse=True)
        for path in found[kept - 1 :]:
            shutil.rmtree(path, ignore_errors=True)


def _intact(folder: Path) -> bool:
    try:
        stamp = json.loads((folder / STAMP).read_text(encoding="utf-8"))
        intact = all(sha256((folder / name).read_bytes()) == had for name, had in stamp.items())
    except (OSError, ValueError, AttributeError):
        return False
    if intact:
        os.utime(folder)
    return intact


def default_cache(start: Path) -> Path:
    """Return the cache folder: CARTS_CACHE if that is set, else `.cache` below `start`, else that
    of the copy of this project that we run from, so that a second site downloads nothing."""
    own = start / ".cache"
    if not own.is_dir() and OURS.is_dir() and os.access(OURS, os.W_OK):
        own = OURS
    return Path(os.environ.get("CARTS_CACHE") or own).expanduser().resolve()
