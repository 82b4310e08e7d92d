"""What cannot be read is refused with its line and the reason; a fuzz of files never breaks."""

from __future__ import annotations

import math
from random import Random

import pytest

from sim.measured.model.fit import fit
from sim.measured.refusal import FitError, ReadingError
from sim.measured.sheet.cells import MOST_BYTES, decoded
from sim.measured.tracks import Measured, read_measured
from sim.measured.zipped import MOST_ZIPPED
from tests.measured.written_films import PLAIN, VARIANTS, A, T, rows, with_y
from tests.web.scene.given.widget_site import in_node

HEAD = "t\tx_A\tx_B\n"


GOOD = rows("\t").splitlines()


def body(change: dict[int, str]) -> str:
    return HEAD + "\n".join(change.get(k, line) for k, line in enumerate(GOOD)) + "\n"


REFUSED = {
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


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_read_is_refused_with_its_line_and_the_reason(name: str) -> None:
    text, line, reason = REFUSED[name]
    with pytest.raises(ReadingError) as caught:
        read_measured([text])
    fault = caught.value.faults[0]
    assert (fault.line, reason in fault.reason) == (line, True), fault


def test_bytes_that_are_no_text_are_refused_with_their_line() -> None:
    with pytest.raises(ReadingError) as caught:
        decoded(b"t\tx\n1\t2\n\xff\xfe\x01")
    assert caught.value.faults[0].line == 3


SPICE = ["\t", ",", ";", ".", "-", "\u2212", "\n", "\r\n", "\0", '"', "e", "E400", "nan", " "]


SPICE += ["#", "#multi:", "\u00a0", "9" * 30, "x", "(m)", "\ufeff", "٣", "½", "'", "1_0", "/", "F"]


SEEDS = [PLAIN, VARIANTS["CSV"], VARIANTS["semicolons"], with_y(), "t;F1;F2\n" + rows(";")]


def mutated(random: Random) -> str:
    text = random.choice(SEEDS)
    for _ in range(random.randint(1, 3)):
        at, length = random.randrange(len(text) + 1), random.choice([0, 0, 1, 2, 30, 300])
        kind = random.randrange(4)
        if kind == 0:
            text = text[:at] + random.choice(SPICE) * random.choice([1, 1, 2, 40]) + text[at:]
        elif kind == 1:
            text = text[:at] + text[at + length :]
        elif kind == 2:
            text = text[:at] + text[at : at + length] * 2 + text[at + length :]
        else:
            text = text[:at] + chr(random.randrange(0x250)) + text[at + 1 :]
    return text


@pytest.mark.slow
def test_a_fuzz_of_files_is_read_or_refused_with_a_line_and_a_reason(
    pytestconfig: pytest.Config,
) -> None:
    count = 10_000 if pytestconfig.getoption("--fuzz") else 2_000
    random, refused, fitted = Random(9), 0, 0
    for _ in range(count):
        text = mutated(random)
        try:
            found = read_measured([text])
        except ReadingError as error:
            refused += 1
            assert error.faults
            lines = text.count("\n") + text.count("\r") + 1
            assert all(1 <= fault.line <= lines and fault.reason for fault in error.faults), text
        else:
            for track in found.tracks:
                assert len(track.t) == len(track.value) >= 8
                assert all(a < b for a, b in zip(track.t, track.t[1:], strict=False))
                assert all(abs(value) <= 1e9 for value in (*track.t, *track.value))
            if random.random() < 0.02 and found.kind == "length":
                fitted += fits_or_is_refused(found)
    assert 0.2 < refused / count < 0.9  # both happen
    assert fitted > count / 1000


def fits_or_is_refused(found: Measured) -> bool:
    try:
        return math.isfinite(fit(found).noise)
    except FitError as error:
        assert error.reason
        return False


def test_a_file_is_too_large_for_the_page_where_it_is_for_python() -> None:
    script = """const { MOST_BYTES, MOST_ZIPPED } = await import(source + "/measured/source.js");
    give([MOST_BYTES, MOST_ZIPPED]);"""
    assert in_node(script, None) == [MOST_BYTES, MOST_ZIPPED]


def test_words_below_the_readings_are_answered_with_how_a_remark_is_written() -> None:
    text = body({}) + "Filmed by 10b\n"
    with pytest.raises(ReadingError) as caught:
        read_measured([text])
    (fault,) = caught.value.faults
    assert fault.hint == "begin the line of a remark with #, or take it out"
    assert read_measured([text.replace("Filmed", "# Filmed")]).names == ("A", "B")
