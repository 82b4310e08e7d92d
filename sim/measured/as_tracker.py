"""A motion of two carts as the text that Tracker exports, which Tracker and spreadsheets read."""

from __future__ import annotations

from collections.abc import Sequence


def tracker_text(names: Sequence[str], times: Sequence[float],
                 places: Sequence[Sequence[float]]) -> str:  # fmt: skip
    """Both carts as Tracker exports several tracks, tab between columns; `places` by cart, m."""
    lines = ["#multi:", "\t" + "".join(f"{name.replace(' ', '_')}\t\t" for name in names)]
    lines.append("t\t" + "x\ty\t" * len(names))
    for k, t in enumerate(times):
        cells = [_scientific(t)]
        for track in places:
            cells += [_scientific(track[k]), _scientific(0.0)]
        lines.append("\t".join(cells) + "\t")
    return "\n".join(lines) + "\n"


def _scientific(value: float) -> str:
    """3.200000000E-2, as Tracker writes it."""
    mantissa, exponent = f"{value:.9E}".split("E")
    return f"{mantissa}E{int(exponent)}"
