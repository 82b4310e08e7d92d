"""How much of a distribution lies where: the few functions of `scipy.special` that we need.

scipy.stats would be easier and takes seconds to import in a page; these are what it is made of.
"""

from __future__ import annotations

import math


def t_two_sided(t: float, df: float) -> float:
    """Chance of a |t| this large or larger, if nothing but luck is at work."""
    from scipy.special import stdtr

    return float(2 * stdtr(df, -abs(t)))


def t_quantile(share: float, df: float) -> float:
    """The t below which this share of the distribution lies."""
    from scipy.special import stdtrit

    return float(stdtrit(df, share))


def normal_two_sided(z: float) -> float:
    """Chance of a |Z| this large or larger: erfc(|z|/√2), from the standard library."""
    return math.erfc(abs(z) / math.sqrt(2))


def normal_inside(z: float) -> float:
    """Chance of a |Z| that is smaller: what the paper prints as P. It is 1 − p."""
    return math.erf(abs(z) / math.sqrt(2))
