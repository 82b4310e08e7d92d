"""push-only, in the program in plain Python: `size` [N] from overlap d [m] and its rate s [m/s]."""

SIZE = """\
size = max(0.0, stiffness * d + c * s)
"""
