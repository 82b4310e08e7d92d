"""The readings of the lesson `real-carts`: generated, so that the truth is known.

    python -m sim.measured.lesson_set FOLDER

A film of two carts on a track with rolling friction, 60 frames per second, each place with a noise
of 1 mm, as Tracker exports it (TRUTH); and two force sensors, 1000 readings per second, each with a
noise of 0.05 N and a zero that is a little off, in the bump that the lesson's scene shows (BUMP).
"""

from __future__ import annotations

import sys
from pathlib import Path
from random import Random
from typing import Any

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import Trajectory, trajectory
from sim.measured.as_tracker import tracker_text
from sim.measured.synthetic import filmed
from sim.scene import read_scene

TRUTH: dict[str, Any] = {
    "carts": {
        "A": {"mass": "0.520 kg", "position": "0.35 m", "velocity": "0.72 m/s"},
        "B": {"mass": "1.036 kg", "position": "0.95 m", "velocity": 0},
    },
    "contact": {"restitution": "0.84", "stiffness": "260 N/m"},
    "effects": [{"friction": {"coefficient": "0.006"}}],
    "until": "1.6 s",
}
BUMP: dict[str, Any] = {
    "carts": {
        "A": {"mass": "0.520 kg", "position": "0.30 m", "velocity": "0.70 m/s", "length": "0.30 m"},
        "B": {"mass": "1.036 kg", "position": "0.95 m", "length": "0.30 m"},
    },
    "track": {"length": "1.6 m"},
    "contact": {"restitution": "0.7", "stiffness": "260 N/m"},
    "until": "1.5 s",
}
FILM, FORCES = "real-carts.txt", "real-carts-forces.csv"
FRAMES, NOISE, CLOCK = 60.0, 1e-3, 2.35  # 1/s, m, and s on the film when the scene begins
READINGS, FORCE_NOISE, ZEROS = 1000.0, 0.05, (0.06, -0.04)  # 1/s, N, N


def film() -> str:
    """The film as Tracker exports it."""
    made = filmed(read_scene(TRUTH), rate=FRAMES, noise=NOISE, seed=2026, begin=CLOCK)
    names = [f"cart_{track.name}" for track in made.tracks]
    return tracker_text(names, made.tracks[0].t, [track.value for track in made.tracks])


def forces() -> str:
    """The sensors' log: the force on each cart by the other, + to the right."""
    finished, random = run(read_scene(BUMP)), Random(2027)
    samples = trajectory(finished, 64)
    pushed = zip(samples.columns[("t",)], samples.columns[("F", "A-B")], strict=True)
    begin = next(t for t, force in pushed if force > 0.0) - 0.12
    lines = ["t (s);F_A (N);F_B (N)"]
    for k in range(400):
        force = _force(samples, begin + k / READINGS)
        a = -force + ZEROS[0] + random.gauss(0.0, FORCE_NOISE)
        b = force + ZEROS[1] + random.gauss(0.0, FORCE_NOISE)
        lines.append(f"{k / READINGS:.3f};{a:.3f};{b:.3f}")
    return "\n".join(lines) + "\n"


def _force(samples: Trajectory, t: float) -> float:
    """N. Size of the contact force at time t: straight lines between dense samples."""
    times, values = samples.columns[("t",)], samples.columns[("F", "A-B")]
    for k in range(len(times) - 1):
        if times[k] <= t < times[k + 1]:
            share = (t - times[k]) / (times[k + 1] - times[k])
            return values[k] + share * (values[k + 1] - values[k])
    return 0.0


def write(folder: Path) -> None:
    """Both files into `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in ((FILM, film()), (FORCES, forces())):
        (folder / name).write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    write(Path(sys.argv[1]))
