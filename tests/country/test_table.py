"""Answers as a table: nobody is lost, nothing in it is a formula, and its schema is documented."""

from __future__ import annotations

import json
import random
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest
from click.testing import CliRunner

from sim.classroom.files.reading import Reading, Source
from sim.cli import main
from sim.country.from_files import Written, write_table
from sim.country.item_cells import item_sums_of
from sim.country.refusal import CountryError
from sim.country.rows import rows_of
from sim.country.schema import COLUMNS, NAMES, arrow_schema, reference
from sim.country.write import TableWriter
from sim.lesson.csv_text import safe_text
from sim.lesson.handin import encode
from tests.classroom.given.makers import bank, form, keys
from tests.country.school import BANK, KEY, files_of, school_files

ROOT = Path(__file__).parents[2]


def anybody(name: str) -> tuple[str, int, str]:
    return "class", 1, ""


def written(folder: Path, files: list[Source]) -> tuple[Written, list[dict[str, Any]]]:
    done = write_table(folder, lambda: iter(files), anybody)
    return done, pq.read_table(sorted(folder.glob("*.parquet"))).to_pylist()


def _table(folder: Path) -> Path:
    written(folder, [KEY, *school_files(1, 3)])
    return folder / "answers-0001.parquet"


@pytest.mark.parametrize("seed", range(4))
def test_every_file_stands_in_the_table_with_a_row_for_every_question_of_its_key(
    seed: int, tmp_path: Path
) -> None:
    files = [*school_files(seed, 12), KEY]
    done, rows = written(tmp_path / "t", files)
    read = Reading.of(files)
    assert done.files == len(read.files)
    assert done.rows == len(rows)
    of_sheet = Counter(row["sheet"] for row in rows)
    assert len(of_sheet) == len(read.files)
    assert all(row["sheet_rows"] == of_sheet[row["sheet"]] for row in rows)
    asked = Counter(row["sheet"] for row in rows if row["position"])
    assert set(asked.values()) == {len(BANK.items)}
    typed = sum(bool(r.answers.latest().get("scene-1")) for r in read.files)
    assert sum(row["item"] == "scene-1" for row in rows) == typed


def test_a_file_without_an_answer_is_a_row_without_a_question(tmp_path: Path) -> None:
    empty = files_of(1, 1)[0] | {"items": []}
    done, rows = written(tmp_path / "t", [Source("a.json", json.dumps(empty).encode())])
    assert (done.files, [row["item"] for row in rows]) == (1, [None])


@pytest.mark.parametrize("seed", range(3))
def test_no_text_in_the_table_could_be_a_formula(seed: int, tmp_path: Path) -> None:
    files = files_of(seed, 8, prefix="=cmd|' /C calc'!A0")
    for file in files:
        file["lesson"] = "@lesson"
    sources = [Source(f"+{k}.json", json.dumps(file).encode()) for k, file in enumerate(files)]
    _, rows = written(tmp_path / "t", sources)
    texts = {c.name for c in COLUMNS if c.kind == "string"}
    for row in rows:
        for name in texts:
            text = row[name]
            numeric = name == "value" and row["number"] is not None
            assert text is None or numeric or not text or safe_text(text) in (text, f"'{text}")
            assert text is None or numeric or text[:1] not in tuple("=+-@|%\t\r")


def test_equal_files_give_equal_bytes(tmp_path: Path) -> None:
    files = [KEY, *school_files(3, 6)]
    for name in "ab":
        write_table(tmp_path / name, lambda: iter(files), anybody)
    one, other = ({path.name: path.read_bytes() for path in (tmp_path / n).iterdir()} for n in "ab")
    assert one == other


def test_the_schema_is_that_of_the_reference_and_of_every_part(tmp_path: Path) -> None:
    page = (ROOT / "docs" / "reference" / "class.md").read_text(encoding="utf-8")
    assert "\n".join(reference()) in page
    _, rows = written(tmp_path / "t", [KEY, *school_files(3, 2)])
    (part,) = (tmp_path / "t").glob("*.parquet")
    assert pq.read_schema(part).equals(arrow_schema(), check_metadata=True)
    for column in COLUMNS:
        if not column.empty:
            assert all(row[column.name] is not None for row in rows), column.name


def test_no_answers_at_all_are_a_table_without_rows(tmp_path: Path) -> None:
    done, rows = written(tmp_path / "t", [Source("a.json", b"{")])
    assert (done.files, rows, len(done.refused)) == (0, [], 1)


def test_a_folder_with_something_in_it_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine", encoding="utf-8")
    with pytest.raises(CountryError, match="not empty"):
        write_table(tmp_path, lambda: iter([KEY]), anybody)
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]


def test_what_was_broken_off_leaves_no_part_that_looks_whole(tmp_path: Path) -> None:
    whole = pq.read_table(_table(tmp_path / "whole")).to_pylist()
    (tmp_path / "broken").mkdir()
    with pytest.raises(KeyboardInterrupt), TableWriter(tmp_path / "broken") as table:
        table.add(tuple(row.values()) for row in whole)
        table._write()
        assert [path.suffix for path in (tmp_path / "broken").iterdir()] == [".part"]
        raise KeyboardInterrupt
    assert list((tmp_path / "broken").iterdir()) == []


def test_a_table_is_parted_by_its_rows_and_read_as_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sim.country.write.BATCH", 50)
    monkeypatch.setattr("sim.country.write.PART", 200)
    done, rows = written(tmp_path / "t", [KEY, *school_files(5, 20)])
    parts = sorted((tmp_path / "t").glob("*.parquet"))
    assert len(parts) > 2
    assert len(rows) == done.rows
    assert list(rows[0]) == list(NAMES)


def test_without_the_extra_one_sentence_says_what_to_install(tmp_path: Path) -> None:
    for source in school_files(1, 2):
        (tmp_path / source.name).write_bytes(source.content)
    code = (
        "import sys\n"
        "for name in ('pyarrow', 'ibis', 'duckdb'): sys.modules[name] = None\n"
        "from sim.cli import main\n"
        f"main(['class', {str(tmp_path)!r}, '--parquet', {str(tmp_path / 'new')!r}])"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert run.returncode == 2
    assert 'pip install "newtons-carts[country]"' in run.stderr
    assert "Traceback" not in run.stderr


def test_a_report_on_files_loads_nothing_of_the_extra(tmp_path: Path) -> None:
    for source in [KEY, *school_files(1, 6)]:
        (tmp_path / source.name).write_bytes(source.content)
    code = (
        "import sys\nfrom click.testing import CliRunner\nfrom sim.cli import main\n"
        f"print(CliRunner().invoke(main, ['class', {str(tmp_path)!r}]).exit_code)\n"
        "print(sorted({'pyarrow', 'ibis', 'duckdb', 'pandas'} & sys.modules.keys()))"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.split("\n")[:2] == ["0", "[]"]


def test_the_rows_of_a_file_do_not_depend_on_the_others() -> None:
    from sim.classroom.report.marked import Keys, mark_file
    from sim.country.rows import Place

    reading = Reading.of([KEY, *school_files(9, 6)])
    of_files = Keys(reading.keys)
    dice = random.Random(1)

    def made(order: list[int]) -> dict[str, Any]:
        found = {}
        for k in order:
            read = reading.files[k]
            key = of_files.of(read.answers)
            file = mark_file(read, "class", key, {})
            found[read.name] = rows_of(file, Place("class", 1, "", k), key)
        return found

    straight = list(range(len(reading.files)))
    assert made(dice.sample(straight, len(straight))) == made(straight)


def test_groups_and_typed_codes_stand_in_the_table(tmp_path: Path) -> None:
    """A code is in the group of its student's file; of nobody's else it is named by its line."""
    for folder, seed in (("new", 1), ("old", 2)):
        (tmp_path / folder).mkdir()
        for source in school_files(seed, 6, prefix=folder):
            (tmp_path / folder / source.name).write_bytes(source.content)
    (tmp_path / "key.json").write_bytes(KEY.content)
    typed = bank(4)
    (tmp_path / "typed.json").write_text(keys(typed, ["delayed"]), encoding="utf-8")
    code = encode([4] * 4, [1] * 4, f"delayed:{form('delayed', typed).hash}")
    codes = tmp_path / "codes.txt"
    codes.write_text(f"old-1 {code}\nBEE {code}\n", encoding="utf-8")
    words = ["class", str(tmp_path), "--group", "old=old/*", "--group", "new=new/*",
             "--codes", str(codes), "--parquet", str(tmp_path / "table")]  # fmt: skip
    result = CliRunner().invoke(main, words)
    assert result.exit_code == 1, result.output
    assert f"{codes.as_posix()}/line 2: BEE delayed: this code is in none of" in result.stderr
    table = pq.read_table(tmp_path / "table" / "answers-0001.parquet").to_pylist()
    assert {(r["group"], r["group_order"], r["class"]) for r in table} == {
        ("old", 1, "old/*"), ("new", 2, "new/*")}  # fmt: skip
    assert {(r["student"], r["group"]) for r in table if "/line " in r["file"]} == {
        ("old-1", "old")}  # fmt: skip


@pytest.mark.parametrize(("kind", "to_read"), [("long", 2), ("idea", 0)])
def test_words_in_an_optional_part_are_to_be_read_and_first_ideas_are_not(
    kind: str, to_read: int
) -> None:
    cell: Any = {"n": 2, "answered": True, "verdict": "open", "certain": False, "chosen": ""}
    meta = {"type": kind, "worth": 0, "sure": False, "choices": []}
    sums = item_sums_of([cell], meta, 2, counted=False, keyed=True)
    assert sums.counts["unread"] == to_read
