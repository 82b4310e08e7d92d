"""Certificates of random scenes against forty digits: how many are proved, why the others are not.

    make fuzz AREA=certificates     or     python -m tests.certify [--scenes 10000] [--from 0]

Ends with 1 if one certificate misses. A scene takes about a tenth of a second; one that takes
`MOST_SECONDS` is given up and counted apart, neither held nor missed. Of pairs the median width is
said, in doubles.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median
from typing import Any

from sim.certify.certificate import certify, document
from sim.scene import SceneError, read_scene
from tests.certify.held import misses, widths
from tests.certify.random_scenes import (
    letting_go,
    letting_go_from_rest,
    plain,
    swinging,
    touching,
)
from tests.processor_time import TooSlowError, budget
from tests.reference.digit_pairs import UnsupportedError

MAKE = {
    "plain": plain,
    "rows": touching,
    "springs": swinging,
    "releases": letting_go,
    "rough": letting_go_from_rest,
}


@dataclass(frozen=True, slots=True)
class Verdict:
    """One word or sentence for a scene, what its certificate misses, and how wide that is."""

    word: str
    missed: list[str] = field(default_factory=list)
    widths: list[float] = field(default_factory=list)  # in doubles, of a pair


MOST_SECONDS = 20.0
"""CPU-seconds. A scene takes a tenth of a second; a hundred times that is one whose equations blow
up in the oracle's forty digits, not a slow machine."""


def verdict(written: dict[str, Any]) -> Verdict:
    """Of a scene as it is written."""
    try:
        scene = read_scene(written)
    except SceneError:
        return Verdict("no scene")
    at_work = "certificate"
    try:
        with budget(MOST_SECONDS):
            found = document(certify(scene))
            if not found["final"]["x"]:
                return Verdict("no certificate: " + _named_apart(found["reason"]))
            at_work = "oracle"
            missed = misses(scene, found)
    except TooSlowError:
        return Verdict(f"given up: the {at_work} took {MOST_SECONDS:.0f} s")
    except UnsupportedError:
        return Verdict("certified, and the oracle cannot tell")
    if missed:
        return Verdict("MISSED", missed)
    proved = found["order"] == "proved"
    pair = len(scene.carts) == 2
    return Verdict(
        "held" if proved else "held, order not proved", [], widths(found) if pair else []
    )


def _named_apart(reason: str) -> str:
    """The reason without names of carts: the same for all scenes that have it."""
    return re.sub(r"\b([A-F]|left|right)\b", "…", reason)


def kind(seed: int, given: argparse.Namespace) -> str:
    """Which scenes: of ten, six are plain, two rows, two have springs."""
    asked = [one for one in ("rows", "springs", "releases", "rough") if getattr(given, one)]
    if asked:
        return asked[0]
    return ("plain", "rows", "plain", "springs", "plain")[seed % 5]


def known(path: Path | None) -> dict[int, Verdict]:
    """What an earlier run found, by number of the scene."""
    if path is None or not path.exists():
        return {}
    rows = (json.loads(line) for line in path.read_text().splitlines())
    return {seed: Verdict(word, [], wide) for seed, word, wide in rows}


def main() -> int:
    """0 if none misses."""
    asked = argparse.ArgumentParser(prog="tests.certify", description=__doc__)
    asked.add_argument("--scenes", type=int, default=10_000)
    asked.add_argument("--from", dest="first", type=int, default=0, help="number of the first")
    asked.add_argument("--rows", action="store_true", help="three and more carts at once")
    asked.add_argument("--springs", action="store_true", help="springs and linear drag")
    asked.add_argument("--releases", action="store_true", help="exploders")
    asked.add_argument("--rough", action="store_true", help="exploders, where friction holds")
    asked.add_argument("--kept", type=Path, help="file of what is done; a second run goes on there")
    given = asked.parse_args()
    done = known(given.kept)
    for seed in range(given.first, given.first + given.scenes):
        if seed in done:
            continue
        written = MAKE[kind(seed, given)](seed)
        one = done[seed] = verdict(written)
        if one.missed:
            print(f"{seed}: {one.missed}\n  {json.dumps(written)}", flush=True)
        if given.kept:
            with given.kept.open("a") as kept:
                kept.write(json.dumps([seed, one.word, one.widths]) + "\n")
    seen = Counter(one.word for one in done.values())
    for word, count in seen.most_common():
        print(f"{count:7}  {word}")
    wide = [width for one in done.values() for width in one.widths]
    if wide:
        print(
            f"pairs: the bounds of {len(wide)} numbers are {median(wide):.1f} doubles apart "
            f"(median), nine of ten within {sorted(wide)[9 * len(wide) // 10]:.1f}"
        )
    return 1 if seen["MISSED"] else 0


if __name__ == "__main__":
    sys.exit(main())
