"""Laws as somebody writes them: right ones, and wrong ones with what each of them breaks."""

from __future__ import annotations

from typing import Any

PAIR: dict[str, Any] = {
    "carts": {
        "A": {"mass": 2.0, "position": 0.4, "velocity": 0.4},
        "B": {"mass": 0.5, "position": 1.2},
    },
    "until": 3.0,
}
SPRING = """\
def force(overlap, rate, stiffness):
    return stiffness * overlap
"""

RIGHT = {
    "spring": SPRING,
    "spring that only pushes": """\
def force(overlap, rate, stiffness):
    return max(0.0, stiffness * overlap)
""",
    "damped spring that only pushes": """\
def force(overlap, rate, stiffness, restitution, reduced_mass):
    damping = 2 * (1 - restitution) * (stiffness * reduced_mass) ** 0.5
    return max(0.0, stiffness * overlap + damping * rate)
""",
    "damped spring that also pulls": """\
def force(overlap, rate):
    return 200 * overlap + 2.5 * rate
""",
    "hertz": """\
def force(overlap, rate):
    return 4000 * overlap ** 1.5
""",
    "damped hertz": """\
def force(overlap, rate, reduced_mass):
    return 4000 * overlap ** 1.5 + 4 * reduced_mass ** 0.5 * overlap ** 0.25 * rate
""",
    "stiffer and stiffer": """\
import math

def force(overlap, rate):
    return 40 * math.sinh(overlap / 0.1)
""",
    "two springs one behind the other": """\
def force(overlap, rate):
    first = 300 * overlap
    second = 900 * max(0, overlap - 0.02)
    return first + second
""",
    "softer on the way back": """\
def force(overlap, rate):
    if rate > 0:
        return 300 * overlap
    return 150 * overlap
""",
    "masses, but both alike": """\
def force(overlap, rate, mass_self, mass_other):
    return 100 * overlap * (mass_self + mass_other)
""",
    "nothing at all": """\
def force(overlap, rate):
    return 0
""",
}

WRONG = {
    "the heavier one feels more": (
        """\
def force(overlap, rate, mass_self):
    return 100 * mass_self * overlap
""",
        "third-law",
    ),
    "the one that moves pushes more": (
        """\
def force(overlap, rate, velocity_self, velocity_other):
    return 100 * overlap * (1 + abs(velocity_other))
""",
        "third-law",
    ),
    "nearly the same for both": (
        """\
def force(overlap, rate, side):
    return 100 * overlap * (1.0001 if side == "left" else 1)
""",
        "third-law",
    ),
    "a damper the wrong way round": (
        """\
def force(overlap, rate):
    return max(0, 100 * overlap - 0.5 * rate)
""",
        "energy",
    ),
    "stiffer on the way back": (
        """\
def force(overlap, rate):
    return (100 if rate > 0 else 110) * overlap
""",
        "energy",
    ),
    "a spring that gets stiffer with time": (
        """\
def force(overlap, rate, time):
    return 100 * overlap * (1 + time)
""",
        "energy",
    ),
    "only heavy carts get something for nothing": (
        """\
def force(overlap, rate, reduced_mass):
    if reduced_mass > 2.5 and rate < 0:
        return 200 * overlap
    return 100 * overlap
""",
        "energy",
    ),
    "only fast ones do": (
        """\
def force(overlap, rate):
    return 100 * overlap + (0 if rate > -1 else 5)
""",
        "energy",
    ),
    "rubs on the track": (
        """\
def force(overlap, rate, velocity_self, velocity_other):
    return 100 * overlap * (1 + 0.5 * (velocity_self + velocity_other) ** 2)
""",
        "galilei",
    ),
    "the left one counts": (
        """\
def force(overlap, rate, mass_self, mass_other, side):
    left = mass_self if side == "left" else mass_other
    return 100 * overlap * (1 + left)
""",
        "mirror",
    ),
    "A is a name that counts": (
        """\
def force(overlap, rate, name_self, side):
    first = (name_self == "A") == (side == "left")
    return (100 if first else 120) * overlap
""",
        "order",
    ),
    "gets tired": (
        """\
asked = []

def force(overlap, rate):
    asked.append(overlap)
    return 100 * overlap / (1 + 0.001 * len(asked))
""",
        "step",
    ),
    "works out the rate itself": (
        """\
last = [0]

def force(overlap, rate, stiffness):
    change = overlap - last[0]
    last[0] = overlap
    return stiffness * overlap + 50 * change
""",
        "step",
    ),
    "who asks first gets more": (
        """\
turns = [0]

def force(overlap, rate):
    turns[0] += 1
    return 100 * overlap * (1.1 if turns[0] % 2 else 1)
""",
        "order",
    ),
}


def with_law(scene: dict[str, Any], text: str, **contact: Any) -> dict[str, Any]:
    """The scene with that law between all carts."""
    return {**scene, "contact": {"law": "mine.py", **contact}, "laws": {"mine.py": text}}
