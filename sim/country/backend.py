"""Where a table lies and who works on it: Parquet on DuckDB, or whatever else Ibis knows.

DuckDB has a bound of its memory and writes to a temporary folder beyond it.
"""

from __future__ import annotations

import atexit
import os
import shutil
import sys
import tempfile
from collections.abc import Sequence
from glob import escape
from pathlib import Path
from typing import Any

from sim.country.refusal import CountryError
from sim.country.schema import LATER, NAMES
from sim.scene.said import said

DUCKDB = "duckdb://"
SPARK = "spark://"
MEMORY = "128MB"
"""Of DuckDB for its own work; what is more goes to the disk. Python and Arrow come on top."""


def is_parquet(text: str) -> bool:
    """Whether a place names a table of answers: a folder, or a Parquet file."""
    return Path(text).is_dir() or text.lower().endswith(".parquet")


def connect(address: str) -> Any:
    """The backend at an address; raises `CountryError`.

    `duckdb://` (in memory, spilling), `duckdb://FILE`, `spark://local`, `spark://HOST:PORT`, or any
    address that `ibis.connect` takes.
    """
    try:
        if address.startswith(DUCKDB):
            return _duckdb(address.removeprefix(DUCKDB))
        if address.startswith(SPARK):
            return _spark(address)
        import ibis

        return ibis.connect(address)
    except ModuleNotFoundError:
        raise
    except Exception as error:  # each backend has errors of its own
        raise CountryError(f"{address}: {_first_line(error)}") from None


def _duckdb(file: str) -> Any:
    import ibis

    spill = tempfile.mkdtemp(prefix="carts-duckdb-")  # of this process alone
    atexit.register(shutil.rmtree, spill, ignore_errors=True)
    return ibis.duckdb.connect(
        file or ":memory:", memory_limit=MEMORY, temp_directory=spill,
        preserve_insertion_order=False,
    )  # fmt: skip


def _spark(address: str) -> Any:
    import ibis
    from pyspark.sql import SparkSession

    os.environ.setdefault("PYSPARK_PYTHON", sys.executable)  # else its workers take any Python
    local = address.removeprefix(SPARK) in ("", "local")
    builder = SparkSession.builder.master("local[2]" if local else address)
    options = {"spark.ui.enabled": "false", "spark.ui.showConsoleProgress": "false",
               "spark.sql.session.timeZone": "UTC",
               "spark.sql.shuffle.partitions": "4" if local else "200"}  # fmt: skip
    for name, value in options.items():
        builder = builder.config(name, value)
    session = builder.getOrCreate()
    session.sparkContext.setLogLevel("ERROR")
    return ibis.pyspark.connect(session)


def answers_in(backend: Any, places: Sequence[str]) -> Any:
    """The table of answers in these places, as one Ibis table; raises `CountryError`.

    A place is a folder of Parquet files, a Parquet file, or the name of a table of the backend.
    """
    import ibis

    tables = []
    for place in places:
        try:
            table = _read(backend, place) if is_parquet(place) else backend.table(place)
        except CountryError:
            raise
        except Exception as error:  # each backend has errors of its own
            raise CountryError(f"{place}: {_first_line(error)}") from None
        missing = [name for name in NAMES if name not in table.columns]
        if absent := [name for name in missing if name not in LATER]:
            raise CountryError(said("{place}: this is no table of answers: no column {column}",
                                    place=place, column=absent[0]))  # fmt: skip
        empty = {name: ibis.null("timestamp('UTC')") for name in missing}
        tables.append(table.mutate(**empty).select(*NAMES))
    return ibis.union(*tables) if len(tables) > 1 else tables[0]


def _read(backend: Any, place: str) -> Any:
    """By the names of the columns: older files of a folder lack the later ones."""
    by_name = {"duckdb": {"union_by_name": True}, "pyspark": {"mergeSchema": True}}
    return backend.read_parquet(_files(place), **by_name.get(backend.name, {}))


def _files(place: str) -> str:
    if not Path(place).is_dir():
        return place
    if not any(Path(place).glob("*.parquet")):
        raise CountryError(said("{place}: there is no Parquet file in this folder", place=place))
    return f"{escape(place)}/*.parquet"  # a folder may be called answers [2025]


def _first_line(error: Exception) -> str:
    text = next((line.strip() for line in str(error).splitlines() if line.strip()), "")
    return "".join(c for c in text or type(error).__name__ if c.isprintable())[:300]
