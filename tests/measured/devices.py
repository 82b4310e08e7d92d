"""Files as devices write them, with their troubles, of a motion that is known in closed form.

Velocities go from before to after along a smooth step; nothing of sim.measured or of the simulator
is used. By construction m_A Δv_A = −m_B Δv_B.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random


@dataclass(frozen=True, kw_only=True)
class Motion:
    """Two carts: velocities before, mass ratio B : A, e; A on the left. SI."""

    v: tuple[float, float] = (0.15, -0.02)
    ratio: float = 1.3
    e: float = 0.8
    touch: float = 1.5
    lasts: float = 0.1
    until: float = 3.0
    brake: float = 0.005
    push: float = 0.0  # s: a hand sets A going from rest until then
    apart: float = 0.0  # m/s: parts like this if nothing approaches

    @property
    def after(self) -> tuple[float, float]:
        a, b = self.v
        share = self.ratio / (1.0 + self.ratio)  # of B
        middle = (1.0 - share) * a + share * b
        parting = self.apart or self.e * (a - b)
        return middle - share * parting, middle + (1.0 - share) * parting

    def velocity(self, cart: int, t: float) -> float:
        before, after = self.v[cart], self.after[cart]
        brake = -math.copysign(self.brake, before) * (t - self.touch) if before else 0.0
        if t > self.touch:
            brake = -math.copysign(self.brake, after) * (t - self.touch) if after else 0.0
        if cart == 0 and self.push:
            before *= _step((t - self.push + 0.15) / 0.15)
            brake = brake if t > self.push else 0.0
        return before + (after - before) * _step((t - self.touch) / self.lasts + 0.5) + brake

    def places(self, cart: int, times: list[float]) -> list[float]:
        """m. 0.15 apart at the touch, so that they never pass through each other."""
        fine = [k * 2e-3 for k in range(int(min(self.touch, self.until) / 2e-3))]
        come = sum(2e-3 * self.velocity(cart, t + 1e-3) for t in fine if t >= times[0])
        x, out, last = (0.5, 0.65)[cart] - come, [], times[0]
        for t in times:
            pieces = max(1, math.ceil((t - last) / 2e-3))
            width = (t - last) / pieces
            for k in range(pieces):
                x += width * self.velocity(cart, last + (k + 0.5) * width)
            out.append(x)
            last = t
        return out


def _step(s: float) -> float:
    s = min(max(s, 0.0), 1.0)
    return s**3 * (10.0 - 15.0 * s + 6.0 * s * s)


def alike(random: Random, count: int, size: float, rho: float = 0.9) -> list[float]:
    """Noise whose neighbours are alike."""
    out, last = [], 0.0
    for _ in range(count):
        last = rho * last + math.sqrt(1.0 - rho * rho) * random.gauss(0.0, size)
        out.append(last)
    return out


def motion_capture(
    made: Motion, seed: int = 1, hidden: tuple[int, ...] = (), swapped: int | None = None,
    empty: tuple[int, ...] = (),
) -> str:  # fmt: skip
    """Qualisys' TSV; frames in `hidden` lack the first marker, those in `empty` both; from
    `swapped` on names change."""
    random, rate = Random(seed), 250.0
    times = [k / rate for k in range(int(made.until * rate))]
    carts = [made.places(k, times) for k in (0, 1)]
    noise = [alike(random, len(times), 2e-5) for _ in range(2)]
    lines = ["FILE_VERSION\t2.0.0", f"NO_OF_FRAMES\t{len(times)}", "NO_OF_MARKERS\t2",
             f"FREQUENCY\t{rate:g}", "TIME_STAMP\t2026-01-01, 10:00:00.000\t1.0",
             "MARKER_NAMES\tNew 0000\tNew 0001",
             "TRAJECTORY_TYPES\tMeasured\tMeasured"]  # fmt: skip
    for k in range(len(times)):
        row = []
        for cart in (0, 1):
            s = 1000.0 * (carts[cart][k] + noise[cart][k])
            point = (0.8 * s + 20.0, 0.6 * s + 400.0, 398.0 + random.gauss(0.0, 0.02))
            row.append("\t".join(f"{c:.3f}" for c in point))
        if k in hidden:
            row[0] = "0.000\t0.000\t0.000"
        if k in empty:
            row = ["\t\t", "\t\t"]
        if swapped is not None and k >= swapped:
            row.reverse()
        lines.append("\t".join(row))
    return "\n".join(lines) + "\n"


def sensor_carts(
    made: Motion, seed: int = 1, lost: float | None = None, stop: float | None = None
) -> str:
    """A log at 20 Hz: zeros of their own, B's axis turned; A is lost `lost` m after its start, and
    an end stop holds both at `stop` s."""
    random = Random(seed)
    times = [0.05 * (k + 1) for k in range(int(made.until * 20))]
    carts = [made.places(k, times) for k in (0, 1)]
    rows = []
    for cart, sign in ((0, 1.0), (1, -1.0)):
        x = [sign * (value - carts[cart][0]) for value in carts[cart]]
        if stop is not None:
            held = next(k for k, t in enumerate(times) if t >= stop)
            x = x[:held] + [x[held]] * (len(x) - held)
        if lost is not None and cart == 0:
            x = [min(value, lost) for value in x]
        x = [round((value + random.gauss(0.0, 1e-4)) / 1.715e-4) * 1.715e-4 for value in x]
        v = [(x[min(k + 1, len(x) - 1)] - x[max(k - 1, 0)]) / 0.1 for k in range(len(x))]
        rows += [x, v, [0.0] * len(x)]
    head = ["Time (s)"]
    head += [f"{what} {n} ({unit})" for n in (1, 2)
             for what, unit in (("Position", "m"), ("Velocity", "m/s"), ("Acceleration", "m/s²"))
             ]  # fmt: skip
    lines = ['\ufeff"' + '","'.join(head) + '"']
    for k, t in enumerate(times):
        lines.append(",".join(f"{value:.12g}" for value in (t, *(row[k] for row in rows))))
    return "\n".join(lines) + "\n"


def tracker_project(made: Motion, seed: int = 1, scale: float = 800.0) -> str:
    """A .trk at 60 frames per second, axes turned by 2 degrees, some frames without a mark."""
    random, rate = Random(seed), 60.0
    frames = [k for k in range(int(made.until * rate)) if k % 37 != 5]
    cos, sin = math.cos(math.radians(2.0)), math.sin(math.radians(2.0))
    tracks = []
    for cart in (0, 1):
        marks = []
        for n, x in zip(frames, made.places(cart, [n / rate for n in frames]), strict=True):
            along = scale * x + random.gauss(0.0, 0.4)
            place = (100.0 + along * cos, 300.0 - along * sin)
            marks.append(
                f'<property name="[{n + 7}]" type="object"><object class='
                '"org.opensourcephysics.cabrillo.tracker.PointMass$FrameData">'
                + "".join(f'<property name="{c}" type="double">{p:.4f}</property>'
                          for c, p in zip("xy", place, strict=True))
                + "</object></property>"
            )  # fmt: skip
        tracks.append(
            '<property name="item" type="object"><object class="org.opensourcephysics.cabrillo.'
            f'tracker.PointMass"><property name="name" type="string">{"AB"[cart]}</property>'
            '<property name="framedata" type="array">\n' + "\n".join(marks)
            + "</property></object></property>"
        )  # fmt: skip
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<object class="org.opensourcephysics.cabrillo.'
        'tracker.TrackerPanel">\n<property name="videoclip" type="object"><object class='
        '"org.opensourcephysics.media.core.VideoClip"><property name="startframe" type="int">7'
        "</property></object></property>\n"
        '<property name="clipcontrol" type="object"><object><property name="delta_t" '
        f'type="double">{1000.0 / rate}</property></object></property>\n'
        '<property name="coords" type="object"><object class="org.opensourcephysics.media.core.'
        'ImageCoordSystem"><property name="framedata" type="array"><property name="[0]" '
        'type="object"><object class="org.opensourcephysics.media.core.ImageCoordSystem$FrameData">'
        '<property name="xorigin" type="double">100.0</property>'
        '<property name="yorigin" type="double">300.0</property>'
        '<property name="angle" type="double">2.0</property>'
        f'<property name="xscale" type="double">{scale}</property></object></property></property>'
        "</object></property>\n"
        '<property name="length_unit" type="string">m</property>\n'
        '<property name="tracks" type="collection">\n' + "\n".join(tracks)
        + "</property>\n</object>\n"
    )  # fmt: skip


def phone(made: Motion, cart: int, seed: int = 1, clock: float = 0.0) -> str:
    """phyphox' CSV of a phone on a cart, lying askew; `clock`: s that its zero is earlier."""
    random = Random(seed)
    lines = ["Time (s),Linear Acceleration x (m/s^2),Linear Acceleration y (m/s^2),"
             "Linear Acceleration z (m/s^2),Absolute acceleration (m/s^2)"]  # fmt: skip
    for k in range(int(made.until * 200)):
        t = k / 200
        a = (made.velocity(cart, t + 5e-4) - made.velocity(cart, t - 5e-4)) / 1e-3
        part = [0.6 * a, 0.8 * a, 0.0]
        part = [value + random.gauss(0.0, 0.01) for value in part]
        size = math.hypot(*part)
        lines.append(",".join(f"{value:.9f}" for value in (t + clock, *part, size)))
    return "\ufeff" + "\n".join(lines) + "\n"
