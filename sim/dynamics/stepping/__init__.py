"""Common step-by-step methods beside the exact solver, to show what accuracy costs in time.

Nothing of a scene's default run comes from here. One right-hand side (`field`) is built from the
scene once, with all contact laws and effects; each method is a class of its own:

    euler, semi-implicit, verlet, rk4   fixed steps that know nothing of touches, as game engines
    rk4-events, rk45, adaptive               the same scene with every touch located (`located`)
"""
