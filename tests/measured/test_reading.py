"""Files as Tracker, spreadsheets and sensors write them, and files that nobody can use."""

from __future__ import annotations

import math
from random import Random

import pytest

from sim.measured.cells import decoded
from sim.measured.model.fit import fit
from sim.measured.refusal import FitError, ReadingError
from sim.measured.tracks import Measured, read_measured
from sim.measured.units import Units
from tests.measured.makers import as_text, film, truth

WANTED = film(truth(), rate=30)
T = WANTED.tracks[0].t
A, B = (track.value for track in WANTED.tracks)
PLAIN = as_text(WANTED)


def rows(separator: str, end: str = "\n", form: str = "{:.9E}", tail: str = "") -> str:
    return "".join(
        separator.join(form.format(value) for value in row) + tail + end
        for row in zip(T, A, B, strict=True)
    )


def decimal_comma(text: str) -> str:
    return text.replace(".", ",")


def with_y() -> str:
    """Two tracks with columns y and v_x, whose first and last cells Tracker leaves empty."""
    lines = ["#multi:", "\tmass_A\t\t\tmass_B\t\t\t", "t\tx\ty\tv_{x}\tx\ty\tv_{x}\t"]
    for k, (t, a, b) in enumerate(zip(T, A, B, strict=True)):
        v = "" if k in (0, len(T) - 1) else "1.0E0"
        lines.append(f"{t:.9E}\t{a:.9E}\t0.0E0\t{v}\t{b:.9E}\t0.0E0\t{v}\t")
    return "\n".join(lines) + "\n"


VARIANTS = {
    "tracker, several tracks, tab": PLAIN,
    "carriage returns": PLAIN.replace("\n", "\r\n"),
    "old Mac lines": PLAIN.replace("\n", "\r"),
    "byte order mark": "\ufeff" + PLAIN,
    "real minus signs": PLAIN.replace("-", "\u2212"),
    "decimal comma": decimal_comma(PLAIN),
    "decimal comma and real minus": decimal_comma(PLAIN).replace("-", "\u2212"),
    "semicolons and decimal comma": decimal_comma(PLAIN).replace("\t", ";"),
    "commas": PLAIN.replace("\t", ","),
    "velocity columns with empty cells": with_y(),
    "without the multi line": PLAIN.removeprefix("#multi:\n"),
    "CSV": "t,x_A,x_B\n" + rows(","),
    "CSV with a space": "t, x_A, x_B\n" + rows(", "),
    "CSV, quoted decimal commas": "t,x_A,x_B\n"
    + decimal_comma(rows(",", form='"{:.9f}"')).replace('",,"', '","').replace('","', '","'),
    "semicolons": "t;x_A;x_B\n" + decimal_comma(rows(";", form="{:.9f}")),
    "spaces": "t xA xB\n" + rows("  "),
    "spaces and decimal comma": "t xA xB\n" + decimal_comma(rows(" ")),
    "no heads": rows("\t"),
    "units in the heads": "t (s);A.x (m);B.x (m)\n" + rows(";"),
    "units on a line": "t;x1;x2\ns;m;m\n" + rows(";"),
    "remarks": "# filmed by us\n% 30 frames per second\nt\tx_A\tx_B\n" + rows("\t"),
    "empty lines": "\n\nt\tx_A\tx_B\n\n" + rows("\t", end="\n\n"),
    "trailing separators": "t\tx_A\tx_B\t\n" + rows("\t", tail="\t\t"),
    "names of carts": "t\tcart 1\tcart 2\n" + rows("\t"),
    "the page's own words": "t\tx of A\tx of B\n" + rows("\t"),
    "a logger's heads": "Run 1: Time (s),Run 1: Position 1 (m),Run 1: Position 2 (m)\n" + rows(","),
    "another logger's": '"Time (s) Run #1","Position 1 (m) Run #1","Position 2 (m) Run #1"\n'
    + rows(","),
    "other names": "Zeit\tOrt 1\tOrt 2\n" + rows("\t"),
}


def same(found: Measured) -> None:
    assert found.kind == "length"
    for track, t, x in zip(found.tracks, (T, T), (A, B), strict=True):
        assert track.t == pytest.approx(t, abs=2e-9)
        assert track.value == pytest.approx(x, abs=2e-9)


@pytest.mark.parametrize("name", VARIANTS)
def test_every_way_of_writing_gives_the_same_readings(name: str) -> None:
    same(read_measured([VARIANTS[name]]))


def test_two_files_with_a_track_each_are_two_carts() -> None:
    one, two = (
        f"mass_{n}\nt\tx\ty\n"
        + "".join(f"{t:.9E}\t{v:.9E}\t0\n" for t, v in zip(T, x, strict=True))
        for n, x in (("A", A), ("B", B))
    )
    found = read_measured([two, one])
    same(found)
    assert found.names == ("mass A", "mass B")


def test_names_of_tracks_are_the_names_of_the_carts() -> None:
    assert read_measured([with_y()]).names == ("mass A", "mass B")
    assert read_measured([VARIANTS["CSV"]]).names == ("A", "B")


def test_a_logger_s_two_forces_are_two_sensors() -> None:
    for heads in (
        "Latest: Time (s)\tLatest: Force (N)\tLatest: Force 2 (N)\n",
        "Time (s) Run #1\tForce, A (N) Run #1\tForce, B (N) Run #1\n",
    ):
        assert read_measured([heads + rows("\t")]).kind == "force"


def test_utf_16_is_read_by_its_mark() -> None:
    same(read_measured([decoded(PLAIN.encode("utf-16"))]))


def test_units_of_the_file_are_taken_before_the_readers() -> None:
    text = "t (ms);x_A (cm);x_B (cm)\n" + "".join(
        f"{1e3 * t:.9f};{1e2 * a:.9f};{1e2 * b:.9f}\n" for t, a, b in zip(T, A, B, strict=True)
    )
    same(read_measured([text], Units(time="s", length="mm")))
    found = read_measured(["t;x_A;x_B\n" + rows(";")], Units(time="ms", length="cm"))
    assert found.tracks[0].t[-1] == pytest.approx(T[-1] / 1e3)
    assert found.tracks[1].value[0] == pytest.approx(B[0] / 1e2)
    assert "x in cm (as you say)" in found.notes


def test_columns_of_unequal_length_keep_what_each_cart_has() -> None:
    lines = PLAIN.splitlines()
    for k in range(20, len(lines)):
        cells = lines[k].split("\t")
        lines[k] = "\t".join([*cells[:3], "", "", ""])
    found = read_measured(["\n".join(lines)])
    assert len(found.tracks[0].t) == len(T)
    assert len(found.tracks[1].t) == 17


def test_two_force_columns_are_two_sensors() -> None:
    text = "t (s);F_A (N);F_B (N)\n" + rows(";")
    found = read_measured([text])
    assert found.kind == "force"
    assert found.names == ("A", "B")


HEAD = "t\tx_A\tx_B\n"
GOOD = rows("\t").splitlines()


def body(change: dict[int, str]) -> str:
    return HEAD + "\n".join(change.get(k, line) for k, line in enumerate(GOOD)) + "\n"


REFUSED = {
    "nothing": ("", 1, "nothing in it"),
    "words only": ("hello\nworld\n", 1, "no row of numbers"),
    "one frame": (HEAD + GOOD[0], 2, "1 readings of “A”: at least 8"),
    "a word": (body({3: "0.1\tnear\t0.2"}), 5, "“near” is not a number"),
    "a unit in a cell": (body({3: "0.1\t0.3 m\t0.2"}), 5, "a unit stands in a cell"),
    "the same time twice": (body({4: GOOD[3]}), 6, "stands in line 5 already"),
    "time goes back": (body({4: "0.01\t0.5\t0.9"}), 6, "the time goes back"),
    "a reading without time": (body({4: "\t0.5\t0.9"}), 6, "no time"),
    "two decimal signs": (body({9: GOOD[9].replace(".", ",")}), 11, "another decimal sign"),
    "too many cells": (body({2: "0.1\t1\t2\t3"}), 4, "4 cells under 3 heads"),
    "mixed units": (
        "t\tx_A (cm)\tx_B\n" + rows("\t"), 1, "one column names its unit and the other does not"
    ),
    "a wrong unit": ("t\tx_A (kg)\tx_B (kg)\n" + rows("\t"), 1, "“kg” is not a unit of length"),
    "three carts": (
        "t\tx_A\tx_B\tx_C\n" + rows("\t", tail="\t1"), 1, "3 carts"
    ),
    "one cart": ("t\tx_A\n" + "".join(f"{t}\t{a}\n" for t, a in zip(T, A, strict=True)),
                 len(T) + 1, "readings of 1 carts"),
    "no such columns": ("t\ta\tb\tc\n1\t2\t3\t4\n2\t3\t4\t5\n", 1, "no column holds positions"),
    "frames in the place of time": ("frame\tx_A\tx_B\n" + rows("\t"), 1, "counts frames"),
    "four numbers, no heads": ("1\t2\t3\t4\n2\t3\t4\t5\n", 1, "no line that names them"),
    "decimal commas between commas": (
        "t,x_A,x_B\n" + "".join(f"0,{k},0,{k},0,{k}\n" for k in range(100, 120)), 2, "comma"
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
        decoded(b"t\tx\n1\t2\n\xff\xfe\x80")
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
