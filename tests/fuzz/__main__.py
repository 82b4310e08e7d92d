"""The adversary of the physics: random scenes of all kinds, each with a budget, and an oracle.

    make fuzz AREA=physics          or     python -m tests.fuzz [--scenes 40] [--from 0] [--kind …]

Prints a table, kind by kind, and the plainest scene of everything that went wrong.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter

from tests.fuzz.kinds import KINDS, scene_of
from tests.fuzz.shrink import plainest
from tests.fuzz.verdict import BUDGET, GOOD, judge

WORDS = (
    "right",
    "unknown",
    "refused",
    "no scene",
    "crash",
    "slow",
    "many",
    "account",
    "end",
    "mirror",
    "scale",
)


SLOW = (0.2, 1.0)
"""s of processor time: how many runs take longer is a column each."""


def main() -> int:
    """0 if nothing went wrong."""
    asked = argparse.ArgumentParser(prog="tests.fuzz", description=__doc__)
    asked.add_argument("--scenes", type=int, default=40, help="of each kind")
    asked.add_argument("--from", dest="first", type=int, default=0, help="number of the first")
    asked.add_argument("--kind", action="append", choices=list(KINDS))
    asked.add_argument("--no-oracle", action="store_true", help="crashes, time, accounts only")
    asked.add_argument("--no-shrink", action="store_true")
    asked.add_argument("--seconds", type=float, default=BUDGET, help="of processor time per run")
    given = asked.parse_args()
    above = "".join(f"{f'> {limit:g} s':>9}" for limit in SLOW)
    print(f"{'kind':18}" + "".join(f"{w:>9}" for w in WORDS) + above + f"{'slowest s':>11}")
    total: Counter[str] = Counter()
    wrong = []
    for kind in given.kind or KINDS:
        seen: Counter[str] = Counter()
        times = []
        for seed in range(given.first, given.first + given.scenes):
            plain = scene_of(kind, seed)
            begun = time.process_time()
            found = judge(plain, oracle=False, seconds=given.seconds)
            times.append(time.process_time() - begun)
            if found.word == "unknown" and not given.no_oracle:
                found = judge(plain, seconds=given.seconds)
            seen[found.word] += 1
            if found.word not in GOOD:
                wrong.append((kind, seed, plain, found))
        seen.update({f"> {limit:g}": sum(t > limit for t in times) for limit in SLOW})
        print(f"{kind:18}" + _columns(seen) + f"{max(times, default=0.0):11.2f}", flush=True)
        total += seen
    print(f"{'all':18}" + _columns(total))
    for kind, seed, plain, found in wrong:
        small = plain if given.no_shrink else plainest(plain, found)
        print(f"\n{kind} {seed}: {found.word} {found.detail}\n  {json.dumps(small)}", flush=True)
    return 1 if wrong else 0


def _columns(seen: Counter[str]) -> str:
    return "".join(f"{seen[word]:9}" for word in (*WORDS, *(f"> {limit:g}" for limit in SLOW)))


if __name__ == "__main__":
    sys.exit(main())
