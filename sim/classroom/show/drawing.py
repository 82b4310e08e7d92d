"""Plots of a report as SVG: no script, no style of their own, so that page and print can set it.

Every plot stands beside the table it shows, so a screen reader gets a name and skips the drawing.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.classroom.show.html_parts import Tell
from sim.scene.said import counted, said, template

WIDTH = 620
_LEFT, _RIGHT = 150, 24
_ROW = 46
_DOT = 3.2
_LETTER = re.compile(r"&[#\w]+;|.", re.DOTALL)


def dots(
    rows: Sequence[tuple[str, Sequence[float], float, float | None]], of: float, tell: Tell
) -> str:
    """One line for each list of totals: a dot per student, the mean, and its interval's half.

    `rows`: name, totals, mean, half width of the interval (None: not computed).
    """

    def x(mark: float) -> float:
        return _LEFT + (WIDTH - _LEFT - _RIGHT) * mark / of

    parts, y = [], 14.0
    for name, totals, mean, half in rows:
        stacked: dict[float, int] = {}
        most = max((sum(t == other for other in totals) for t in set(totals)), default=1)
        step = min(2.2 * _DOT, 30 / most)
        height = max(_ROW, 20 + step * most)
        base = y + height - 16
        parts.append(_text(8, base + 4, _cut(tell(name)), "name"))
        for total in totals:
            level = stacked.get(total, 0)
            stacked[total] = level + 1
            parts.append(
                f'<circle cx="{x(total):.1f}" cy="{base - 8 - step * level:.1f}" r="{_DOT}"/>'
            )
        if half is not None:
            low, high = max(0.0, mean - half), min(of, mean + half)
            parts.append(f'<path class="interval" d="M{x(low):.1f} {base:.1f}H{x(high):.1f}"/>')
        parts.append(f'<path class="mean" d="M{x(mean):.1f} {base - 5:.1f}v10"/>')
        y += height
    parts += _axis(x, y, of, tell)
    label = f"{tell(template('Marks of each student, with means:'))} "
    label += ", ".join(tell(name) for name, *_ in rows)
    return _figure("".join(parts), y + 34, label)


def bars(
    rows: Sequence[tuple[str, Sequence[tuple[str, float]]]], shown: Sequence[str], tell: Tell
) -> str:
    """Share of right answers for each item, one bar for each form in `shown`."""

    def x(share: float) -> float:
        return _LEFT + (WIDTH - _LEFT - _RIGHT) * share

    parts, y, thick = [], 10.0, 9
    for name, shares in rows:
        height = thick * max(1, len(shares)) + 9
        parts.append(_text(8, y + height / 2, _cut(tell(name)), "name"))
        for k, (form, share) in enumerate(shares):
            series = shown.index(form)
            parts.append(
                f'<rect class="series-{series}" x="{x(0):.1f}" y="{y + thick * k:.1f}" '
                f'width="{max(0.8, x(share) - x(0)):.1f}" height="{thick - 1}"/>'
            )
        y += height
    for k, form in enumerate(shown if len(shown) > 1 else []):
        at = _LEFT + 110 * k
        parts.append(f'<rect class="series-{k}" x="{at}" y="{y + 36:.1f}" width="10" height="10"/>')
        parts.append(_text(at + 16, y + 45, tell(form), "key"))
    axis = [
        f'<path class="axis" d="M{x(0):.1f} {y:.1f}H{x(1):.1f}"/>',
        *(
            f'<path class="axis" d="M{x(k / 4):.1f} {y:.1f}v5"/>'
            + _text(x(k / 4), y + 19, f"{25 * k} %", "tick")
            for k in range(5)
        ),
    ]
    label = f"{tell(template('Share of right answers for each question:'))} "
    label += ", ".join(map(tell, shown))
    return _figure("".join([*parts, *axis]), y + (54 if len(shown) > 1 else 28), label)


def curves(drawn: Sequence[Sequence[float]], tell: Tell, highest: float = 10.0) -> str:
    """Curves of a class over each other: many equal ones make a dark line."""
    width, height, left, top = 360, 150, 40, 10
    signed = any(h < 0 for heights in drawn for h in heights)
    lowest = -highest if signed else 0.0
    paths = []
    for heights in drawn:
        step = (width - left - 10) / (len(heights) - 1)
        shares = [(highest - min(max(h, lowest), highest)) / (highest - lowest) for h in heights]
        points = " ".join(
            f"{left + k * step:.1f} {top + (height - 40) * share:.1f}"
            for k, share in enumerate(shares)
        )
        paths.append(f'<path class="drawn" d="M{points}"/>')
    base = top + height - 40
    zero = top + (base - top) / 2 if signed else base
    axis = f'<path class="axis" d="M{left} {top}V{base}M{left} {zero}H{width - 10}"/>'
    words = [
        _text(left, base + 18, tell(template("begin")), "key"),
        _text(width - 40, base + 18, tell(template("end")), "key"),
        _text(8, top + 8, tell(template("large")), "key"),
        _text(8, zero + 4, "0", "key"),
    ]
    label = tell(counted("1 drawn curve", "{n} drawn curves over each other", n=len(drawn)))
    content = "".join([axis, *paths, *words])
    return (
        f'<svg class="carts-class-plot carts-class-curves" role="img" aria-label="{label}" '
        f'viewBox="0 0 {width} {height}" xmlns="http://www.w3.org/2000/svg">{content}</svg>'
    )


def _axis(x: object, y: float, of: float, tell: Tell) -> list[str]:
    assert callable(x)
    steps = (s * 10**k for k in range(309) for s in (1, 2, 5))  # up to the largest float
    step = next(s for s in steps if of / s <= 12)
    marks = [step * k for k in range(int(of // step) + 1)]
    return [
        f'<path class="axis" d="M{x(0):.1f} {y:.1f}H{x(of):.1f}"/>',
        *(
            f'<path class="axis" d="M{x(m):.1f} {y:.1f}v5"/>' + _text(x(m), y + 19, str(m), "tick")
            for m in marks
        ),
        _text(8, y + 19, tell(said("marks, of {of}", of=f"{of:g}")), "key"),
    ]


def _text(x: float, y: float, html: str, role: str) -> str:
    return f'<text class="{role}" x="{x:.1f}" y="{y:.1f}">{html}</text>'


def _cut(html: str) -> str:
    """A name that is escaped already, not longer than the space beside the drawing."""
    letters = _LETTER.findall(html)
    return html if len(letters) <= 20 else f"{''.join(letters[:19])}…"


def _figure(content: str, height: float, label: str) -> str:
    return (
        f'<svg class="carts-class-plot" role="img" aria-label="{label}" '
        f'viewBox="0 0 {WIDTH} {height:.0f}" xmlns="http://www.w3.org/2000/svg">{content}</svg>'
    )
