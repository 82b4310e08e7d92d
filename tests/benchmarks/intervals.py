"""Do the printed intervals hold the truth where residuals are not white? A study, not a test.

    python -m tests.benchmarks.intervals [--count N] [--first SEED] [--real FOLDER [--rate HZ ...]]
                                          [KIND ...]

Kinds: white, chain-0.5, chain-0.8, chain-0.95 (AR(1) of 1 mm), wander (two slow sines beside white
noise), film-raw, film-20, film-8 (drawn frame by frame, H.264 with that crf, followed by the page's
own code). `--real`: weighed runs of motion capture, with their `weights.tsv`; they are not shipped.
`--rate`: with so few readings a second, from PHASES first readings each.
Followed films are kept in build/films, as following them takes most of the time.
"""

from __future__ import annotations

import argparse
import csv
import io
import math
import statistics
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.measured.analysis import Wanted, analysed
from sim.measured.tracks import Measured, read_measured
from tests.film.collision import uneven
from tests.film.following import follow
from tests.film.maker import Stage, encoded, frames
from tests.measured.makers import NOISE, Truth, film, random_truth

ROOT = Path(__file__).parents[2]
CHAINS = {"chain-0.5": 0.5, "chain-0.8": 0.8, "chain-0.95": 0.95}
KINDS = ("white", *CHAINS, "wander", "film-raw", "film-20", "film-8")
STAGE = Stage(noise=3.0)
RATE = 30.0  # frames per second of the made films, uneven
PHASES = 5
SLOWEST = 0.25
"""Longest sine of the wander, as a share of the recording; the shortest is a tenth."""


def chain(count: int, rho: float, random: np.random.Generator) -> NDArray[np.float64]:
    """AR(1) of standard deviation 1."""
    steps = random.normal(size=count)
    out = np.empty(count)
    out[0] = steps[0]
    for k in range(1, count):
        out[k] = rho * out[k - 1] + math.sqrt(1.0 - rho * rho) * steps[k]
    return out


def wander(t: NDArray[np.float64], random: np.random.Generator) -> NDArray[np.float64]:
    """Two slow sines of random length and phase, with white noise of the same size."""
    whole = t[-1] - t[0]
    lengths = whole * random.uniform(0.1, SLOWEST, 2)
    phases = random.uniform(0.0, 2.0 * math.pi, 2)
    slow = sum(np.sin(2.0 * math.pi * t / one + p) for one, p in zip(lengths, phases, strict=True))
    return np.asarray((slow + random.normal(size=len(t))) / math.sqrt(2.0))


def troubled(kind: str, seed: int) -> tuple[Truth, Measured]:
    """A random collision whose readings have 1 mm of this kind of noise."""
    made, rate = random_truth(seed)
    if kind == "white":
        return made, film(made, rate, seed=seed)
    plain = film(made, rate, noise=0.0)
    random = np.random.default_rng(10_000 + seed)
    tracks = []
    for track in plain.tracks:
        t = np.array(track.t)
        off = wander(t, random) if kind == "wander" else chain(len(t), CHAINS[kind], random)
        tracks.append(replace(track, value=tuple(map(float, np.array(track.value) + NOISE * off))))
    return made, replace(plain, tracks=(tracks[0], tracks[1]))


def followed(kind: str, seed: int) -> tuple[Truth, Measured]:
    """A random collision, filmed, compressed and followed."""
    made, _ = random_truth(seed)
    kept = ROOT / "build" / "films" / f"{kind}-{seed}.csv"
    if not kept.exists():
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_text(_text(made, kind, seed), encoding="utf-8")
    return made, read_measured([kept.read_text(encoding="utf-8")])


def _text(made: Truth, kind: str, seed: int) -> str:
    import av

    times = uneven(made.scene.until, RATE, seed)
    finished = run(made.scene)
    rows = np.array([sample(finished, float(t))[0] for t in times]) - 0.3  # m, into the picture
    motion = [rows[:, 0], rows[:, 1]]
    pictures = list(frames(STAGE, times, motion, seed))
    if kind != "film-raw":
        content = encoded(
            iter(pictures), times, STAGE, codec="libx264", kind="mp4",
            options={"preset": "medium", "crf": kind.removeprefix("film-")},
        )  # fmt: skip
        with av.open(io.BytesIO(content)) as read:
            pictures = [one.to_ndarray(format="rgb24") for one in read.decode(video=0)]
    clicks = [STAGE.place(float(x[0])) for x in motion]
    return follow(STAGE, pictures, times, clicks).text


def truths(made: Truth) -> dict[str, float]:
    """What a report should say."""
    (a, b), q = made.v, made.ratio
    both, after = (a + q * b) / (1.0 + q), made.e * (a - b) / (1.0 + q)
    return {
        "mass_ratio": q, "e": made.e, "v_a": a, "v_b": b,
        "v_a_after": both - q * after, "v_b_after": both + after,
        "touch": made.touch, "w0": made.w0,
    }  # fmt: skip


class Count:
    """How often an interval held the truth, and how wide it was."""

    def __init__(self) -> None:
        self.inside: dict[str, list[bool]] = {}
        self.halves: list[float] = []
        self.off: list[float] = []
        self.refused: list[str] = []
        self.by_model = 0

    def take(self, told: dict[str, Any], wanted: dict[str, float], real: bool = False) -> None:
        if "refused" in told:
            self.refused.append(told["refused"]["code"])
            return
        self.by_model += "w0" in {one["key"] for one in told["known"]}
        for one in told["known"]:
            key = one["key"]
            if key not in wanted or (key == "touch" and one["name"].startswith("middle")):
                continue
            # Films of the simulator have no friction in the contact: the readings' part is tried.
            low, high = (None if real else one.get("alone")) or (one["low"], one["high"])
            inside = low <= wanted[key] <= high
            self.inside.setdefault(key, []).append(inside)
            if key == "mass_ratio":
                self.halves.append(0.5 * (high - low) / one["value"])
                self.off.append(abs(one["value"] / wanted[key] - 1.0))

    def text(self, kind: str) -> str:
        shares = " ".join(
            f"{key} {100 * sum(held) / len(held):.1f}" for key, held in self.inside.items()
        )
        half = 100 * statistics.median(self.halves) if self.halves else math.nan
        off = 100 * statistics.median(self.off) if self.off else math.nan
        return (
            f"{kind:11s} {len(self.halves):3d} ratios, {len(self.refused)} refused, "
            f"{self.by_model} by the model, half {half:.3f} %, off {off:.3f} %; inside: {shares}"
        )


def study(kind: str, seeds: range) -> str:
    """One line for one kind of noise."""
    found = Count()
    make = followed if kind.startswith("film") else troubled
    for seed in seeds:
        made, measured = make(kind, seed)
        found.take(analysed(measured, Wanted(every=False)).report, truths(made))
    return found.text(kind)


def weighed(folder: Path) -> Iterator[tuple[str, float, Measured]]:
    """Runs of motion capture named PREFIX-N.tsv and the ratio of the balance, B ÷ A."""
    with (folder / "weights.tsv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file, delimiter="\t"))
    for path in sorted(folder.glob("*-*.tsv")):
        masses = {
            row["marker_name"]: float(row["weight_kg"])
            for row in rows
            if row["prefix"] == path.stem.split("-")[0]
        }
        measured = read_measured([path.read_text(encoding="utf-8")])
        first, second = (masses[name] for name in measured.names)
        yield path.stem, second / first, measured


def study_real(folder: Path) -> str:
    """The same for weighed runs."""
    found = Count()
    for name, ratio, measured in weighed(folder):
        told = analysed(measured, Wanted(every=False)).report
        row = {one["key"]: one for one in told["known"]}.get("mass_ratio")
        said = row["text"] if row else told.get("refused", {}).get("code", "open")
        print(f"  {name}: {told['outcome']}, balance {ratio:.4f}, {said}")
        found.take(told, {"mass_ratio": ratio}, real=True)
    return found.text("real")


def study_thinned(folder: Path, rate: float) -> str:
    """The same with `rate` readings a second."""
    found = Count()
    for _, ratio, measured in weighed(folder):
        for phase in range(PHASES):
            told = analysed(thinned(measured, rate, phase / PHASES), Wanted(every=False)).report
            found.take(told, {"mass_ratio": ratio}, real=True)
    return found.text(f"real {rate:g} Hz")


def thinned(measured: Measured, rate: float, phase: float) -> Measured:
    """One reading of several, so that `rate` a second are left; `phase`: which, from 0 to 1."""
    times = measured.tracks[0].t
    step = max(1, round((len(times) - 1) / (times[-1] - times[0]) / rate))
    kept = slice(int(phase * step), None, step)
    first, second = (
        replace(one, t=one.t[kept], value=one.value[kept], lines=one.lines[kept])
        for one in measured.tracks
    )
    return replace(measured, tracks=(first, second))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kinds", nargs="*", metavar="KIND")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--real", type=Path)
    parser.add_argument("--rate", type=float, nargs="+", default=[])
    chosen = parser.parse_args()
    for kind in chosen.kinds or (() if chosen.real else KINDS):
        print(study(kind, range(chosen.first, chosen.first + chosen.count)), flush=True)
    for rate in chosen.rate:
        print(study_thinned(chosen.real, rate), flush=True)
    if chosen.real and not chosen.rate:
        print(study_real(chosen.real))


if __name__ == "__main__":
    main()
