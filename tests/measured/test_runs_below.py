"""Runs below each other, each under heads or a name of its own; thousands and missing readings."""

from __future__ import annotations

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from sim.measured.units import Units
from tests.measured.devices import Motion, sensor_carts
from tests.measured.force_sensors import sensors
from tests.measured.written_films import A, B, T

HEADS = "Time (s)\tPosition 1 (m)\tPosition 2 (m)"
FIGURES = "Mean\t0.8\t0.5\t0.9\nStd. Dev.\t0.4\t0.1\t0.1"


def forces(seed: int) -> str:
    a, b = sensors(seed=seed).tracks
    rows = zip(a.t, a.value, b.value, strict=True)
    lines = (f"{t:.3f},{one:.3f},{other:.3f}" for t, one, other in rows)
    return "\n".join(["Time (s),Force 1 (N),Force 2 (N)", *lines])


def film(shift: float = 0.0) -> str:
    return "\n".join(
        f"{t:.4f}\t{a + shift:.5f}\t{b + shift:.5f}" for t, a, b in zip(T, A, B, strict=True)
    )


ONE, TWO = film(), film(0.25)
BELOW = {
    "heads repeated": (f"{HEADS}\n{ONE}\n{HEADS}\n{TWO}", ("1", "2")),
    "heads under names": (f"Run 3\n{HEADS}\n{ONE}\n\nRun 7\n{HEADS}\n{TWO}", ("3", "7")),
    "names alone": (f"{HEADS}\nMessung #1\n{ONE}\nMessung #2\n{TWO}", ("1", "2")),
    "one name for both": (f"Run 3\n{HEADS}\n{ONE}\nRun 3\n{TWO}", ("1", "2")),
    "figures of each": (f"{HEADS}\n{ONE}\n{FIGURES}\n{HEADS}\n{TWO}\n{FIGURES}", ("1", "2")),
    "a title of figures": (f"{HEADS}\n{ONE}\nStatistics\n{FIGURES}\n{HEADS}\n{TWO}", ("1", "2")),
}  # fmt: skip


@pytest.mark.parametrize("how", BELOW)
def test_of_runs_below_each_other_the_one_that_is_asked_for_is_read(how: str) -> None:
    text, runs = BELOW[how]
    for place, (run, shift) in enumerate(zip(runs, (0.0, 0.25), strict=True), 1):
        for asked in dict.fromkeys((run, str(place))):
            found = read_measured([text], Units(run=asked))
            assert found.runs == runs
            assert found.tracks[0].value == pytest.approx([a + shift for a in A], abs=1e-5)
            assert found.tracks[0].t == pytest.approx(T, abs=1e-4)
    first = read_measured([text])
    assert f"run {runs[0]} is read; other runs in the file: {runs[1]}" in first.notes
    with pytest.raises(ReadingError, match="there is no run 9: this file has 2"):
        read_measured([text], Units(run="9"))


def test_a_first_run_that_was_stopped_at_once_is_passed_over() -> None:
    stopped = "\n".join(ONE.splitlines()[:5])
    found = read_measured([f"{HEADS}\n{stopped}\n{HEADS}\n{TWO}"])
    assert found.tracks[0].value == pytest.approx([a + 0.25 for a in A], abs=1e-5)
    assert "run 2 is read; other runs in the file: 1" in found.notes


def test_a_fault_in_a_later_run_is_told_with_its_line() -> None:
    text = f"{HEADS}\n{ONE}\n{HEADS}\n{TWO.replace(TWO.split()[1], 'near', 1)}"
    with pytest.raises(ReadingError) as caught:
        read_measured([text])
    assert caught.value.faults[0].line == len(ONE.splitlines()) + 3
    assert "“near” is not a number" in caught.value.faults[0].reason


def test_words_below_the_readings_that_are_no_heads_are_refused() -> None:
    with pytest.raises(ReadingError, match="“it bounced” is not a number"):
        read_measured([f"{HEADS}\n{ONE}\nit bounced\n{TWO}"])


def test_logs_with_velocities_and_of_forces_stand_below_each_other_too() -> None:
    logs = [sensor_carts(Motion(), seed=k).removeprefix("\ufeff") for k in (1, 2)]
    for texts in (logs, [forces(k) for k in (1, 2)]):
        found = read_measured(["\n".join(texts)], Units(run="2"))
        alone = read_measured([texts[1]])
        assert found.runs == ("1", "2")
        assert [one.value for one in found.tracks] == [one.value for one in alone.tracks]


@pytest.mark.parametrize(
    "written",
    ["1'850.2", "1’850.2", "1 850.2", "1\u202f850.2", "1,850.2", "1.850,2", "+1 850.2", "1850.2"],
)
def test_thousands_are_read_where_what_parts_them_is_certain(written: str) -> None:
    comma = written.endswith(",2")
    rows = [
        f"{k / 20};{500 + k}.5;{written}".replace(".5;", ",5;" if comma else ".5;")
        for k in range(9)
    ]
    rows = [row.replace(f"{k / 20}", f"{k / 20}".replace(".", ","), 1) if comma else row
            for k, row in enumerate(rows)]  # fmt: skip
    found = read_measured(["\n".join(["t;x_A (mm);x_B (mm)", *rows])])
    assert found.tracks[1].value[0] == pytest.approx(1.8502)


@pytest.mark.parametrize("cell", ["#N/A", "#NV", "--", "?", "n.a.", "NaN", "—"])
def test_a_reading_that_is_missing_is_left_out_however_that_is_written(cell: str) -> None:
    lines = ONE.splitlines()
    t, _, b = lines[5].split("\t")
    lines[5] = f"{t}\t{cell}\t{b}"
    found = read_measured(["\n".join([HEADS, *lines])])
    assert [len(track.t) for track in found.tracks] == [len(T) - 1, len(T)]
