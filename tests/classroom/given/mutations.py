"""The adversary of tables and summaries: good files with something broken in them, and an oracle.

    make fuzz AREA=classroom     or     python -m tests.classroom.given.mutations [--count 10000]

A file is mutated once to four times: bytes, cells, lines, numbers, keys, hostile texts. Whatever
comes out, nothing but the error for people may be raised, what is refused is named (a row by a line
that the file has), the report is JSON without NaN, its HTML holds no element of a file's making,
and no cell of its tables begins a formula.
"""

from __future__ import annotations

import argparse
import json
import random
import re
import sys
from base64 import b64encode
from collections import Counter
from collections.abc import Callable
from typing import Any

from sim.classroom.summary.document import Read, document
from sim.classroom.summary.handed_on import handed_on
from sim.classroom.summary.merge import merged
from sim.classroom.summary.numbers import SummaryError
from sim.classroom.summary.reading import read_summary
from sim.classroom.summary.written import summary_file
from sim.classroom.tables.dropped import dropped_report
from tests.classroom.given.sound import sound
from tests.classroom.given.tables import judged

HOSTILE = (
    "=cmd|'/c calc'!A1", "+1+1", "-2+3", "@SUM(A1)", "\t=1", "＝1", "\u200b=1",
    "<script>x()</script>", "<img src=x onerror=x()>", "</td><iframe>", "javascript:x()",
    "\x00", "\x1b[31m", "\u202e", '"',
    "'", "1e999", "nan", "inf", "-1", "1e308", "0x10", "９", "1,5", "1.5.1", "", " ", "9" * 400,
    "../../etc/passwd", "{{7*7}}", "pre", "KEY", "MAX", "student", "%s%n", "\ud83d\ude00",
)  # fmt: skip
VALUES: tuple[Any, ...] = (
    None, True, -1, 0, 1e308, 10**40, "1/0", "1/3", "nan", [], {}, [[]], {"a": 1}, *HOSTILE[:9],
)  # fmt: skip
TABLES = (
    "student;group;class;pre (30);post (30);later (30)\n"
    + "".join(
        f"S{k};{'ab'[k % 2]};{k % 4};{8 + k % 5};{12 + k % 7},5;{k % 20}\n" for k in range(12)
    ),
    "student,time,q1,q2,q3\nMAX,,1,2,1\n"
    + "".join(f"S{k},{t},{k % 2},{k % 3},1\n" for t in ("pre", "post") for k in range(8)),
    "name,Q1,Q2,Q3\nKEY,a,b,c\n" + "".join(f"N{k},{'abcd'[k % 4]},b,-\n" for k in range(9)),
)  # fmt: skip


def of_table(dice: random.Random) -> str:
    """What became of a mutated table: read, or refused in words. Raises AssertionError."""
    text = dice.choice(TABLES).encode()
    content = _broken(text, dice)
    made = {"name": "marks.csv", "base64": b64encode(content).decode(), "form": ""}
    report = dropped_report([made], dice.choice(["", "30", "many"]), inference=False)
    lines = max(1, len(re.split(rb"\r\n|\r|\n|\x0b|\x0c|\x1c|\x1d|\x1e", content))) + 2
    for row in report["files"]["refused"]:
        assert row["reason"].strip(), row
        if found := re.search(r", line (\d+)$", row["name"]):
            assert 1 <= int(found[1]) <= lines + content.count(b"\xc2\x85"), row
    sound(report)
    return "read" if report["files"]["counted"] else "refused"


def _good() -> dict[str, Any]:
    found = judged(TABLES[1].encode())
    return summary_file(handed_on([found.lesson], found.groups, by_total=True))


def of_summary(dice: random.Random) -> str:
    """The same of a summary: alone, and added to a good one."""
    content = json.dumps(_good()).encode()
    if dice.random() < 0.3:
        content = _broken(content, dice)
    else:
        tree = json.loads(content)
        for _ in range(dice.randint(1, 4)):
            _change(tree, dice)
        content = json.dumps(tree).encode()
    try:
        found = read_summary(content)
    except SummaryError as error:
        assert str(error).strip()
        return "refused"
    good = read_summary(json.dumps(_good()).encode())
    whole, left_out = merged([("good.json", good), ("other.json", found)])
    assert all(reason.strip() for _, reason in left_out)
    read = Read(unit="summaries", read=2, counted=2 - len(left_out), refused=left_out)
    sound(document(whole.lessons, whole.groups, read))
    return "left out" if left_out else "added"


def _broken(content: bytes, dice: random.Random) -> bytes:
    """One to four mutations of a text file."""
    for _ in range(dice.randint(1, 4)):
        content = dice.choice(MUTATIONS)(content, dice)
    return content


def _cell(content: bytes, dice: random.Random) -> bytes:
    lines = content.decode("utf-8", "replace").split("\n")
    row = dice.randrange(len(lines))
    between = ";" if ";" in lines[0] else ","
    cells = lines[row].split(between)
    cells[dice.randrange(len(cells))] = dice.choice(HOSTILE)
    lines[row] = between.join(cells)
    return "\n".join(lines).encode("utf-8", "surrogatepass")


def _bytes(content: bytes, dice: random.Random) -> bytes:
    at = dice.randrange(len(content) + 1)
    return content[:at] + bytes(dice.randbytes(dice.randint(1, 3))) + content[at + 1 :]


def _cut(content: bytes, dice: random.Random) -> bytes:
    return content[: dice.randrange(len(content) + 1)]


def _line(content: bytes, dice: random.Random) -> bytes:
    """A line twice, away, or somewhere else."""
    lines = content.split(b"\n")
    taken = lines.pop(dice.randrange(len(lines)))
    for _ in range(dice.randint(0, 2)):
        lines.insert(dice.randint(0, len(lines)), taken)
    return b"\n".join(lines)


def _recoded(content: bytes, dice: random.Random) -> bytes:
    text = content.decode("utf-8", "replace")
    return text.encode(dice.choice(["utf-16", "utf-8-sig", "cp1252", "utf-32"]), "replace")


MUTATIONS: tuple[Callable[[bytes, random.Random], bytes], ...] = (
    _cell, _cell, _cell, _cell, _bytes, _cut, _line, _line, _recoded,
)  # fmt: skip


def _change(tree: Any, dice: random.Random) -> None:
    """One value somewhere in a JSON tree is another, gone, or twice."""
    while True:
        places = list(tree) if isinstance(tree, dict) else list(range(len(tree)))
        if not places:
            return
        place = dice.choice(places)
        inner = tree[place]
        if isinstance(inner, (dict, list)) and inner and dice.random() < 0.85:
            tree = inner
            continue
        what = dice.randrange(4)
        if what == 0:
            del tree[place]
        elif what == 1 and isinstance(tree, list):
            tree.append(inner)
        elif what == 2 and isinstance(inner, int) and not isinstance(inner, bool):
            tree[place] = inner + dice.choice([-1, 1, 7, 10**6])
        else:
            tree[place] = dice.choice(VALUES)
        return


KINDS: dict[str, Callable[[random.Random], str]] = {"table": of_table, "summary": of_summary}


def main() -> int:
    """0 if nothing went wrong; the seed of what did is printed."""
    asked = argparse.ArgumentParser(prog="tests.classroom.mutations")
    asked.add_argument("--count", type=int, default=10_000)
    asked.add_argument("--from", type=int, default=0, dest="start")
    given = asked.parse_args()
    bad = 0
    for name, judge in KINDS.items():
        counts: Counter[str] = Counter()
        for seed in range(given.start, given.start + given.count):
            try:
                counts[judge(random.Random(seed))] += 1
            except Exception as error:  # whatever it is: that is the question
                bad += 1
                counts["wrong"] += 1
                print(f"{name} {seed}: {type(error).__name__}: {str(error)[:200]}")
        print(f"{name}: " + ", ".join(f"{count:,} {what}" for what, count in counts.items()))
    return min(bad, 1)


if __name__ == "__main__":
    sys.exit(main())
