"""One hard case: a scene in plain values, and measures of its end state that are known for sure.

Sources are named in `why`; tolerances are absolute, in the measure's unit. Tests run all cases
natively and inside the page; the page “Hard cases” shows them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sim.scene.laws import has_formulas
from sim.scene.notation import SUPERSCRIPT

G = 9.81
ULP = 2.220446049250313e-16


@dataclass(frozen=True)
class Expected:
    """`what` to read of a run's report: "v.A", "v.B-A", "x.A", "warmed", "energy", "work.push",
    "count.contact", or "last.contact" (s, the time of the last one)."""

    what: str
    value: float
    tolerance: float


@dataclass(frozen=True)
class HardCase:
    """`sentence` says what is hard, `why` where the expected values come from."""

    name: str
    sentence: str
    plain: dict[str, Any]
    expected: tuple[Expected, ...]
    why: str
    events: bool = True  # False: only counted

    @property
    def has_formulas(self) -> bool:
        """Whether it runs in plain Python, without an integrator of scipy."""
        return has_formulas(self.plain.get("contact", {}).get("law"))


def at(position: Any, velocity: Any = 0, mass: Any = 1, length: Any = "0.2") -> dict[str, Any]:
    """One cart."""
    return {"mass": mass, "position": position, "velocity": velocity, "length": length}


def scene(carts: dict[str, Any], until: Any, *effects: dict[str, Any], **more: Any) -> Any:
    """A whole scene in plain values."""
    return {"carts": carts, "until": until, "effects": list(effects), **more}


def row(
    speeds: list[Any], until: Any, *effects: dict[str, Any], gap: str = "0", **more: Any
) -> Any:
    """Equal carts A, B, C … of 0.2 m, the first at 0.5 m."""
    step = 0.2 + float(gap)
    names = "ABCDE"[: len(speeds)]
    carts = {
        n: at(f"{0.5 + k * step:.12g}", v)
        for k, (n, v) in enumerate(zip(names, speeds, strict=True))
    }
    return scene(carts, until, *effects, **more)


def speeds(*values: float, within: float, names: str = "ABCDE") -> tuple[Expected, ...]:
    """m/s of the carts at the end, in their order."""
    return tuple(Expected(f"v.{n}", v, within) for n, v in zip(names, values, strict=False))


def ten_to(power: int) -> str:
    """A power of ten as readers write it: 100, 10⁹."""
    return str(10**power) if power < 4 else "10" + str(power).translate(SUPERSCRIPT)
