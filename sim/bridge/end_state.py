"""One number of a run's report: “v.A”, “v.B-A”, “v.A+B”, “x.A”, “warmed”, “energy”, “work.push”,
“count.contact”, or “last.contact” (s, the time of the last one)."""

from __future__ import annotations

import math
from typing import Any


def read(report: dict[str, Any], what: str) -> float:
    """One number of a report, as `carts run --json` gives it."""
    kind, _, name = what.partition(".")
    if kind in ("x", "v"):
        values: dict[str, float] = report["final"][kind]
        if name in values:
            return values[name]
        for k, sign in enumerate(name):  # names may hold hyphens
            if sign == "-" and {name[:k], name[k + 1 :]} <= values.keys():
                return values[name[:k]] - values[name[k + 1 :]]
        return math.fsum(values[part] for part in name.split("+"))
    if kind in ("count", "last"):
        if "event_counts" in report:
            return float(report["event_counts"][name])
        times = [event["t"] for event in report["events"] if event["kind"] == name]
        return float(len(times) if kind == "count" else max(times))
    totals = {"energy": report["energy"]["final"], "warmed": report["energy"]["warmed"]}
    return float(report["work"][name] if kind == "work" else totals[kind])
