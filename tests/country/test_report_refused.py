"""What is no table of answers is refused in words, and fuzzed tables never break a report."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from sim.country.backend import DUCKDB, answers_in, connect
from sim.country.refusal import CountryError
from sim.country.report import read_table
from tests.country.class_command import carts, table
from tests.country.school import KEY, lay, school_files


@pytest.mark.parametrize(
    "words",
    [("--table", "T", "KEY"), ("--table", "T", "--csv", "x.csv"), ("--table", "T", "--merge"),
     ("--table", "T", "--group", "a=b"), ("--parquet", "N"),
     ("KEY", "--parquet", "N", "--max", "3"),
     ("--table", "T", "--table", "KEY"), ("KEY", "--backend", "duckdb://"),
     ("--table", "no.parquet"), ("KEY", "--parquet", "N", "--csv", "x.csv")],
)  # fmt: skip
def test_calls_that_cannot_be_meant_end_with_2(
    school: Path, school_table: Path, words: tuple[str, ...]
) -> None:
    places = {"T": school_table, "KEY": school / "key.json", "N": school.parent / "new"}
    assert carts(*(places.get(word, word) for word in words)).exit_code == 2


def test_what_is_no_table_of_answers_is_named(tmp_path: Path) -> None:
    pq.write_table(pa.table({"a": [1]}), tmp_path / "other.parquet")
    (tmp_path / "text.parquet").write_text("hello", encoding="utf-8")
    (tmp_path / "empty").mkdir()
    for name, reason in (("other.parquet", "no column sheet"), ("text.parquet", "text.parquet: "),
                         ("empty", "no Parquet file")):  # fmt: skip
        result = carts("--table", tmp_path / name)
        assert result.exit_code == 1
        assert reason in result.stderr
        assert "Traceback" not in result.output


@pytest.mark.slow
def test_fuzzed_tables_are_read_or_refused_and_never_break(
    tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    """Tables with cells changed at random; `make fuzz` changes many more."""
    count = 1_000 if request.config.getoption("--fuzz") else 5
    dice = random.Random(4)
    place = lay(tmp_path / "files", [KEY, *school_files(2, 8)])
    part = table(place) / "answers-0001.parquet"
    seed = pq.read_table(part)
    backend = connect(DUCKDB)
    evil: dict[str, list[Any]] = {
        "string": [None, "", "=1+1", "<b>x</b>", "x" * 9_000, "pre", "right", "\x00", ";"],
        "int32": [None, -1, 0, 2**31 - 1], "int64": [None, -5, 2**62], "bool": [None, True, False],
        "double": [None, float("nan"), float("inf"), -0.0],
    }  # fmt: skip
    read = 0
    for k in range(count):
        changed = seed
        for _ in range(dice.randint(1, 3)):
            field = dice.choice(list(seed.schema))
            column = changed.column(field.name).to_pylist()
            values = evil.get(str(field.type), [None])
            for _ in range(dice.randint(1, 30)):
                column[dice.randrange(len(column))] = dice.choice(values)
            at = changed.schema.get_field_index(field.name)
            changed = changed.set_column(at, field.name, pa.array(column, field.type))
        path = tmp_path / f"{k}.parquet"
        pq.write_table(changed, path)
        try:
            report, _, _ = read_table(answers_in(backend, [str(path)]), [])
        except CountryError as error:
            assert str(error)
            continue
        read += 1
        json.dumps(report, allow_nan=False)
    assert 0 < read < count
