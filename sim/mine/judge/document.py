"""A judgement as plain values, and back: for `carts law --json` and for the page."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from sim.mine.judge.as_yaml import as_yaml
from sim.mine.judge.checks import CHECKS
from sim.mine.judge.verdict import Judgement, Verdict
from sim.scene.said import from_wire, wire

FORMAT = 1


def document(judged: Judgement) -> dict[str, Any]:
    """Without NaN and Infinity: `amount` null where no steps lead to the end of a run."""
    return {
        "format": FORMAT,
        "law": judged.file,
        "holds": judged.holds,
        "sentence": judged.sentence,
        "scenes": judged.scenes,
        "calls": judged.calls,
        "seed": judged.seed,
        "verdicts": [
            {
                "check": one.check,
                "says": one.says,
                "holds": one.holds,
                "amount": one.amount if math.isfinite(one.amount) else None,
                "limit": one.limit,
                "sentence": one.sentence,
                "scene": one.scene,
                "yaml": as_yaml(one.scene, one.sentence) if one.scene else None,
            }
            for one in judged.verdicts
        ],
    }


def for_page(judged: Judgement) -> dict[str, Any]:
    """The same with sentences that can be told in any language."""
    told = document(judged)
    rows = zip(told["verdicts"], judged.verdicts, strict=True)
    return {
        **told,
        "sentence": wire(judged.sentence),
        "verdicts": [{**row, "sentence": wire(one.sentence)} for row, one in rows],
    }


def judged_so_far(told: Mapping[str, Any], laws: Mapping[str, str]) -> Judgement:
    """What `for_page` has told, as the page sends it back; `laws`: the law as it is now."""
    return Judgement(
        str(told["law"]),
        int(told["seed"]),
        int(told["scenes"]),
        int(told["calls"]),
        tuple(
            Verdict(
                row["check"],
                CHECKS[row["check"]].says,
                bool(row["holds"]),
                math.inf if row["amount"] is None else float(row["amount"]),
                CHECKS[row["check"]].limit,
                from_wire(row["sentence"]),
                {**row["scene"], "laws": dict(laws)} if row["scene"] else None,
            )
            for row in told["verdicts"]
        ),
    )
