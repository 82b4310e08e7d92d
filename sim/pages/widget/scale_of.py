"""One scale per scene, fixed before anything runs: arrow lengths, cart heights, decimals.

Nothing here looks at the run of a scene that asks for a prediction: a scale must not tell the
answer. Forces are estimated from the start state and from what the sliders reach.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sim.pages.widget.effects_scale import greatest_force, kept_apart, lasting_forces
from sim.pages.widget.elastic import elastic_force, wall_gives
from sim.pages.widget.numbers import decimals_for, decimals_for_all, exponent, speed_unit
from sim.pages.widget.reach import Reach, picture_window, reaches
from sim.pages.widget.run import Run
from sim.scene.fence.controls import Control

REFERENCE_HEIGHT = 38.0  # px, of the cart with the least mass per length
ROOM_TO_GUESS = 1.7  # a prediction's longest arrow, over the estimate: the scale tells nothing
MUCH_FASTER = 5.0  # times what it starts with: then the run's own speeds make the scale
ROUNDING = 1e-12  # of what forces could do; less than that is nought
TALLEST = 4.0  # reference heights; a heavier cart gets a break mark “not to scale”


@dataclass(frozen=True, slots=True)
class Scales:
    """What one unit looks like, for the whole life of the scene."""

    per_height: float  # kg/m, mass per body length of the cart drawn REFERENCE_HEIGHT tall
    tallest: float  # px, of the tallest cart that the sliders reach
    may_tear: bool  # whether that is less than its mass asks for
    force: float  # N, of the longest force arrow; 0: no force can be drawn
    velocity: float  # m/s, of the longest velocity arrow
    decimals: Mapping[str, int]  # of printed values, velocities in the unit of the scene
    reach: Mapping[str, Reach]  # of the axis of each graph
    gives: float = 0.0  # m, how far the softest wall of the ready-made settings gives way
    alike: bool = False  # whether all boxes are drawn of one size, whatever their masses


def read_scales(
    header: Mapping[str, Any],
    controls: tuple[Control, ...],
    run: Run | None,
    camera: float,
    presets: Iterable[Mapping[str, float]] = (),
) -> Scales:
    """The scales of a scene; `run` None where a prediction comes first. Camera speed in m/s.

    `presets`: the numbers of its ready-made settings, whose forces and walls are compared.
    """
    variants = list(_variants(header, controls))
    loads = [b["mass"] / body_width(b) for b in header["bodies"]]
    per_height = min(loads)
    reached = max(b["mass"] / body_width(b) for variant in variants for b in variant["bodies"])
    tallest = REFERENCE_HEIGHT * min(TALLEST, reached / per_height)
    force = _reachable_force(header, variants, run)
    force = max(force, greatest_force(header, controls, run))
    speed = max(abs(b["velocity"] - camera) for variant in variants for b in variant["bodies"])
    speed = max(speed, abs(camera))
    lightest = min(b["mass"] for b in header["bodies"])
    if run is not None:
        fastest = max(abs(v - camera) for column in run.v.values() for v in column)
        if fastest <= ROUNDING * force * header["until"] / lightest:
            fastest = 0.0  # forces that cancel leave rounding, and rounding is no motion
        if fastest > MUCH_FASTER * speed:
            speed = fastest
    velocity = full_scale(speed) if speed > 0 else 1.0
    force = full_scale(force) if force > 0 else 0.0
    per = speed_unit(velocity)[0]
    lasting, heaviest = lasting_forces(header), max(b["mass"] for b in header["bodies"])
    decimals = {
        "t": min(6, max(3, decimals_for(header["until"]))),
        "x": min(6, max(3, decimals_for(velocity))),
        "v": decimals_for(velocity / per, 3 if per == 1 else 2),
        "a": decimals_for_all([(force or lightest) / lightest, *(f / heaviest for f in lasting)]),
        "F": decimals_for(force or 1.0),
        "R": decimals_for_all([force or 1.0, *lasting]),
        "p": decimals_for_all([velocity * b["mass"] for b in header["bodies"]]),
        "energy": decimals_for_all([velocity**2 * b["mass"] / 2 for b in header["bodies"]]),
    }
    seen = [
        {"bodies": [{**b, "velocity": b["velocity"] - camera} for b in variant["bodies"]]}
        for variant in variants
    ]
    axis_force = force if run is not None else force / ROOM_TO_GUESS
    reach = reaches(seen, picture_window(header, camera), axis_force, per)
    may_tear = reached / per_height > TALLEST * (1 + 1e-9)
    compared = [_changed(header, numbers) for numbers in presets]
    if compared:  # one axis for all, so that a larger force is seen to be larger
        most = max(
            (elastic_force(one, c) for one in compared for c in one["contacts"]), default=0.0
        )
        reach["F"] = Reach(0.0, most, 1.0, 0.0)
    gives = max(map(wall_gives, compared), default=0.0)
    return Scales(per_height, tallest, may_tear, force, velocity, decimals, reach, gives)


def body_width(body: Mapping[str, Any]) -> float:
    """Length in m of a cart's box, without its bumpers."""
    return float(max(body["length"] - 2 * body["bumper_length"], 0.2 * body["length"]))


def _variants(
    header: Mapping[str, Any], controls: tuple[Control, ...]
) -> Iterator[Mapping[str, Any]]:
    """The scene itself, and with each slider alone at either end."""
    yield header
    for control in controls:
        for end in (control.low, control.high):
            yield _changed(header, {control.set: end})


def _changed(header: Mapping[str, Any], numbers: Mapping[str, float]) -> Mapping[str, Any]:
    """The scene with other numbers of its carts and contacts."""
    bodies, contacts = header["bodies"], header["contacts"]
    for target, value in numbers.items():
        owner, _, key = target.partition(".")
        bodies = [{**b, key: value} if b["name"] == owner else b for b in bodies]
        if target == "contact.stiffness":
            contacts = [{**c, key: value} if c["stiffness"] else c for c in contacts]
    return {**header, "bodies": bodies, "contacts": contacts}


def full_scale(value: float) -> float:
    """A round number at least as large as `value`, in finer steps than an axis needs."""
    power = float(f"1e{exponent(value)}")
    steps = (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8)
    return next((s * power for s in steps if value <= s * power * (1 + 1e-9)), 10 * power)


def _reachable_force(
    header: Mapping[str, Any], variants: Sequence[Mapping[str, Any]], run: Run | None
) -> float:
    """The greatest contact force in N that a slider may lead to, about.

    Where the run may be known, its greatest force times what the estimate says the sliders do to
    it; else the estimate, as where nothing touches yet and a slider may make it.
    """
    greatest = reached = 0.0
    apart = kept_apart(header)
    for k, contact in enumerate(header["contacts"]):
        if contact["pair"] in apart:
            continue  # their bumpers never meet
        estimates = [elastic_force(variant, variant["contacts"][k]) for variant in variants]
        column = () if run is None else run.F.get(contact["pair"], ())
        meeting = [
            force
            for force, variant in zip(estimates, variants, strict=True)
            if _closing(variant, contact["bodies"])
        ]
        peak = max(column, default=0.0)
        if peak > 0 and estimates[0] > 0:
            greatest = max(greatest, peak * max(estimates) / estimates[0])
        elif run is None:
            greatest = max(greatest, ROOM_TO_GUESS * max(estimates))
        else:
            greatest = max(greatest, peak)
            reached = max([reached, *meeting])
    return greatest or reached


def _closing(header: Mapping[str, Any], between: Sequence[str]) -> bool:
    """Whether the two come nearer to each other at the start."""
    speeds = {b["name"]: b["velocity"] for b in header["bodies"]}
    left, right = (speeds.get(name, 0.0) for name in between)
    return bool(left > right)
