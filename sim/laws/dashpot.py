"""paper, push-only, push-only-uncorrected: a linear spring beside a linear damper.

    N = k d + c d' ,   c = 2 zeta sqrt(k mu) ,   while in contact;   zeta = cos phi

`paper` is equation (3) of the paper with its slips mended (sign, rest length, contact
condition). The contact lasts until the overlap is zero again; the force jumps to c u at touch
and pulls at the end. With L = −ln e:

    phi = atan2(pi, L)     duration = pi / (w0 sin phi)     separation speed e u, exactly

`push-only` ends when N would turn negative, with the damping raised so that e is still
delivered: phi cot phi = L/2 (y coth y = L/2 with phi = i y beyond critical damping; 0 < e <= 1).
`push-only-uncorrected` ends there too, but keeps the damping of the printed formula, and so
delivers more than was asked for: exp(−2 phi cot phi). Both leave an overlap at separation.

    duration = 2 phi / (w0 sin phi)     overlap left 2 zeta e u / w0

phi is stored rather than zeta: sqrt(1 − zeta²) would cancel for small e. Sources: Schwager &
Pöschel, Granular Matter 9 (2007) 465, for the end of contact; the half-angle form is ours.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, ClassVar

from sim.laws.branch import Branch
from sim.laws.contact_law import IsolatedContact, Memory
from sim.laws.damped_oscillation import Rate
from sim.laws.rounding import LAST_BIT

SERIES_BELOW = 1e-2
"""|phi²|. Below it sqrt(q) cot sqrt(q) is summed as a series: five terms leave less than 1e-16."""


@dataclass(frozen=True, slots=True)
class Damping:
    """zeta and the functions of phi that every formula needs; beyond critical phi is i y.

    `sinc` is sin(phi)/phi (sinh(y)/y), `sine` is sin(phi) (sinh(y)); both 1 and 0 at critical.
    """

    square: float  # phi², negative beyond critical damping
    zeta: float
    sinc: float
    sine: float

    def rate(self, stiffness: float, mu: float) -> Rate:
        """Rates of the oscillation for one pair."""
        w0 = math.sqrt(stiffness / mu)
        if self.square == 0.0:
            return Rate(w0, w0, 0.0, "critical")
        return Rate(w0, w0 * self.zeta, w0 * self.sine, "under" if self.square > 0.0 else "over")


def damping(square: float) -> Damping:
    """From phi² = `square`."""
    if square > 0.0:
        phi = math.sqrt(square)
        return Damping(square, math.cos(phi), math.sin(phi) / phi, math.sin(phi))
    if square == 0.0:
        return Damping(0.0, 1.0, 1.0, 0.0)
    y = math.sqrt(-square)
    return Damping(square, math.cosh(y), math.sinh(y) / y, math.sinh(y))


def damping_to_zero_overlap(e: float) -> Damping:
    """Damping that returns e when the contact ends at overlap zero; e = 0 is critical."""
    if e == 0.0:
        return damping(0.0)
    if e == 1.0:
        return Damping((math.pi / 2) ** 2, 0.0, 2.0 / math.pi, 1.0)
    return damping(math.atan2(math.pi, -math.log(e)) ** 2)


def damping_to_zero_force(e: float) -> Damping:
    """Damping that returns e > 0 when the contact ends at force zero: solves phi cot phi = L/2."""
    if e == 1.0:
        return Damping((math.pi / 2) ** 2, 0.0, 2.0 / math.pi, 1.0)
    wanted = -0.5 * math.log(e)
    q = (math.pi / 2) ** 2 * (1.0 - wanted) if wanted < 2.0 else -(wanted * wanted)
    for _ in range(60):  # Newton on a convex, falling function: monotone after one step
        value, slope = _q_cot(q)
        step = (value - wanted) / slope
        q -= step
        if abs(step) <= LAST_BIT * max(abs(q), 1e-3):
            break
    return damping(q)


def q_cot_near_nought(q: Any) -> tuple[Any, Any]:
    """The same by its series, for a number or an array."""
    f = 1 - q * (1 / 3 + q * (1 / 45 + q * (2 / 945 + q * (1 / 4725 + q * 2 / 93555))))
    df = -(1 / 3 + q * (2 / 45 + q * (6 / 945 + q * (4 / 4725 + q * 10 / 93555))))
    return f, df


def _q_cot(q: float) -> tuple[float, float]:
    """f(q) = sqrt(q) cot sqrt(q) and df/dq, for q of either sign."""
    if abs(q) < SERIES_BELOW:
        return q_cot_near_nought(q)
    if q > 0:
        phi = math.sqrt(q)
        cot = 1.0 / math.tan(phi)
        return phi * cot, 0.5 * (cot / phi - 1.0 - cot * cot)
    y = math.sqrt(-q)
    coth = 1.0 / math.tanh(y)
    return y * coth, -0.5 * (coth / y + 1.0 - coth * coth)


@dataclass(frozen=True, slots=True, eq=False)
class Dashpot:
    """What the three laws share: one linear stretch. Subclasses say when it ends."""

    linear: ClassVar[bool] = True
    held_below: ClassVar[float] = 0.0
    grows: ClassVar[tuple[float, float]] = (2.0, 1.0)
    stiffness: float
    e: float
    damping: Damping = field(init=False)

    def _greatest_force(self, w0: float, mu: float) -> tuple[float, float, float]:
        """Time, N and d' of the greatest force from first touch at 1 m/s."""
        d = self.damping
        if d.zeta >= 0.5:  # the force only falls from its jump at touch
            return 0.0, 2.0 * d.zeta * math.sqrt(self.stiffness * mu), 1.0
        angle = 3.0 * math.sqrt(d.square) - math.pi
        fade = math.exp(-d.zeta / d.sine * angle)
        return angle / (w0 * d.sine), math.sqrt(self.stiffness * mu) * fade, 2.0 * d.zeta * fade

    def figures_from(
        self, mu: float, duration: float, e: float, out_overlap: float, last_force: float = 0.0
    ) -> IsolatedContact:
        """Those of a law whose contact ends then, so fast and with that overlap left."""
        w0 = math.sqrt(self.stiffness / mu)
        peak_time, peak_force, peak_rate = self._greatest_force(w0, mu)
        d = self.damping
        return IsolatedContact(
            duration=duration,
            e=e,
            out_overlap=out_overlap,
            peak_time=peak_time,
            peak_force=peak_force,
            peak_rate=peak_rate,
            peak_overlap=math.exp(-d.zeta / d.sinc) / w0,
            first_force=2.0 * d.zeta * math.sqrt(self.stiffness * mu),
            last_force=last_force,
        )

    def damper(self, mu: float) -> float:
        """c in N s/m."""
        return 2.0 * self.damping.zeta * math.sqrt(self.stiffness * mu)

    def force(self, mu: float, d: float, v: float) -> float:
        """N at overlap d and rate v, not clipped."""
        return self.stiffness * d + self.damper(mu) * v

    def resting_overlap(self, memory: Memory) -> float:
        """These laws remember nothing."""
        return 0.0

    def stored(self, d: float, v: float, memory: Memory) -> float:
        """The spring's energy."""
        return 0.5 * self.stiffness * d * d

    def remember(self, d: float, memory: Memory) -> Memory:
        """Nothing to remember."""
        return 0.0

    @property
    def steepest(self) -> float:
        """It has one line."""
        return self.stiffness

    def branch(self, mu: float, d: float, v: float, memory: Memory, *, pressing: bool) -> Branch:
        """The only one."""
        return Branch(self.stiffness, self.damper(mu), 0.0)

    def stored_under(self, d: float, force: float) -> float:
        """k d²/2, while a damper pulls too."""
        return 0.5 * self.stiffness * d**2 if force else 0.0

    def dissipated(self, mu: float, d: float, v: float) -> float:
        """c v²: asked of curved laws only."""
        return self.damper(mu) * v * v

    def kept(self, branch: Branch, start: float, end: float) -> float:
        """Its damper takes, nothing else."""
        return 0.0
