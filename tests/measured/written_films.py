"""One film in every writing that programs give to its readings."""

from __future__ import annotations

import pytest

from sim.measured.tracks import Measured
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
    "commas and decimal commas": decimal_comma(PLAIN).replace("\t", ","),
    "commas, decimal commas and real minus": decimal_comma(PLAIN.replace("-", "\u2212")).replace(
        "\t", ","
    ),
    "CSV with decimal commas": "t,x_A,x_B\n" + decimal_comma(rows(",", form="{:.9f}")),
    "CSV with decimal commas and spaces": "t, x_A, x_B\n"
    + decimal_comma(rows(";", form="{:.9f}")).replace(";", ", "),
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


def table(heads: str, size: float = 1.0, clock: float = 1.0) -> str:
    """The film below these heads, in units of `size` m and `clock` s."""
    rows = zip(T, A, B, strict=True)
    return "\n".join([heads, *(f"{t / clock:.9f},{a / size:.9f},{b / size:.9f}"
                               for t, a, b in rows)])  # fmt: skip


def is_the_film(found: Measured) -> bool:
    """Whether it was read as it is, whatever its clock began with."""
    wanted = pytest.approx([t - T[0] for t in T], abs=1e-6)
    return all(
        [t - track.t[0] for t in track.t] == wanted and track.value == pytest.approx(x, abs=1e-6)
        for track, x in zip(found.tracks, (A, B), strict=True)
    )
