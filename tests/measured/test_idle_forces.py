"""Smart carts write positions and forces: those that tell something are read."""

from __future__ import annotations

import random

import pytest

from sim.measured.readers.plain import read
from sim.measured.units import Units

HEADS = "Time (s),Position 1 (m),Force 1 (N),Position 2 (m),Force 2 (N)"


def log(push: float, *, step: float = 0.0) -> str:
    """A second at 50 Hz; the sensors push for five readings with `push` in N."""
    dice = random.Random(4)
    lines = [HEADS]
    for k in range(50):
        force = [dice.gauss(0, 0.01) + (push if 20 <= k < 25 else 0.0) for _ in range(2)]
        force = [round(one / step) * step for one in force] if step else force
        x = 0.2 + 0.008 * k
        lines.append(f"{k / 50:.2f},{x:.4f},{force[0]:.4f},0.9000,{force[1]:.4f}")
    return "\n".join(lines)


@pytest.mark.parametrize("step", [0.0, 0.01])
def test_positions_are_read_where_the_force_sensors_show_no_push(step: float) -> None:
    reading = read(log(0.0, step=step), Units())
    assert reading.kind == "length"
    assert "positions were read: the force sensors show no push" in reading.notes


@pytest.mark.parametrize("step", [0.0, 0.01, 0.5])
def test_forces_that_show_a_push_are_read_and_the_reader_is_told(step: float) -> None:
    reading = read(log(4.0, step=step), Units())
    assert reading.kind == "force"
    assert "forces were read, and positions left out" in reading.notes
