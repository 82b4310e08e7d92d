"""Certificates of random scenes against forty digits: how many are proved, why the others are not.

    make fuzz AREA=certificates     or     python -m tests.certify [--scenes 10000] [--from 0]

Ends with 1 if one certificate misses. A scene takes about a tenth of a second; one that takes
`MOST_SECONDS` is given up and counted apart, neither held nor missed.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections import Counter
from pathlib import Path
from typing import Any

from sim.certify.certificate import certify, document
from sim.scene import SceneError, read_scene
from tests.certify.budget import MOST_SECONDS, OutOfTimeError, limited
from tests.certify.held import misses
from tests.certify.random_scenes import plain, swinging, touching
from tests.reference.digit_pairs import UnsupportedError

MAKE = {"plain": plain, "rows": touching, "springs": swinging}


def verdict(written: dict[str, Any]) -> tuple[str, list[str]]:
    """One word or sentence for a scene, and what its certificate misses."""
    try:
        scene = read_scene(written)
    except SceneError:
        return "no scene", []
    at_work = "certificate"
    try:
        with limited():
            found = document(certify(scene))
            if not found["final"]["x"]:
                return "no certificate: " + _named_apart(found["reason"]), []
            at_work = "oracle"
            missed = misses(scene, found)
    except OutOfTimeError:
        return f"given up: the {at_work} took {MOST_SECONDS:.0f} s", []
    except UnsupportedError:
        return "certified, and the oracle cannot tell", []
    if missed:
        return "MISSED", missed
    return ("held" if found["order"] == "proved" else "held, order not proved"), []


def _named_apart(reason: str) -> str:
    """The reason without names of carts: the same for all scenes that have it."""
    return re.sub(r"\b([A-F]|left|right)\b", "…", reason)


def kind(seed: int, given: argparse.Namespace) -> str:
    """Which scenes: of ten, six are plain, two rows, two have springs."""
    if given.rows or given.springs:
        return "rows" if given.rows else "springs"
    return ("plain", "rows", "plain", "springs", "plain")[seed % 5]


def known(path: Path | None) -> dict[int, str]:
    """What an earlier run found, by number of the scene."""
    if path is None or not path.exists():
        return {}
    rows = (line.split(" ", 1) for line in path.read_text().splitlines())
    return {int(seed): word for seed, word in rows}


def main() -> int:
    """0 if none misses."""
    asked = argparse.ArgumentParser(prog="tests.certify", description=__doc__)
    asked.add_argument("--scenes", type=int, default=10_000)
    asked.add_argument("--from", dest="first", type=int, default=0, help="number of the first")
    asked.add_argument("--rows", action="store_true", help="three and more carts at once")
    asked.add_argument("--springs", action="store_true", help="springs and linear drag")
    asked.add_argument("--kept", type=Path, help="file of what is done; a second run goes on there")
    given = asked.parse_args()
    done = known(given.kept)
    seen: Counter[str] = Counter(done.values())
    for seed in range(given.first, given.first + given.scenes):
        if seed in done:
            continue
        written = MAKE[kind(seed, given)](seed)
        word, missed = verdict(written)
        seen[word] += 1
        if missed:
            print(f"{seed}: {missed}\n  {json.dumps(written)}", flush=True)
        if given.kept:
            with given.kept.open("a") as kept:
                kept.write(f"{seed} {word}\n")
    for word, count in seen.most_common():
        print(f"{count:7}  {word}")
    return 1 if seen["MISSED"] else 0


if __name__ == "__main__":
    sys.exit(main())
