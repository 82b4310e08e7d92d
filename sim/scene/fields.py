"""The field table: every key of a scene that holds a number, with kind, default, range and meaning.

Validation and the JSON Schema (`sim.scene.schema`) are made from it; effects and laws add theirs.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from sim.scene import quantity
from sim.scene.problem import Path, Problem
from sim.scene.quantity import Dimension, QuantityError, read_quantity
from sim.scene.reading.tolerance import has_tolerance, read_tolerant
from sim.scene.said import said


@dataclass(frozen=True, slots=True)
class Field:
    """One numeric key. `default` None means required, unless `optional`."""

    key: str
    dimension: Dimension
    default: str | None
    says: str
    least: str | None = None  # SI, inclusive unless `above`
    most: str | None = None
    above: bool = False  # the least value itself is not allowed
    optional: bool = False
    label: str = ""  # of its slider
    tolerant: bool = False  # may say how far off it is, see `tolerance`

    @property
    def allowed(self) -> str:
        """The range in words: ``greater than 0``, ``0 to 1``."""
        unit = f" {self.dimension.si}" if self.dimension.si else ""
        if self.least is not None and self.most is not None:
            both = f"{self.least} to {self.most}{unit}"
            return said("more than {least}", least=both) if self.above else both
        if self.least is not None:
            least = f"{self.least}{unit}"
            return (
                said("greater than {least}", least=least)
                if self.above
                else said("at least {least}", least=least)
            )
        return "any finite number"

    def read(self, value: object, path: Path) -> Fraction | Problem:
        """The exact SI value, the middle of a tolerance, or what is wrong with it."""
        try:
            if self.tolerant and has_tolerance(value):
                number = self._middle(str(value))
            else:
                number = read_quantity(value, self.dimension)
        except QuantityError as error:
            return Problem(path, error.code, error.message, error.hint)
        low = None if self.least is None else quantity.exact(self.least)
        high = None if self.most is None else quantity.exact(self.most)
        if (low is not None and (number < low or (self.above and number == low))) or (
            high is not None and number > high
        ):
            return Problem(
                path,
                "out-of-range",
                said(
                    "{key} must be {range} (got {value})",
                    key=said(self.key),
                    range=self.allowed,
                    value=str(value),
                ),
                said("for example {example}", example=f"{self.key}: {self.dimension.example}"),
            )
        return number

    def _middle(self, value: str) -> Fraction:
        """Of what has a tolerance; every number that it allows must be one that may stand here."""
        middle, half = read_tolerant(value, self.dimension)
        low = None if self.least is None else quantity.exact(self.least)
        if low is not None and (middle - half < low or (self.above and middle - half == low)):
            message = said(
                "{key} could be {least} within its tolerance",
                key=said(self.key),
                least=self.least or "0",
            )
            raise QuantityError("out-of-range", message, said("a smaller tolerance"))
        return middle

    def half_width(self, value: object) -> Fraction:
        """SI. Of the tolerance in a value that `read` took; 0 without one."""
        if not (self.tolerant and has_tolerance(value)):
            return Fraction(0)
        return read_tolerant(str(value), self.dimension)[1]


SKINS = ("cart", "van", "truck", "trailer", "box", "puck", "glider")
"""What a cart is drawn as; its motion does not know."""

CART = (
    Field("mass", quantity.MASS, None, "mass of the cart", least="0", above=True, tolerant=True),
    Field(
        "position", quantity.LENGTH, None, "position of the cart's centre at t = 0", tolerant=True
    ),
    Field("velocity", quantity.SPEED, "0", "velocity at t = 0; + is to the right"),
    Field(
        "length",
        quantity.LENGTH,
        "0.20",
        "length of the cart, bumpers included",
        least="0",
        tolerant=True,
    ),
    Field(
        "bumper_length",
        quantity.LENGTH,
        "0.04",
        "length of the bumper at each end, part of the cart's length",
        least="0",
    ),
)

IN_OTHER_WORDS = {
    "speed": "velocity", "v": "velocity", "weight": "mass", "m": "mass", "place": "position",
    "x": "position", "start": "position", "width": "length", "size": "length",
}  # fmt: skip
"""What authors call the keys of a cart, where no spelling is near."""


def is_word(name: str) -> bool:
    """Whether a cart's name says what it is, as “truck” does and A does not (view/bodies.js)."""
    return len(name) > 2


TRACK_LENGTH = Field(
    "length",
    quantity.LENGTH,
    None,
    "length of the track; a right wall needs it",
    least="0",
    above=True,
    optional=True,
    tolerant=True,
)

RESTITUTION = Field(
    "restitution",
    quantity.RATIO,
    "1",
    "e, relative speed after the contact divided by that before",
    least="0",
    most="1",
)
STIFFNESS = Field(
    "stiffness", quantity.STIFFNESS, "500", "spring stiffness of the contact", least="0", above=True
)
HERTZ_STIFFNESS = Field(
    "stiffness", quantity.HERTZ_STIFFNESS, "500", "stiffness of the contact", least="0", above=True
)

UNTIL = Field("until", quantity.TIME, "5", "the run ends at this time", least="0", above=True)
FREE_FALL = "9.81"
"""m/s². What gravity is unless a scene says otherwise, and in films of carts."""

GRAVITY = Field(
    "gravity",
    quantity.ACCELERATION,
    FREE_FALL,
    "acceleration of free fall, for friction and inclines",
    least="0",
)
