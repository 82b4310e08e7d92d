"""Rows into a folder of Parquet files, a batch at a time: memory does not grow with the answers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.country.refusal import CountryError
from sim.country.rows import Row
from sim.country.schema import NAMES, arrow_schema

BATCH = 10_000
"""Rows that are held before they are written: some 15 MB with what Arrow makes of them."""

PART = 1_000_000
"""Rows of one Parquet file, so that several can be read side by side."""


class TableWriter:
    """Writes `answers-0001.parquet` and so on. A part that was not finished has no such name."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.rows = 0
        self._held: list[Row] = []
        self._schema = arrow_schema()
        self._part: Any = None
        self._in_part = 0
        self._parts: list[Path] = []

    def __enter__(self) -> TableWriter:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, _: BaseException | None, __: TracebackType | None
    ) -> None:
        if kind is None:
            self._write()
            if not self._parts:
                self._open()  # no answers at all: a table without rows
        self._close()
        _give_back()
        for path in self._parts:
            if kind is None:
                path.rename(path.with_suffix(""))
            else:
                with suppress(OSError):
                    path.unlink()

    def add(self, rows: Iterable[Row]) -> None:
        """Takes the rows of a file."""
        self._held += rows
        if len(self._held) >= BATCH:
            self._write()

    def _write(self) -> None:
        import pyarrow as pa

        if not self._held:
            return
        if self._part is None or self._in_part >= PART:
            self._close()
            self._open()
        columns = zip(*self._held, strict=True)
        arrays = [
            pa.array(column, type=self._schema.field(name).type)
            for name, column in zip(NAMES, columns, strict=True)
        ]
        self._part.write_table(pa.Table.from_arrays(arrays, schema=self._schema))
        self.rows += len(self._held)
        self._in_part += len(self._held)
        self._held = []

    def _open(self) -> None:
        import pyarrow.parquet as pq

        path = self.folder / f"answers-{len(self._parts) + 1:04}.parquet.part"
        self._part = pq.ParquetWriter(path, self._schema, compression="zstd")
        self._parts.append(path)
        self._in_part = 0

    def _close(self) -> None:
        if self._part is not None:
            self._part.close()
            self._part = None


def _give_back() -> None:
    """Arrow keeps what it no longer needs for itself; the report that follows needs it more."""
    import pyarrow as pa

    pa.default_memory_pool().release_unused()


def new_folder(folder: Path) -> None:
    """Makes the folder; raises `CountryError` where something is in it already."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if any(folder.iterdir()):
            raise CountryError(f"the folder {folder} is not empty: name a new one")
    except OSError as error:
        raise CountryError(f"{folder}: {error.strerror}") from None


def write_keys(folder: Path, keys: Sequence[KeyedForm]) -> None:
    """The keys beside the answers: what was asked, for the report."""
    for k, key in enumerate(keys, 1):
        path = folder / f"key-{k:02}.json"
        path.write_text(key.as_file(), encoding="utf-8", newline="\n")
