"""A prediction about forces between two that push each other at no time of the run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from sim.pages.blocks.scene_block import SceneBlock
from sim.pages.findings import Finding
from sim.scene.problem import Problem

OF_TWO = ("contact", "release", "peak", "separate", "stick")
"""Kinds of events that tell of a force between the two that they name."""


def forces_that_never_act(scene: SceneBlock, header: Mapping[str, Any]) -> Iterator[Finding]:
    """A warning where arrows, or the curve of a force, are asked for and the run shows none."""
    predict = scene.fence.predict
    if predict is None:
        return
    touching = [set(event["bodies"]) for event in header["events"] if event["kind"] in OF_TWO]
    touching += [set(one.between) for one in scene.fence.scene.effects if one.between]
    for pair in predict.pairs:
        if set(pair) not in touching:
            yield _warning(scene, "arrows", f"{pair[0]} and {pair[1]} never push each other")
    cart = predict.cart
    if predict.quantity == "F" and cart and not any(cart in bodies for bodies in touching):
        yield _warning(scene, "curve", f"nothing touches {cart}")


def _warning(scene: SceneBlock, key: str, what: str) -> Finding:
    until = scene.fence.scene.until
    message = f"{what} in this run, which ends at {until:g} s"
    hint = "let it end later (until:), or let one cart come to the other: + is to the right"
    problem = Problem(("predict", key), "no-force-to-predict", message, hint)
    return replace(scene.places.finding(problem), severity="warning")
