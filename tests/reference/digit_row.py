"""A row of carts with forty digits: what moves, what acts on it, and whom friction holds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpf

from sim.scene import Scene
from tests.reference.digit_pairs import Pair, UnsupportedError, damping

NOTHING = mpf(10) ** -45
"""m, m/s, N. What rounding makes of nought."""


@dataclass
class Group:
    carts: list[int]
    v: mpf
    fixed: bool = False
    held: bool = False
    sliding: int = 0


class DigitRow:
    """What moves, what acts, who is held."""

    def __init__(self, scene: Scene) -> None:
        self.scene, n = scene, len(scene.carts)
        self.n, self.t = n, mpf(0)
        self.m = [mpf(cart.mass) for cart in scene.carts]
        self.moved = [mpf(0)] * n
        self.groups = [Group([k], mpf(cart.velocity)) for k, cart in enumerate(scene.carts)]
        self.gap0 = [
            mpf(g) if c is not None else None
            for g, c in zip(scene.gaps, scene.contacts, strict=True)
        ]
        self.joined: set[int] = set()
        self.slipping: dict[int, mpf] = {}  # s, when a group was pushed away
        self.events: list[tuple[mpf, str, tuple[str, ...]]] = []
        self._loads()
        self.pairs: dict[int, Pair | None] = {}
        for k, contact in enumerate(scene.contacts):
            if contact is None:
                continue
            if contact.sudden:
                self.pairs[k] = None
                continue
            if contact.law == "hertz":
                raise UnsupportedError("hertz")
            e, stiff = mpf(contact.restitution), mpf(contact.stiffness)
            zeta = mpf(0) if contact.law == "bumper" else damping(contact.law, e)
            pair = Pair(contact.law, stiff, e, 2 * zeta * mp.sqrt(stiff * self.mu(k)), zeta)
            self.pairs[k] = pair
            d, s = self.overlap(k)
            if d > 0:
                presses = pair.law == "bumper" and (s > 0 or e == 1)
                pair.state = "press" if presses else "spring" if pair.law == "bumper" else "on"
                pair.memory = d if pair.state == "spring" else mpf(0)
                self.tell("contact", scene.names_at(k))

    def _loads(self) -> None:
        scene = self.scene
        g = mpf(scene.gravity)
        angle = [mpf(0)] * self.n
        self.steady, self.grips = [mpf(0)] * self.n, [(mpf(0), mpf(0))] * self.n
        self.pushes: list[tuple[int, mpf, mpf, mpf]] = []
        names = [cart.name for cart in scene.carts]
        self.drag = [mpf(0)] * self.n
        self.springs: dict[int, tuple[mpf, mpf, mpf]] = {}
        self.loose: dict[int, mpf] = {}  # m, the length of a spring that was let go
        for effect in scene.effects:
            if effect.kind == "spring":
                k = next(k for k in range(self.n + 1) if scene.names_at(k) == effect.between)
                stiff, length, c = (
                    mpf(effect.numbers[key]) for key in ("stiffness", "length", "damping")
                )
                a, b, rest = self.springs.get(k, (mpf(0), mpf(0), mpf(0)))
                self.springs[k] = (a + stiff, b + c, rest + stiff * length)
                continue
            if effect.kind == "release":
                continue  # `digit_releases`
            for k in (names.index(name) for name in effect.carts):
                if effect.kind == "incline":
                    one = mpf(effect.numbers["angle"])
                    angle[k] += one
                    self.steady[k] += self.m[k] * g * mp.sin(one)
                elif effect.kind == "push":
                    end = mpf(effect.numbers.get("until", scene.until + 1))
                    row = (k, mpf(effect.numbers["from"]), end, mpf(effect.numbers["force"]))
                    self.pushes.append(row)
                elif effect.kind == "drag" and not effect.numbers["quadratic"]:
                    self.drag[k] += mpf(effect.numbers["linear"])
                elif effect.kind != "friction":
                    raise UnsupportedError(effect.kind)
        for effect in scene.effects:
            if effect.kind == "friction":
                low = mpf(effect.numbers["coefficient"])
                high = max(low, mpf(effect.numbers.get("static", low)))
                for k in (names.index(name) for name in effect.carts):
                    press = self.m[k] * g * mp.cos(angle[k])
                    a, b = self.grips[k]
                    self.grips[k] = (a + low * press, b + high * press)

    def tell(self, kind: str, bodies: tuple[str, ...]) -> None:
        self.events.append((self.t, kind, tuple(bodies)))

    def group(self, cart: int) -> Group | None:
        return next((g for g in self.groups if cart in g.carts), None)

    def mass(self, group: Group) -> mpf:
        return sum((self.m[k] for k in group.carts), mpf(0))

    def _inverse(self, cart: int) -> mpf:
        group = self.group(cart)
        return mpf(0) if group is None or group.fixed else 1 / self.mass(group)

    def mu(self, k: int) -> mpf:
        return 1 / (self._inverse(k - 1) + self._inverse(k))

    def dampers(self) -> None:
        """They are those of the bodies that now meet."""
        for k, pair in self.pairs.items():
            if pair is not None and k not in self.joined:
                light = self._inverse(k - 1) + self._inverse(k)
                pair.c = 2 * pair.zeta * mp.sqrt(pair.k / light) if light else mpf(0)

    def _place(self, k: int) -> tuple[Any, Any]:
        """Series of displacement and velocity of a cart; of a wall: nothing."""
        group = self.group(k)
        return (0, 0) if group is None else (self.moved[k], group.v)

    def overlap(self, k: int) -> tuple[mpf, mpf]:
        (xl, vl), (xr, vr) = self._place(k - 1), self._place(k)
        return -(self.gap0[k] + xr - xl), vl - vr

    def outer(self, group: Group) -> mpf:
        total = sum((self.steady[k] for k in group.carts), mpf(0))
        for k, begin, end, force in self.pushes:
            if k in group.carts and begin <= self.t < end:
                total += force
        return total

    def grip(self, group: Group) -> tuple[mpf, mpf]:
        both = [self.grips[k] for k in group.carts]
        return sum((a for a, _ in both), mpf(0)), sum((b for _, b in both), mpf(0))

    def contact_force(self, group: Group) -> mpf:
        total = mpf(0)
        for k, (a, b, c) in self.acting():
            d, s = self.overlap(k)
            push = a * d + b * s + c
            if k - 1 in group.carts:
                total -= push
            if k in group.carts:
                total += push
        return total

    def acting(self) -> list[tuple[int, tuple[Any, Any, Any]]]:
        """Forces in gaps: factors of overlap and rate, and a constant."""
        found: list[tuple[int, tuple[Any, Any, Any]]] = [
            (k, pair.force())
            for k, pair in self.pairs.items()
            if pair is not None and k not in self.joined and any(pair.force())
        ]
        return found + [(k, s) for k, s in self.springs.items() if k not in self.joined]

    def judge(self, *, tell: bool = True) -> None:
        """Who is held, and who slides where."""
        for group in self.groups:
            _, static = self.grip(group)
            if group.fixed or not static:
                continue
            was = group.held
            if abs(group.v) <= NOTHING:
                group.v = mpf(0)
                total = self.outer(group) + self.contact_force(group)
                slips = self.slipping.get(id(group)) == self.t  # also where it then meets another
                group.held = abs(total) <= static and not slips
                group.sliding = 0 if group.held else int(mp.sign(total))
            else:
                group.held, group.sliding = False, int(mp.sign(group.v))
            if tell and was != group.held:
                names = tuple(self.scene.carts[k].name for k in group.carts)
                self._tell_grip(group.held, names)

    def _tell_grip(self, held: bool, names: tuple[str, ...]) -> None:
        """One of two touches of an instant may let go, and the other hold: that is no event."""
        kind, undone = ("stop", "start") if held else ("start", "stop")
        if (self.t, undone, names) in self.events:
            self.events.remove((self.t, undone, names))
        else:
            self.tell(kind, names)
