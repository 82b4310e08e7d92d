"""What rounding leaves of a number that is known as well as floats allow."""

LAST_BIT = 4e-16
"""Relative: the last bit of a float, or two of them. No search comes nearer than that."""

LAST_BITS = 1e-15
"""Relative: what a few operations leave."""

AS_FAST = 1e-12
"""Relative. Closing speeds that differ by rounding are equal."""
