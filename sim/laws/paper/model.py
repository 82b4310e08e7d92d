"""paper, in the program in plain Python: `size` [N] from overlap d [m] and its rate s [m/s]."""

SIZE = """\
size = stiffness * d + c * s
"""
