"""A class in which everything happens that a report speaks of, and how to find English in it."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from functools import cache
from html import unescape
from typing import Any

from sim.classroom.files.reading import Reading, Source
from sim.classroom.report.report import Asked, class_report
from sim.lesson.bank import read_bank
from sim.lesson.key_file import key_file
from sim.pages.language import words
from sim.scene.said import RULE
from tests.classroom.given.makers import TIME, answers, bank, keys, random_class, sources

GROUPS = ("A", "B")
BANK = bank(10, words=2, topics=("t1", "t2"))
DAY = TIME.format(day=1, minute=0, second=0)
LESSON = read_bank({
    "title": "L",
    "items": [
        {"id": "item-0", "type": "single", "ask": "A?", "sure": True,
         "options": [{"text": "b", "belief": "bigger-pushes-more"}, {"text": "c",
                     "correct": True}]},
        {"id": "speed", "type": "number", "ask": "B?", "answer": "0.30 m/s", "tolerance": "1 %",
         "wrong": [{"value": "0.60 m/s"}]},
        {"id": "why", "type": "long", "ask": "C?", "rubric": {0: "d", 1: "e"}},
        {"id": "guess", "type": "idea", "ask": "D?", "options": ["f", "g"]},
    ],
})  # fmt: skip
"""Texts of one letter: what is longer in a report was said by us."""


def a_class() -> list[Source]:
    """Files, keys and what is none: two groups before and after, a worksheet, doubles, no names."""
    tests = [
        *random_class(BANK, 24, seed=1, gain=0.3, prefix="A"),
        *random_class(BANK, 24, seed=2, gain=0.1, prefix="B"),
    ]
    later = answers(BANK, "A-1", "pre", {"item-0": "a"}, day=3)
    again = {**tests[0], "saved": TIME.format(day=2, minute=0, second=0),
             "items": tests[0]["items"][1:]}  # fmt: skip
    other = answers(BANK, "A-9", "delayed", {"item-0": "a"}, start=3)
    other["items"][0]["hash"] = "0" * 12
    strange = answers(BANK, "A-8", "delayed", {"item-0": "a"}) | {"saved": "2001-01-01T00:00:00Z"}
    keyed = [Source("k1.json", keys(BANK, ("pre", "post", "delayed")).encode()),
             Source("k2.json", _key())]  # fmt: skip
    bad = [
        Source("x1.json", b"{"),
        Source("x2.json", b"\xff\xfe\x00"),
        Source("x3.zip", b"PK\x03\x04"),
    ]
    nobody = [Source(f"n{k}.json", json.dumps(answers(BANK, "", "post", {})).encode())
              for k in range(2)]  # fmt: skip
    doubles = [Source(f"d{k}.json", json.dumps(one).encode())
               for k, one in enumerate([later, again, tests[2], other, strange])]  # fmt: skip
    return [*sources(tests), *sources(_worksheets()), *doubles, *nobody, *keyed, *bad]


def _key() -> bytes:
    made = key_file("tests", "L1", list(LESSON.items.values()), [], title="L1")
    return json.dumps(made).encode()


def _worksheets() -> Iterable[dict[str, Any]]:
    """Answers with second thoughts, predictions, runs of their own; the same ones in two files."""
    for k in range(12):
        made = answers(LESSON, f"W-{k}", "worksheet", {
            "item-0": "ab"[k % 3 > 0], "speed": 0.6 if k % 2 else 0.3, "why": "h", "guess": "a",
        }, lesson="L1")  # fmt: skip
        for row in made["items"]:
            row |= {"tries": 2, "right": k % 3, "before": {"value": "ba"[k % 2]}}
        yield made | {"items": [*made["items"], *_done(k)]}


def _done(k: int) -> list[dict[str, Any]]:
    def row(kind: str, value: Any, **more: Any) -> dict[str, Any]:
        return {"id": kind, "hash": "", "type": kind, "value": value, "first": DAY, "last": DAY,
                "tries": 1, "asked": "E?", **more}  # fmt: skip

    return [
        row("choice", "0", said=f"p{k}", why="q", sure="sure", **({"again": DAY} if k > 2 else {})),
        row("arrows", [1], said="r", locked=DAY),
        row("curve", [0, 2, k % 5, 2, 0], said="s"),
        row("challenge", {"runs": 3, "found": k % 2, "values": "u"}),
        row("found-force", "2", said="v"),
        row("reading", 2, set={"A.mass": 2.0}),
    ]


class Blanked(dict[str, str]):
    """A language of blanks: what is left of a report in it did not come out of a catalogue."""

    def __init__(self) -> None:
        super().__init__({key: _blank(key) for key in words("ms") if key != RULE})


def _blank(sentence: str) -> str:
    return "".join(
        part if part.startswith("{") else re.sub(r"[^\W\d_]", "·", part)
        for part in re.split(r"(\{\w+\})", sentence)
    )


OWN = re.compile(
    r"\b(?:[ABW]-\d+|W|item-\d+|why-\d+|[tknxdpL]\d+|carts|Carts|tests|pre|post|delayed|worksheet|"
    r"json|zip|csv|Marks|speed|why|Why|guess|choice|arrows|curve|challenge|found|force|reading|Question|answer|"
    r"right|of|Made|up|mass|alpha|delta)\b|kg|m/s|marks\d*\.csv"
)
"""Names of files, items, lessons and forms, texts of authors and students, and Greek letters."""


def left_in_english(text: str) -> set[str]:
    """Words of two letters or more that are no names."""
    return set(re.findall(r"[A-Za-z]{2,}", OWN.sub(" ", text)))


def texts_of(html: str) -> list[str]:
    """What stands between the marks of a page, and in its labels; without style and head."""
    body = re.sub(r"<style.*?</style>", "", html, flags=re.DOTALL)
    labels = re.findall(r'aria-label="([^"]*)"', body)
    return [unescape(text).strip() for text in [*re.findall(r">([^<]+)<", body), *labels]]


@cache
def of_everything() -> dict[str, Any]:
    """The report on that class."""
    reading = Reading.of(a_class())
    files = [(read, GROUPS["B-" in read.name]) for read in reading.files]
    asked = Asked(groups=GROUPS, classes={"A": 2, "B": 2}, now="2026-10-01T00:00:00Z")
    return class_report(files, reading.keys, reading.refused, asked)
