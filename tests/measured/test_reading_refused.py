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
from tests.measured.refused_texts import REFUSED, body
from tests.measured.written_films import PLAIN, VARIANTS, rows, with_y
from tests.web.scene.given.widget_site import in_node


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
