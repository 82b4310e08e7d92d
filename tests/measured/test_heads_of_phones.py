"""Accelerations of a phone are read in any language, by their unit and their axis."""

from __future__ import annotations

import math

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured

TIMES = [k / 100 for k in range(100)]
ENGLISH = "Time (s),Linear Acceleration x (m/s^2),Linear Acceleration y (m/s^2)"
OTHERS = {
    "German": "Zeit (s),Lineare Beschleunigung x (m/s^2),Lineare Beschleunigung y (m/s^2)",
    "French": "Temps (s),Accélération linéaire x (m/s^2),Accélération linéaire y (m/s^2)",
    "Chinese": "时间 (s),线性加速度 x (m/s²),线性加速度 y (m/s²)",
    "letters": "t (s),a_x (m/s²),a_y (m/s²)",
}


def phone(heads: str, sign: float = 1.0) -> str:
    pushes = (sign * 3.0 * math.exp(-(((t - 0.5) / 0.05) ** 2)) for t in TIMES)
    rows = (f"{t:.3f},{a:.5f},{0.01 * math.sin(40.0 * t):.5f}"
            for t, a in zip(TIMES, pushes, strict=True))  # fmt: skip
    return "\n".join([heads, *rows])


@pytest.mark.parametrize("heads", OTHERS.values(), ids=OTHERS)
def test_a_phone_that_speaks_another_language_is_read_as_an_english_one(heads: str) -> None:
    english = read_measured([phone(ENGLISH), phone(ENGLISH, -0.5)])
    found = read_measured([phone(heads), phone(heads, -0.5)])
    assert found.kind == "acceleration"
    assert found.tracks == english.tracks and found.notes == english.notes


@pytest.mark.parametrize("word", ["Beschleunigung", "Accélération", "Acceleration"])
def test_accelerations_of_carts_are_called_so_and_not_to_be_renamed(word: str) -> None:
    rows = (f"{t:.3f},{t * t:.5f},{-t:.5f}" for t in TIMES)
    text = "\n".join([f"t (s),{word} A (m/s²),{word} B (m/s²)", *rows])
    with pytest.raises(ReadingError) as caught:
        read_measured([text])
    (fault,) = caught.value.faults
    assert "is an acceleration" in fault.reason and "x_A" not in fault.hint
