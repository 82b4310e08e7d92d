"""A row of carts integrated with forty digits and more: the oracle of certificates.

Every force is linear in overlaps and rates, so the motion of all bodies together is a power series;
it is summed step by step with mpmath, and what ends a formula is found on the polynomials: sign
changes on a grid, then halving. No closed form, no ball, nothing of `sim`: only the definitions.
The inputs are the doubles of a scene: masses, velocities, gaps as the scene has them.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from mpmath import mp, mpf

from sim.scene import Scene

DIGITS = 60
ORDER = 44
GRID = 24
MOST_STEPS = 1500
"""A few seconds. What takes longer is left to other tests."""
NOTHING = mpf(10) ** -45
"""m, m/s, N. What rounding makes of nought."""


class UnsupportedError(Exception):
    """The oracle does not know."""


@dataclass
class Pair:
    """A contact: N = k (d − rest) + c s in its present state; nought where it is open."""

    law: str
    k: mpf
    e: mpf
    c: mpf
    zeta: mpf
    state: str = "open"
    memory: mpf = field(default_factory=lambda: mpf(0))

    @property
    def rest(self) -> mpf:
        return (1 - self.e**2) * self.memory

    def force(self) -> tuple[mpf, mpf, mpf]:
        """Factors of d, of s, and a constant."""
        if self.state == "press":
            return self.k, mpf(0), mpf(0)
        if self.state == "on":
            return self.k, self.c, mpf(0)
        if self.state == "spring":
            steep = self.k / self.e**2
            return steep, mpf(0), -steep * self.rest
        return mpf(0), mpf(0), mpf(0)

    def watches(self) -> list[tuple[tuple[Any, Any, Any], str]]:
        """(factors of d, s, constant) that stay positive while this state holds, and the next."""
        if self.state == "press":
            return [((1, 0, 0), "open")] if self.e == 1 else [((0, 1, 0), "turn")]
        if self.state == "spring":
            return [((1, 0, -self.rest), "open"), ((-1, 0, self.memory), "climb")]
        if self.state == "on":
            pull = (self.k, self.c, 0) if self.law.startswith("push") else (1, 0, 0)
            return [(pull, "open")]
        if self.memory:  # a bumper on its way to be clear of the other
            return [((-1, 0, self.rest), "again"), ((1, 0, 0), "clear")]
        if self.state == "idle":
            return [((-self.k, -self.c, 0), "again"), ((1, 0, 0), "clear")]
        return [((-1, 0, 0), "touch")]


def damping(law: str, e: mpf) -> mpf:
    """ζ, by halving the definition: what the damped oscillator returns is e."""
    if e == 1:
        return mpf(0)
    if law != "push-only":
        return mpf(1) if e == 0 else -mp.log(e) / mp.sqrt(mp.pi**2 + mp.log(e) ** 2)

    def returned(z: mpf) -> mpf:
        if z < 1:
            return mp.exp(-2 * z * mp.acos(z) / mp.sqrt(1 - z * z))
        return mp.exp(-2 * z * mp.acosh(z) / mp.sqrt(z * z - 1))

    low, high = mpf(0), mpf(1)
    if returned(mpf("1.0000001")) > e:
        low, high = mpf("1.0000001"), 1 / mp.sqrt(e) + 2
    elif returned(mpf("0.9999999")) < e:
        high = mpf("0.9999999")
    for _ in range(220):
        middle = (low + high) / 2
        low, high = (middle, high) if returned(middle) > e else (low, middle)
    return low


@dataclass
class Group:
    carts: list[int]
    v: mpf
    fixed: bool = False
    held: bool = False
    sliding: int = 0


class Digits:
    """One integration."""

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
            pair = Pair(contact.law, stiff, e, 2 * zeta * mp.sqrt(stiff * self._mu(k)), zeta)
            self.pairs[k] = pair
            d, s = self._overlap(k)
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
        for effect in scene.effects:
            for k in (names.index(name) for name in effect.carts):
                if effect.kind == "incline":
                    one = mpf(effect.numbers["angle"])
                    angle[k] += one
                    self.steady[k] += self.m[k] * g * mp.sin(one)
                elif effect.kind == "push":
                    end = mpf(effect.numbers.get("until", scene.until + 1))
                    row = (k, mpf(effect.numbers["from"]), end, mpf(effect.numbers["force"]))
                    self.pushes.append(row)
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

    def _mu(self, k: int) -> mpf:
        return 1 / (self._inverse(k - 1) + self._inverse(k))

    def _place(self, k: int) -> tuple[Any, Any]:
        """Series of displacement and velocity of a cart; of a wall: nothing."""
        group = self.group(k)
        return (0, 0) if group is None else (self.moved[k], group.v)

    def _overlap(self, k: int) -> tuple[mpf, mpf]:
        (xl, vl), (xr, vr) = self._place(k - 1), self._place(k)
        return -(self.gap0[k] + xr - xl), vl - vr

    def _outer(self, group: Group) -> mpf:
        total = sum((self.steady[k] for k in group.carts), mpf(0))
        for k, begin, end, force in self.pushes:
            if k in group.carts and begin <= self.t < end:
                total += force
        return total

    def _grip(self, group: Group) -> tuple[mpf, mpf]:
        both = [self.grips[k] for k in group.carts]
        return sum((a for a, _ in both), mpf(0)), sum((b for _, b in both), mpf(0))

    def _contact_force(self, group: Group) -> mpf:
        total = mpf(0)
        for k, pair in self.pairs.items():
            if pair is None or k in self.joined:
                continue
            d, s = self._overlap(k)
            a, b, c = pair.force()
            push = a * d + b * s + c
            if k - 1 in group.carts:
                total -= push
            if k in group.carts:
                total += push
        return total

    def judge(self, *, tell: bool = True) -> None:
        """Who is held, and who slides where."""
        for group in self.groups:
            _, static = self._grip(group)
            if group.fixed or not static:
                continue
            was = group.held
            if abs(group.v) <= NOTHING:
                group.v = mpf(0)
                total = self._outer(group) + self._contact_force(group)
                slips = getattr(self, "slipping", None) is group
                group.held = abs(total) <= static and not slips
                group.sliding = 0 if group.held else int(mp.sign(total))
            else:
                group.held, group.sliding = False, int(mp.sign(group.v))
            if tell and was != group.held:
                names = tuple(self.scene.carts[k].name for k in group.carts)
                self.tell("stop" if group.held else "start", names)

    def series(self) -> None:
        """Coefficients of displacement and velocity of every group."""
        self.sx = {id(g): [mpf(0)] for g in self.groups}
        self.sv = {id(g): [mpf(0) if g.held or g.fixed else g.v] for g in self.groups}
        constant = {}
        for g in self.groups:
            constant[id(g)] = self._outer(g) - g.sliding * self._grip(g)[0]
        acting = [
            (k, pair.force())
            for k, pair in self.pairs.items()
            if pair is not None and k not in self.joined and pair.state in ("press", "on", "spring")
        ]
        order = ORDER if acting else 3
        for n in range(order):
            force = {id(g): (constant[id(g)] if n == 0 else mpf(0)) for g in self.groups}
            for k, (a, b, c) in acting:
                d, s = self._term(k, n)
                push = a * d + b * s + (c if n == 0 else 0)
                for cart, way in ((k - 1, -1), (k, 1)):
                    if (g := self.group(cart)) is not None:
                        force[id(g)] += way * push
            for g in self.groups:
                still = g.held or g.fixed
                a = mpf(0) if still else force[id(g)] / self.mass(g)
                self.sx[id(g)].append(self.sv[id(g)][n] / (n + 1))
                self.sv[id(g)].append(a / (n + 1))

    def _term(self, k: int, n: int) -> tuple[mpf, mpf]:
        """n-th coefficient of overlap and rate of gap k."""
        d = s = mpf(0)
        for cart, way in ((k - 1, 1), (k, -1)):
            if (g := self.group(cart)) is not None:
                d += way * self.sx[id(g)][n]
                s += way * self.sv[id(g)][n]
        if n == 0:
            d = self._overlap(k)[0]
        return d, s

    def _series_of(self, k: int, factors: tuple[Any, Any, Any]) -> list[mpf]:
        a, b, c = (mpf(one) for one in factors)
        length = len(self.sv[id(self.groups[0])])
        found = []
        for n in range(length):
            d, s = self._term(k, n)
            found.append(a * d + b * s + (c if n == 0 else 0))
        return found

    def watches(self) -> list[tuple[list[mpf], tuple[str, Any]]]:
        found: list[tuple[list[mpf], tuple[str, Any]]] = []
        for k, pair in self.pairs.items():
            if k in self.joined:
                continue
            if pair is None:
                found.append((self._series_of(k, (-1, 0, 0)), ("hit", k)))
                continue
            for factors, state in pair.watches():
                found.append((self._series_of(k, factors), (state, k)))
        for g in self.groups:
            if g.sliding and not g.fixed:
                found.append(([g.sliding * c for c in self.sv[id(g)]], ("halt", g)))
            elif g.held:
                found += self._slips(g)
        return found

    def _slips(self, g: Group) -> list[tuple[list[mpf], tuple[str, Any]]]:
        static = self._grip(g)[1]
        total = [mpf(0)] * len(self.sv[id(g)])
        total[0] = self._outer(g)
        for k, pair in self.pairs.items():
            if pair is None or k in self.joined or not any(pair.force()):
                continue
            for cart, way in ((k - 1, -1), (k, 1)):
                if cart in g.carts:
                    total = [
                        a + way * b
                        for a, b in zip(total, self._series_of(k, pair.force()), strict=True)
                    ]
        return [
            ([(static if n == 0 else 0) - way * c for n, c in enumerate(total)], ("slip", g))
            for way in (1, -1)
        ]

    def quick(self) -> mpf:
        """s. Of one step."""
        rate = mpf(0)
        for k, pair in self.pairs.items():
            if pair is not None and k not in self.joined:
                a, b, _ = pair.force()
                light = self._inverse(k - 1) + self._inverse(k)
                rate = max(rate, mp.sqrt(a * light) + b * light)
        end = mpf(self.scene.until)
        step = mpf("0.3") / rate if rate else end / 50
        step = min(step, end - self.t)
        for _, begin, stop, _ in self.pushes:
            for at in (begin, stop):
                if at > self.t:
                    step = min(step, at - self.t)
        return step

    def go(self) -> None:
        end = mpf(self.scene.until)
        self.judge(tell=False)
        for _ in range(MOST_STEPS):
            if self.t >= end:
                return
            self.series()
            step = self.quick()
            first, what = step, None
            for coefficients, action in self.watches():
                root = _first_negative(coefficients, step)
                if root is not None and (what is None or root < first):
                    first, what = root, action
            at = self.t + first
            for g in self.groups:
                way = _value(self.sx[id(g)], first)
                for k in g.carts:
                    self.moved[k] += way
                g.v = _value(self.sv[id(g)], first)
            switched = what is None and any(at in (b, e) for _, b, e, _ in self.pushes)
            self.t = end if at >= end - NOTHING and what is None else at
            if what is not None:
                self.change(*what)
            elif switched:
                self.judge()
        raise UnsupportedError("too many steps")

    def change(self, state: str, k: Any) -> None:
        self.slipping = None
        if state == "halt":
            k.v = mpf(0)
        elif state == "slip":
            k.v = mpf(0)
            self.slipping = k
        elif state == "hit":
            self.hit(k)
        else:
            self._pair_changes(state, k)
        self.judge()

    def _pair_changes(self, state: str, k: int) -> None:
        pair = self.pairs[k]
        assert pair is not None
        names = self.scene.names_at(k)
        d, _ = self._overlap(k)
        if state == "touch":
            pair.state = "press" if pair.law == "bumper" else "on"
            self.tell("contact", names)
        elif state == "turn":
            pair.memory = d
            pair.state = "spring"
            if pair.e == 0:
                pair.state = "open"
                self.tell("separate", names)
                left, right = self.group(k - 1), self.group(k)
                if left and right and not left.fixed and not right.fixed:
                    left.v = right.v = (left.v + right.v) / 2  # differ by rounding only
        elif state == "open":
            if abs(self._overlap(k)[1]) <= NOTHING * 10**9:
                raise UnsupportedError("a contact that fades and never ends")
            lingers = pair.law.startswith("push") and d > NOTHING
            pair.state = "idle" if lingers else "open"
            self.tell("separate", names)
        elif state == "clear":
            pair.state, pair.memory = "open", mpf(0)
        else:
            raise UnsupportedError(f"{state} of {names}")

    def hit(self, k: int) -> None:
        contact, s = self.scene.contacts[k], self._overlap(k)[1]
        self.tell("contact", self.scene.names_at(k))
        left, right = self.group(k - 1), self.group(k)
        light = self._inverse(k - 1) + self._inverse(k)
        e = mpf(0) if contact.joins else mpf(contact.restitution)
        impulse = (1 + e) * s / light
        for g, way, cart in ((left, -1, k - 1), (right, 1, k)):
            if g is not None:
                g.v += way * impulse * self._inverse(cart)
                g.held = g.held  # judged next
        if contact.joins:
            self.joined.add(k)
            one = left or right
            assert one is not None
            if left and right:
                self.groups.remove(right)
                left.carts += right.carts
                left.fixed = left.fixed or right.fixed
            else:
                one.fixed = True
            if one.fixed:
                one.v = mpf(0)
            for other, pair in self.pairs.items():  # dampers are those of the bodies that now meet
                if pair is not None and other not in self.joined:
                    light = self._inverse(other - 1) + self._inverse(other)
                    pair.c = 2 * pair.zeta * mp.sqrt(pair.k / light) if light else mpf(0)


def _value(coefficients: list[mpf], t: mpf) -> mpf:
    total = mpf(0)
    for one in reversed(coefficients):
        total = total * t + one
    return total


def _first_negative(coefficients: list[mpf], step: mpf) -> mpf | None:
    """Where a polynomial that is not negative at 0 first passes through nought, up to `step`."""
    scale = max((abs(c) for c in coefficients), default=mpf(0))
    if not scale:
        return None
    if abs(coefficients[0]) <= NOTHING:
        lead = next((c for c in coefficients[1:] if abs(c) > NOTHING), mpf(0))
        if lead <= 0:
            return mpf(0) if lead < 0 else None
        coefficients = [mpf(0), *coefficients[1:]]
    elif coefficients[0] < 0:
        return mpf(0)
    before = mpf(0)
    for j in range(1, GRID + 1):
        at = step * j / GRID
        if _value(coefficients, at) < 0:
            low, high = before, at
            for _ in range(190):
                middle = (low + high) / 2
                if _value(coefficients, middle) < 0:
                    high = middle
                else:
                    low = middle
            return high
        before = at
    return None


def integrate(scene: Scene) -> Digits:
    """The end of a scene, its events, with some forty digits."""
    with mp.workdps(DIGITS):
        run = Digits(scene)
        run.go()
        return run
