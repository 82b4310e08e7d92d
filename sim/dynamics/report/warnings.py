"""What a reader should know before pressing Play."""

from __future__ import annotations

from dataclasses import dataclass

from sim.dynamics.result.finished import Run
from sim.laws.contact_law import ContactLaw
from sim.laws.lookup import contact_law
from sim.scene.effects import kinds
from sim.scene.laws import law_kind
from sim.scene.model import Scene
from sim.scene.said import said, template
from sim.scene.track import body_name

BOTH = (
    template(
        "The bumpers between {one} and {other} would be squeezed by {depth}, "
        "but there is room for {room}."
    ),
    template(
        "The bumpers between {one} and {other} would be squeezed by {depth}, "
        "but there is room for {room}. Raise the stiffness to at least {stiffness}, "
        "or let them meet at {speed} or less."
    ),
    template(
        "The bumpers between {one} and {other} would be squeezed by {depth}, "
        "but there is room for {room}. Raise the stiffness to {stiffness} or more."
    ),
)
"""Of two carts: what happens, and the same with what would help where they meet too fast, and where
something presses them together."""

ALONE = (
    template(
        "The bumper between {one} and {other} would be squeezed by {depth}, "
        "but there is room for {room}."
    ),
    template(
        "The bumper between {one} and {other} would be squeezed by {depth}, "
        "but there is room for {room}. Raise the stiffness to at least {stiffness}, "
        "or let them meet at {speed} or less."
    ),
    template(
        "The bumper between {one} and {other} would be squeezed by {depth}, "
        "but there is room for {room}. Raise the stiffness to {stiffness} or more."
    ),
)
"""The same of a cart at a wall."""


@dataclass(frozen=True, slots=True)
class Remark:
    """A remark about a run; it changes no number."""

    code: str
    message: str


def warnings(run: Run) -> tuple[Remark, ...]:
    """Bumpers squeezed beyond their length, deepest first.

    Between two carts there are two bumpers, at a wall there is one, or the wall itself gives
    way. In every linear law the greatest overlap grows with u / sqrt(k), in hertz with
    (u²/k)^(2/5): from that come the stiffness or speed that would do.
    """
    found = []
    scene = run.scene
    acts = any(
        e.active and (kinds()[e.kind].stores or kinds()[e.kind].gives) for e in scene.effects
    )
    for gap, (deepest, speed) in run.record.deepest.items():
        names = scene.names_at(gap)
        bumpers = [cart.bumper_length for cart in scene.carts if cart.name in names]
        room = sum(bumpers)
        if deepest <= room or (len(bumpers) == 1 and room == 0.0):
            continue  # at a wall, a cart without a bumper asks the wall to give way
        one, other = (body_name(name, scene.track) for name in names)
        squeezed, advised, pressed = ALONE if len(bumpers) == 1 else BOTH
        told = {"one": one, "other": other, "depth": f"{100 * deepest:.3g} cm"}
        told["room"] = f"{100 * room:.3g} cm"
        message = said(squeezed, **told)
        contact = scene.contacts[gap]
        law = None if contact is None else contact_law(contact)
        kind = None if contact is None else law_kind(contact.law)
        field = None if kind is None else kind.stiffness
        helps = room > 0.0 and scene.gaps[gap] > -room and (speed > 0.0 or acts)
        if helps and law is not None and field is not None:
            harder, faster = law.grows
            stiffness = law.stiffness * (deepest / room) ** harder
            slower = speed * (room / deepest) ** faster
            told["stiffness"] = f"{_up(stiffness)} {field.dimension.si}"
            message = said(advised, **told, speed=f"{_down(slower)} m/s")
            if acts and _is_pressed(scene, gap, law, deepest, speed):
                message = said(pressed, **told)
        found.append((deepest - room, Remark("bumper-bottoms", message)))
    found = sorted(found, key=lambda item: -item[0])
    return (*(warning for _, warning in found), *_idle(run), *_nearly_rigid(run))


MORE = 1.0 + 1e-6
"""Of the energy of an approach. What a bumper takes up beyond that comes from something else."""


def _is_pressed(scene: Scene, gap: int, law: ContactLaw, deepest: float, speed: float) -> bool:
    """Does what acts press the two together by more than the energy of their approach?

    Up to an overlap d a bumper takes up k d^p/p, p = 2 (hertz 2.5). A stiffness that is as much
    greater as for an impact alone is enough for these, too, and no lower speed need be.
    """
    power = law.grows[0]
    inverse = sum(1.0 / cart.mass for cart in scene.carts if cart.name in scene.names_at(gap))
    came = 0.5 * speed * speed / inverse
    return bool(law.stiffness * deepest**power / power > MORE * came)


def _nearly_rigid(run: Run) -> list[Remark]:
    """Groups in which a bumper that hardly springs back was held instead."""
    record = run.record
    pressed = set(record.deepest)
    if record.solved_all:  # what met alone had its own formula
        pressed &= {gap for part in record.solved if len(part.gaps) > 1 for gap in part.gaps}
    laws = (None if (c := run.scene.contacts[gap]) is None else contact_law(c) for gap in pressed)
    tiny = [law.e for law in laws if law is not None and 0.0 < law.e <= law.held_below]
    if "power-series" not in run.solvers or not tiny:
        return []
    return [
        Remark(
            "nearly-rigid",
            said(
                "Several contacts held at once: there a bumper with a restitution of {e} "
                "counts as one with 0, which changes velocities by less than that part of them.",
                e=f"{min(tiny):g}",
            ),
        )
    ]


def _idle(run: Run) -> list[Remark]:
    """Exploders whose carts had parted."""
    found = []
    for gap, t, room in run.record.idle_bursts:
        one, other = run.scene.names_at(gap)
        message = said(
            "The release between {one} and {other} at {time} did nothing: "
            "there were {gap} between them. Let them touch at that time.",
            one=one,
            other=other,
            time=f"{t:.6g} s",
            gap=f"{100 * room:.3g} cm",
        )
        found.append(Remark("release-apart", message))
    return found


def _up(value: float) -> str:
    """Three figures, never less than the value."""
    rounded = float(f"{value:.3g}")
    return f"{rounded if rounded >= value else float(f'{rounded * 1.005:.3g}'):g}"


def _down(value: float) -> str:
    """Three figures, never more than the value."""
    rounded = float(f"{value:.3g}")
    return f"{rounded if rounded <= value else float(f'{rounded * 0.995:.3g}'):g}"
