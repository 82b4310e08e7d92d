"""Texts of readings that are refused: the line of the first fault, and what is said of it."""

from __future__ import annotations

from tests.measured.written_films import A, T, rows

HEAD = "t\tx_A\tx_B\n"


GOOD = rows("\t").splitlines()


def body(change: dict[int, str]) -> str:
    return HEAD + "\n".join(change.get(k, line) for k, line in enumerate(GOOD)) + "\n"


REFUSED: dict[str, tuple[str, int, str]] = {
    "nothing": ("", 1, "nothing in it"),
    "words only": ("hello\nworld\n", 1, "no row of numbers"),
    "one frame": (HEAD + GOOD[0], 2, "1 reading of “A”: at least 8"),
    "a word": (body({3: "0.1\tnear\t0.2"}), 5, "“near” is not a number"),
    "a unit in a cell": (body({3: "0.1\t0.3 m\t0.2"}), 5, "a unit stands in a cell"),
    "the same time twice": (body({4: GOOD[3]}), 6, "stands in line 5 already"),
    "time goes back": (body({4: "0.01\t0.5\t0.9"}), 6, "the time goes back"),
    "a reading without time": (body({4: "\t0.5\t0.9"}), 6, "no time"),
    "two decimal signs": (body({9: GOOD[9].replace(".", ",")}), 11, "another decimal sign"),
    "thousands in whole numbers": (
        "t\tx_A (mm)\tx_B (mm)\n" + "".join(f"{k}\t{980 + k}\t800\n" for k in range(20))
        + "".join(f"{k}\t1,{k:03}\t800\n" for k in range(20, 40)), 22, "a thousand times"
    ),
    "thousands of millimetres": (
        "t (ms)\tx_A (mm)\tx_B (mm)\n" + "".join(f"{k}\t1,{300 + k}\t2,001\n" for k in range(20)),
        2, "a thousand times"
    ),
    "thousands of milliseconds": (
        "t (ms)\tx_A (cm)\tx_B (cm)\n"
        + "".join(f"1,{20 * k:03}\t{30 + k}\t80\n" for k in range(20)),
        2, "a thousand times"
    ),
    "too many cells": (body({2: "0.1\t1\t2\t3"}), 4, "4 cells under 3 heads"),
    "mixed units": (
        "t\tx_A (cm)\tx_B\n" + rows("\t"), 1, "one column names its unit and the other does not"
    ),
    "a wrong unit": ("t\tx_A (kg)\tx_B (kg)\n" + rows("\t"), 1, "“kg” is not a unit of length"),
    "three carts": (
        "t\tx_A\tx_B\tx_C\n" + rows("\t", tail="\t1"), 1, "3 carts"
    ),
    "one cart": ("t\tx_A\n" + "".join(f"{t}\t{a}\n" for t, a in zip(T, A, strict=True)),
                 len(T) + 1, "readings of 1 cart:"),
    "no such columns": ("t\ta\tb\tc\n1\t2\t3\t4\n2\t3\t4\t5\n", 1, "no column holds positions"),
    "frames in the place of time": ("frame\tx_A\tx_B\n" + rows("\t"), 1, "counts frames"),
    "frames of each cart in the place of time": (
        "y,x,frame,particle\n" + "".join(f"5,{a},{k},0\n5,{b},{k},1\n"
                                         for k, a in enumerate(A) for b in [a + 0.3]),
        1, "“frame” counts frames"
    ),
    "four numbers, no heads": ("1\t2\t3\t4\n2\t3\t4\t5\n", 1, "no line that names them"),
    "decimal commas between commas, one number whole": (
        "t,x_A,x_B\n" + "".join(f"0,{k},1,0,{k}\n" for k in range(100, 120)), 2, "comma"
    ),
    "a thousand columns": (
        "\t".join(f"x{k}" for k in range(1000)) + "\n" + "\t".join("1" * 1000) + "\n", 1, "columns"
    ),
    "a film": ("a\0b" * 10, 1, "no text"),
    "a long line": ("1" * 20_000, 1, "characters"),
    "endless": ("1\t2\t3\n" * 20_001, 20_001, "20,000 lines"),
    "far too large a number": (body({3: "1e99\t0.3\t0.2"}), 5, "too large"),
}  # fmt: skip
