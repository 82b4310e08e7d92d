"""The fitted collision as a scene: what `carts run` runs and a lesson shows.

The scene's clock starts at the first reading. Only the ratio of the masses is known, so without a
weighed cart A has 1 kg: the motion is the same for any mass. The lengths of the carts are such that
they touch when the marks are as far apart as they were at the touch; marks that are closer than
0.10 m stand at other places of the carts, and B is then drawn with its mark further right.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from sim.measured.model.fit import Fit
from sim.measured.model.known import WIDEST_LOG
from sim.measured.model.motion import GRAVITY, Motion
from sim.scene.read import names_a_cart
from sim.scene.said import Said, said

SHORTEST, USUAL = 0.10, 0.20
"""m. Carts shorter than the first would have no room for bumpers."""


def scene_lines(
    fit: Fit,
    names: tuple[str, str],
    times: tuple[float, float],
    mass: tuple[str, float] | None = None,
    title: str = "Our own carts",
) -> list[str]:
    """The scene as lines of YAML; `times`: first and last reading in s."""
    p = fit.parameters
    begin, end = times
    (x1, x2), (v1, v2) = Motion(p, fit.asked.law).state(begin)
    length = p.distance if p.distance >= SHORTEST else USUAL
    x2 += length - p.distance
    labels = _labels(names)
    mass_a = _mass_of_a(fit, names, mass)
    mass_b = mass_a * p.ratio
    k = mass_b / (1.0 + p.ratio) * p.w0**2
    bumper = min(0.5 * length, max(0.04, 0.6 * _greatest(fit)))
    lines = [
        f"title: {title}",
        "carts:",
        *(
            f"  {label}: {{mass: {_si(m)} kg, position: {_si(x)} m, velocity: {_si(v)} m/s, "
            f"length: {_si(length)} m, bumper_length: {_si(bumper)} m}}"
            for label, m, x, v in zip(labels, (mass_a, mass_b), (x1, x2), (v1, v2), strict=True)
        ),
        f"contact: {{restitution: {_si(min(p.e, 1.0))}, stiffness: {_si(k)} N/m, "
        f"law: {fit.asked.law}}}",
    ]
    effects = []
    for label, g in zip(labels, p.friction, strict=True):
        if g > 0.0:
            effects.append(f"  - friction: {{coefficient: {_si(g / GRAVITY)}, carts: [{label}]}}")
    if p.tilt:
        angle = math.degrees(math.asin(max(-1.0, min(1.0, p.tilt / GRAVITY))))
        effects.append(f"  - incline: {{angle: {_si(angle)} deg}}")
    lines += ["effects:", *effects] if effects else []
    lines.append(f"until: {_si(max(end - begin, 0.1))} s")
    return lines


def fence(lines: Sequence[str], identity: str, remarks: Sequence[str] = ()) -> str:
    """The scene as a block of a lesson, with the same remarks."""
    body = scene_text([f"id: {identity}", *lines, "show: [x, v, F]"], remarks)
    return Said("```scene\n{scene}```\n", {"scene": body})


def scene_text(lines: Sequence[str], remarks: Sequence[str] = ()) -> str:
    """The scene as a file, with remarks on top; only these are words."""
    text = "\n".join(lines) + "\n"
    for remark in reversed(remarks):
        text = Said("# {remark}\n{scene}", {"remark": remark, "scene": text})
    return text


def remarks(fit: Fit, mass: tuple[str, float] | None) -> list[str]:
    """What was assumed, for the reader of the scene."""
    found: list[str] = []
    if mass is None:
        found.append(said("A motion does not show masses: A is set to 1 kg, k follows from it."))
    if not math.isfinite(fit.sd("ln_w0")) or fit.sd("ln_w0") > WIDEST_LOG:
        found.append(
            said("The readings do not tell how long the contact lasts: k is a mere guess.")
        )
    if fit.parameters.e > 1.0:
        found.append(
            said("e was fitted as {e}; a bumper gives at most 1.", e=f"{fit.parameters.e:.3f}")
        )
    return found


def _labels(names: tuple[str, str]) -> tuple[str, str]:
    """Names that a scene takes: the carts' own where they are short words, else A and B."""
    good = all(map(names_a_cart, names))
    return names if good and names[0] != names[1] else ("A", "B")


def _mass_of_a(fit: Fit, names: tuple[str, str], mass: tuple[str, float] | None) -> float:
    if mass is None:
        return 1.0
    return mass[1] if mass[0] == names[0] else mass[1] / fit.parameters.ratio


def _greatest(fit: Fit) -> float:
    """m. The greatest overlap."""
    return fit.parameters.approach / fit.parameters.w0


def _si(value: float) -> str:
    """Ten digits: more than any reading has, so that the run is the fitted one."""
    return f"{float(f'{value:.9e}')!r}"
