"""hertz, in the program in plain Python: `size` [N] from overlap d [m] and its rate s [m/s]."""

SIZE = """\
size = stiffness * d**1.5 + c * d**0.25 * s
"""
