"""Certificates of random scenes against forty digits: how many are proved, why the others are not.

    make fuzz AREA=certificates     or     python -m tests.certify [--scenes 10000] [--from 0]

Ends with 1 if one certificate misses. A scene takes about a second: the oracle has its time.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections import Counter
from typing import Any

from sim.certify.certificate import certify, document
from sim.scene import SceneError, read_scene
from tests.certify.held import misses
from tests.certify.random_scenes import plain, swinging, touching
from tests.reference.digit_pairs import UnsupportedError


def verdict(written: dict[str, Any]) -> tuple[str, list[str]]:
    """One word or sentence for a scene, and what its certificate misses."""
    try:
        scene = read_scene(written)
    except SceneError:
        return "no scene", []
    found = document(certify(scene))
    if not found["final"]["x"]:
        return "no certificate: " + re.sub(r"\b([A-F]|left|right)\b", "…", found["reason"]), []
    try:
        missed = misses(scene, found)
    except UnsupportedError:
        return "certified, and the oracle cannot tell", []
    if missed:
        return "MISSED", missed
    return ("held" if found["order"] == "proved" else "held, order not proved"), []


def main() -> int:
    """0 if none misses."""
    asked = argparse.ArgumentParser(prog="tests.certify", description=__doc__)
    asked.add_argument("--scenes", type=int, default=10_000)
    asked.add_argument("--from", dest="first", type=int, default=0, help="number of the first")
    asked.add_argument("--rows", action="store_true", help="three and more carts at once")
    asked.add_argument("--springs", action="store_true", help="springs and linear drag")
    given = asked.parse_args()
    make = touching if given.rows else swinging if given.springs else plain
    seen: Counter[str] = Counter()
    for seed in range(given.first, given.first + given.scenes):
        word, missed = verdict(make(seed))
        seen[word] += 1
        if missed:
            print(f"{seed}: {missed}\n  {json.dumps(make(seed))}", flush=True)
    for word, count in seen.most_common():
        print(f"{count:7}  {word}")
    return 1 if seen["MISSED"] else 0


if __name__ == "__main__":
    sys.exit(main())
