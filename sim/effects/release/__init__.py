"""release, described: an exploder between two touching carts, at one instant or by a spring."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from sim.scene import quantity
from sim.scene.effects import Effect, EffectKind
from sim.scene.fields import Field
from sim.scene.problem import Problem
from sim.scene.said import said, template


def _no_overlap(effect: Effect, gap: Fraction | None) -> Iterator[Problem]:
    """A spring of no length lies between two bumpers that just touch."""
    if gap is not None and gap < 0 and "stiffness" in effect.numbers and effect.between is not None:
        a, b = effect.between
        yield Problem(
            ("effects", effect.index, "release", "stiffness"),
            "overlap",
            said(
                "a release with a stiffness needs two that just touch; {a} and {b} overlap at the "
                "start",
                a=a,
                b=b,
            ),
            said("let them touch, or leave the stiffness out"),
        )


KIND = EffectKind(
    name=template("release"),
    says="an exploder between two touching carts: exactly this energy, at one time",
    place=70,
    fields=(
        Field(
            "energy",
            quantity.ENERGY,
            None,
            "energy released",
            least="0",
            above=True,
            label=said("energy of the exploder"),
        ),
        Field(
            "at",
            quantity.TIME.such_as("1 s"),
            "0",
            "time of the release",
            least="0",
            label=said("time of the release"),
        ),
        Field(
            "stiffness",
            quantity.STIFFNESS,
            None,
            "of a spring that is let go; left out: all at one instant",
            least="0",
            above=True,
            optional=True,
            label=said("stiffness of the spring that is let go"),
        ),
    ),
    needs="between",
    overlap=True,
    gives=True,
    stored_with="stiffness",
    everyday=("explosion", "exploder", "plunger", "explode", "separation"),
    called=said("a release between the carts"),
    switch=said("exploder"),
    room_rule=_no_overlap,
)
