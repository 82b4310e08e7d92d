"""The table of answers: one row an answer, flat, with the file that it stands in on every row.

A question of a key that was left open has a row too, with `answered` false; a file without any
answer has one row without `item`. So nobody is lost, and every count is a count of rows.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

FORMAT = 1
Kind = Literal["string", "bool", "int32", "int64", "float64", "timestamp"]


@dataclass(frozen=True, slots=True)
class Column:
    """A column. `kind` in Arrow's words; a `timestamp` is in milliseconds, UTC."""

    name: str
    kind: Kind
    what: str
    empty: bool = False


COLUMNS = (
    Column("sheet", "string", "the file: 16 hexadecimal digits of its place, name and answers"),
    Column("sheet_rows", "int32", "how many rows this file has"),
    Column("sheet_order", "int64", "its place among the files as they were read, from 1"),
    Column("file", "string", "its name"),
    Column("site", "string", "`site_id` of the site"),
    Column("lesson", "string", "the lesson"),
    Column("lesson_hash", "string", "which version of it"),
    Column("form", "string", "pre, worksheet, post or delayed"),
    Column("group", "string", "the group of `--group`, or `class`"),
    Column("group_order", "int32", "its place among the groups, from 1"),
    Column("class", "string", "the pattern of `--group` that fitted; empty without groups"),
    Column("student", "string", "the code word as it was typed; may be empty"),
    Column("person", "string", "the code word as it is compared; without one, the file's own"),
    Column("created", "timestamp", "when the file was begun; empty for a typed code", empty=True),
    Column("saved", "timestamp", "when it was saved", empty=True),
    Column("digest", "string", "of all answers: equal in two files with equal answers"),
    Column("digest_timed", "string", "the same with the times of the answers"),
    Column("keyed", "bool", "a key was there for this file: its answers are marked"),
    Column("item", "string", "the question's id", empty=True),
    Column("position", "int32", "its place in the key, from 1", empty=True),
    Column("type", "string", "its type, or of a prediction: arrows, curve, choice, text",
           empty=True),
    Column("hash", "string", "which wording of it was answered", empty=True),
    Column("value", "string", "the answer: a text as typed, all else as JSON", empty=True),
    Column("number", "float64", "the answer where it is a number, in the unit of the question",
           empty=True),
    Column("answered", "bool", "something was answered"),
    Column("chosen", "string", "options that this answer counts for, parted by `;`; of a "
           "prediction its words"),
    Column("beliefs", "string", "beliefs behind a wrong answer, parted by `;`"),
    Column("verdict", "string", "right, partly, wrong, open, empty, unclear", empty=True),
    Column("marks", "int32", "marks; empty where a person has to read it", empty=True),
    Column("worth", "int32", "the most marks; empty without a key", empty=True),
    Column("foreign", "bool", "another wording than the key's was answered"),
    Column("sure", "string", "how sure the student was; may be empty"),
    Column("first", "timestamp", "first answer", empty=True),
    Column("last", "timestamp", "last answer", empty=True),
    Column("tries", "int32", "how often it was checked", empty=True),
    Column("asked", "string", "of a prediction: what was asked", empty=True),
    Column("locked", "bool", "of a prediction: it was locked before the run", empty=True),
    Column("said", "string", "of a prediction: its words, and what was said besides", empty=True),
    Column("why", "string", "of a prediction: the reason given for it", empty=True),
    Column("again", "timestamp", "of a prediction: when an earlier one of this student was locked, "
           "who had seen the run", empty=True),
)  # fmt: skip
NAMES = tuple(column.name for column in COLUMNS)
LATER = ("again",)
"""Columns that older tables have not; nothing stands in them there."""


def arrow_schema() -> Any:
    """The same as a `pyarrow.Schema`; `newtons-carts` in its metadata is the format."""
    import pyarrow as pa

    kinds = {
        "string": pa.string(), "bool": pa.bool_(), "int32": pa.int32(), "int64": pa.int64(),
        "float64": pa.float64(), "timestamp": pa.timestamp("ms", tz="UTC"),
    }  # fmt: skip
    fields = [pa.field(c.name, kinds[c.kind], nullable=c.empty) for c in COLUMNS]
    return pa.schema(fields, metadata={"newtons-carts": str(FORMAT)})


def reference() -> list[str]:
    """The lines of a table for `docs/reference`."""
    rows = [f"| `{c.name}` | {c.kind}{', may be empty' if c.empty else ''} | {c.what} |"
            for c in COLUMNS]  # fmt: skip
    return ["| column | Arrow type | what |", "|---|---|---|", *rows]
