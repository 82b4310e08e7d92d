"""Questions on a scene of the page: a reading off the student's own run, and a drawn prediction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar, Self

from sim.lesson import keys, units
from sim.lesson.keys import NUMBER_OR_TEXT, TEXT, Key
from sim.lesson.kinds.measured_number import TOLERANCE, lacks_unit, read_number
from sim.lesson.kinds.number import mark_number
from sim.lesson.mark import Mark, is_empty
from sim.lesson.question import Common, Question
from sim.scene.problem import Path, Problem
from sim.scene.quantity import TIME, QuantityError, read_quantity

MOMENTS = ("end", "start", "largest")
SCENE = Key("scene", "id of a scene on the same page", "light-meets-heavy", TEXT, True)


@dataclass(frozen=True, slots=True, kw_only=True)
class Reading(Question):
    """A quantity of the run that the student has on the screen, with the values set there.

    `quantity` is x, v, a or p of a cart (`v.A`), or the contact force of a pair (`F.A-B`).
    """

    KIND: ClassVar[str] = "reading"
    SAYS: ClassVar[str] = "read a number off your own run"
    KEYS: ClassVar[tuple[Key, ...]] = (
        SCENE,
        Key("quantity", "what is read: x, v, a, p of a cart, F of a pair", "v.A", TEXT, True),
        Key("at", "when: a time, start, end, or largest (the largest size in the run)", "3 s",
            NUMBER_OR_TEXT),
        Key("unit", "unit of the answer; default: the SI unit", "m/s"),
        TOLERANCE,
    )  # fmt: skip
    scene: str
    quantity: str
    at: float | str
    unit: str
    units: Mapping[str, float]
    per: float  # the unit's size in SI
    tolerance: float  # in the unit, or as a part of the answer
    relative: bool

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """What is read and when; whoever knows the page looks whether the scene has it."""
        scene = keys.needed(table, "scene", path, problems, "scene: light-meets-heavy")
        quantity = keys.needed(table, "quantity", path, problems, "quantity: v.A")
        what, _, whose = quantity.partition(".")
        dimension = units.OF_QUANTITY.get(what)
        if quantity and (dimension is None or not whose or what == "t"):
            message = f"there is no quantity “{quantity[:40]}”"
            hint = "x.A, v.A, a.A, p.A, or F.A-B"
            problems.append(Problem((*path, "quantity"), "unknown-path", message, hint))
        dimension = dimension or units.RATIO
        unit = keys.text(table, "unit", path, problems) or dimension.si
        if dimension.factor(unit) is None:
            message = f"“{unit[:20]}” is not a unit of {dimension.name}"
            problems.append(
                Problem((*path, "unit"), "wrong-unit", message, ", ".join(dimension.units))
            )
            unit = dimension.si
        relative = str(table.get("tolerance", "")).strip().endswith("%")
        kind = units.RATIO if relative else dimension
        exact = read_number(table, "tolerance", kind, path, problems)
        unitless = lacks_unit(table, (unit, dimension), path, problems)
        if not unitless and "tolerance" in table and exact <= 0:
            message = "a reading needs some tolerance: nobody reads a graph exactly"
            problems.append(
                Problem((*path, "tolerance"), "unreachable-tolerance", message, "tolerance: 5 %")
            )
        return cls(
            common=common,
            scene=scene,
            quantity=quantity,
            at=_moment(table, path, problems),
            unit=unit,
            units=units.factors(unit, dimension),
            per=float(units.size_of(unit, dimension)),
            tolerance=float(exact if relative else exact / units.size_of(unit, dimension)),
            relative=relative,
        )

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """As a key file has it; units that a student may type are the page's matter."""
        key = row["key"]
        return cls(
            common=common, scene=str(row["scene"]), quantity=str(row["quantity"]),
            at=row["at"], unit=str(row["unit"]), units={}, per=float(row["per"]),
            tolerance=float(key["tolerance"]), relative=bool(key["relative"]),
        )  # fmt: skip

    def asked(self) -> dict[str, Any]:
        """Which scene, which quantity, when, in which unit."""
        return {
            "scene": self.scene, "quantity": self.quantity, "at": self.at,
            "unit": self.unit, "units": dict(self.units), "per": self.per,
        }  # fmt: skip

    def key(self) -> dict[str, Any]:
        """How near counts; the answer itself is in the student's run."""
        return {"tolerance": self.tolerance, "relative": self.relative, "feedback": []}

    def meaning(self) -> dict[str, Any]:
        """What is read."""
        asked = self.asked()
        return {name: asked[name] for name in ("scene", "quantity", "at", "unit")}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Right if it is near the quantity `own` of the student's own run (in the unit)."""
        if is_empty(value):
            return Mark("empty", 0, self.common.marks)
        if own is None:
            return Mark("open", None, self.common.marks)
        tolerance = abs(own) * self.tolerance if self.relative else self.tolerance
        return mark_number(value, own, tolerance, self.common.marks)


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawn(Question):
    """Stands for the prediction of a scene: answered when that is locked."""

    KIND: ClassVar[str] = "drawn"
    SAYS: ClassVar[str] = "draw it in the scene; this only shows whether it is done"
    MARKED: ClassVar[bool] = False
    KEYS: ClassVar[tuple[Key, ...]] = (SCENE,)
    scene: str

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """The scene must have a `predict:`; whoever knows the page looks at that."""
        scene = keys.needed(table, "scene", path, problems, "scene: light-meets-heavy")
        return cls(common=common, scene=scene)

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """As a key file has it."""
        return cls(common=common, scene=str(row["scene"]))

    def asked(self) -> dict[str, Any]:
        """Which scene."""
        return {"scene": self.scene, "marks": 0}

    def key(self) -> dict[str, Any]:
        """No key."""
        return {"feedback": []}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Nothing to mark."""
        del own
        return Mark("empty", 0, 0) if is_empty(value) else Mark("open", None, 0)


def _moment(table: Mapping[str, Any], path: Path, problems: list[Problem]) -> float | str:
    at = table.get("at", "end")
    if at in MOMENTS:
        return str(at)
    try:
        seconds = read_quantity(at, TIME)
    except QuantityError as error:
        hint = f"at: 3 s, or {', '.join(MOMENTS)}"
        problems.append(Problem((*path, "at"), error.code, error.message, hint))
        return "end"
    return float(max(seconds, Fraction(0)))
