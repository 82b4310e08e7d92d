"""bumper, in the program in plain Python: `size` [N] from overlap d [m] and its rate s [m/s]."""

SIZE = """\
back = stiffness / e**2 if e > 0 else 0.0  # more steeply: e² of the energy comes back
if d == deepest[k]:
    size = stiffness * d
else:
    size = max(0.0, back * (d - (1 - e**2) * deepest[k]))
"""
