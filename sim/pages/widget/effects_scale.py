"""How large the forces of effects may become, so that arrows have one scale for the whole scene."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.effects.part import part_of
from sim.pages.widget.run import Run
from sim.scene.effects import kinds
from sim.scene.fence.controls import Control

ROUNDING = 1e-12  # of the force itself; less than that is nought
UNKNOWN = 0.1  # of the weight: the force of an effect that nothing is known of here
ROOM_TO_GUESS = 1.7  # before a prediction the scale must not tell the size of a force


def greatest_force(
    header: Mapping[str, Any], controls: Sequence[Control], run: Run | None
) -> float:
    """N. With a run: its own forces, stretched by what the sliders do; without one: an estimate."""
    variants = [header, *_variants(header, controls)]
    greatest = 0.0
    for k, effect in enumerate(header["effects"]):
        estimates = [_estimate(variant["effects"][k], variant) for variant in variants]
        peak = 0.0 if run is None else _peak(effect, run)
        if run is None:
            greatest = max(greatest, ROOM_TO_GUESS * max(estimates))
        elif peak <= ROUNDING * max(estimates):  # it is there, and others hold it
            greatest = max(greatest, *estimates)
        elif peak and estimates[0]:
            greatest = max(greatest, peak * max(estimates) / estimates[0])
        else:
            greatest = max(greatest, peak, 0.0 if effect["between"] else max(estimates))
    return greatest


def lasting_forces(header: Mapping[str, Any]) -> list[float]:
    """N. The greatest of each effect as the scene starts: beside the push of a bumper they are
    small, and what is told of a cart that only they move must show them."""
    sizes = (_estimate(effect, header) for effect in header["effects"] if effect["active"])
    return [size for size in sizes if size > 0.0]


def kept_apart(header: Mapping[str, Any]) -> set[str]:
    """Pairs, such as A-B, that an effect keeps from ever touching."""
    return {
        "-".join(effect["between"])
        for effect in header["effects"]
        if effect["active"] and effect["between"] and kinds()[effect["kind"]].apart
    }


def effect_target(target: str, effects: Sequence[Mapping[str, Any]]) -> tuple[int, str] | None:
    """Which effect of the list a change names, and what of it: a number, or “active”."""
    owner, _, key = target.rpartition(".")
    for effect in effects:
        place = f"effects.{effect['index']}"
        if owner in (place, f"{place}.{effect['kind']}", effect["kind"]):
            return int(effect["index"]), key
    return None


def _variants(header: Mapping[str, Any], controls: Sequence[Control]) -> list[Mapping[str, Any]]:
    """The scene with each slider alone at either end."""
    variants: list[Mapping[str, Any]] = []
    for control in controls:
        owner, _, key = control.set.rpartition(".")
        found = effect_target(control.set, header["effects"])
        for end in (control.low, control.high):
            bodies = [{**b, key: end} if b["name"] == owner else b for b in header["bodies"]]
            effects = [
                {**e, "numbers": {**e["numbers"], key: end}}
                if found is not None and e["index"] == found[0]
                else e
                for e in header["effects"]
            ]
            gravity = end if control.set == "gravity" else header["gravity"]
            variants.append({**header, "bodies": bodies, "effects": effects, "gravity": gravity})
    return variants


def _peak(effect: Mapping[str, Any], run: Run) -> float:
    columns = [run.effects.get(f"{effect['kind']} {name}", ()) for name in effect["carts"]]
    if effect["between"]:
        columns = [run.F.get("-".join(effect["between"]), ())]
    return max((abs(value) for column in columns for value in column), default=0.0)


def _estimate(effect: Mapping[str, Any], header: Mapping[str, Any]) -> float:
    """Greatest force in N as the folder of the effect tells it; of one that says nothing, a part of
    the weight, or nothing between two: its run tells."""
    if module := part_of(effect["kind"], "largest"):
        return float(module.largest(effect, header))
    masses = [body["mass"] for body in header["bodies"] if body["name"] in effect["carts"]]
    return 0.0 if effect["between"] else UNKNOWN * header["gravity"] * max(masses, default=0.0)
