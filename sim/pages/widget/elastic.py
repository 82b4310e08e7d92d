"""The greatest squeeze and force of a contact in which nothing gets lost: known before any run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.scene.laws import power_of


def elastic_squeeze(header: Mapping[str, Any], contact: Mapping[str, Any]) -> float:
    """Greatest squeeze in m at the greatest closing speed in the scene; of a rigid contact 0.

    All energy is in the spring: k d^(p+1)/(p+1) = ½ mu u².
    """
    k = contact["stiffness"]
    if not k:
        return 0.0
    masses = {b["name"]: b["mass"] for b in header["bodies"]}
    speeds = [b["velocity"] for b in header["bodies"]]
    inverse = sum(1 / masses[name] for name in contact["bodies"] if name in masses)
    walled = any(name not in masses for name in contact["bodies"])
    closing = max(map(abs, speeds)) if walled else max(speeds) - min(speeds)
    p = power_of(contact["law"])
    return float(((p + 1.0) * closing**2 / (2.0 * k * inverse)) ** (1.0 / (p + 1.0)))


def elastic_force(header: Mapping[str, Any], contact: Mapping[str, Any]) -> float:
    """The force k d^p in N at that squeeze."""
    k = contact["stiffness"]
    return float(k * elastic_squeeze(header, contact) ** power_of(contact["law"])) if k else 0.0


def wall_gives(header: Mapping[str, Any]) -> float:
    """How far a wall gives way in m, as the lens draws it: what the bumper before it does not."""
    bumpers = {b["name"]: b["bumper_length"] for b in header["bodies"]}
    return max(
        (
            elastic_squeeze(header, contact) - max(bumpers.get(n, 0.0) for n in contact["bodies"])
            for contact in header["contacts"]
            if any(name not in bumpers for name in contact["bodies"])
        ),
        default=0.0,
    )
