"""Sentences that readers see and that the numerics and the validators make.

Those know no languages. Their sentences are recognised by their form (`heard`), here and in the
page. A test runs every scene, sets wrong values, and misses no form.
"""

from sim.pages.language.say import mark

# The plan, clause by clause: sim/dynamics/report/reasons.py
PLAN = (
    mark(
        "nothing touches and no effect acts: every cart keeps its velocity, x = x₀ + v t is exact"
    ),
    mark("nothing touches and no force is left over: every cart keeps its velocity, exact"),
    mark("an impact takes no time, it is one formula"),
    mark("carts that stick together move as one"),
    mark(
        "only {pairs} in contact, and nobody else can reach them before it ends: "
        "the law {law} has a closed form, exact"
    ),
    mark("{forces} on {carts}, touched by nobody: {how}"),
    mark("linear drag fades exponentially, exact"),
    mark("quadratic drag slows as 1/t, x is a logarithm, exact"),
    mark("constant forces, x = x₀ + v t + ½ a t² is exact"),
    mark("{causes}: all of it is linear, an oscillation about its place of rest, exact"),
    mark("{causes}: a power series of order 26 in short steps, exact to rounding"),
    mark(
        "{causes}: an adaptive method of order 8 with located events, "
        "because this law has no series"
    ),
    mark("{causes} at the same time"),
    mark("{pairs} in contact, {others}"),
    mark("{pairs} in contact"),
    mark("{links} between {pairs}"),
    mark("{a} with {b}"),
    mark("asked for: step {size}, for the whole run"),
    mark("asked for: relative tolerance {size}, for the whole run"),
    mark("it is not exact"),
    mark("incline"),
    mark("left"),
    mark("right"),
)

# What to know before pressing Play: sim/dynamics/report/warnings.py
WARNINGS = (
    mark(
        "The bumpers between {one} and {other} would be squeezed by {depth}, "
        "but there is room for {room}."
    ),
    mark(
        "The bumpers between {one} and {other} would be squeezed by {depth}, "
        "but there is room for {room}. Raise the stiffness to at least {stiffness}, "
        "or let them meet at {speed} or less."
    ),
    mark(
        "The bumper between {one} and {other} would be squeezed by {depth}, "
        "but there is room for {room}."
    ),
    mark(
        "The bumper between {one} and {other} would be squeezed by {depth}, "
        "but there is room for {room}. Raise the stiffness to at least {stiffness}, "
        "or let them meet at {speed} or less."
    ),
    mark("the wall"),
    mark(
        "Several contacts held at once: there a bumper with a restitution of {e} "
        "counts as one with 0, which changes velocities by less than that part of them."
    ),
    mark(
        "The release between {one} and {other} at {time} did nothing: "
        "there were {gap} between them. Let them touch at that time."
    ),
)

# A value that does not work: sim/scene
REFUSALS = (
    mark("{number} is not a number"),
    mark("this text is too long to be a number"),
    mark("{number} is not a usable number"),
    mark("{number} is too large or too small"),
    mark("the number is too large or too small: magnitudes from 1e-50 to 1e50 can be computed"),
    mark("write a number with its unit, for example {example}"),
    mark("write a plain number, for example {example}"),
    mark("write a point for the decimals and nothing between thousands: 0.5, 1000"),
    mark("{unit} is not a unit of {quantity}"),
    mark("{quantity} takes {units}; for example {example}"),
    mark("no unit"),
    mark("{key} must be {range} (got {value})"),
    mark("for example {example}"),
    mark("more than {least}"),
    mark("restitution"),
    mark("stiffness"),
    mark("coefficient"),
    mark("angle"),
    mark("force"),
    mark("strength"),
    mark("power"),
    mark("damping"),
    mark("energy"),
    mark("time"),
    mark("number"),
    mark("greater than {least}"),
    mark("at least {least}"),
    mark("{one} and {other} overlap by {length} at the start"),
    mark("{cart} reaches into the left wall by {length} at the start"),
    mark("{cart} reaches into the right wall by {length} at the start"),
    mark("move them apart: a position is that of the cart's centre"),
    mark("{advice}; start: {overlap: true} allows it"),
    mark("{pair} are not two neighbours"),
    mark("did you mean {name}?"),
    mark("move it away from the wall: a position is that of the cart's centre"),
)

# Sliders and switches: sim/scene/controls.py, effect_controls.py
LABELS = (
    mark("mass of {cart}"),
    mark("position of {cart}"),
    mark("velocity of {cart}"),
    mark("length of {cart}"),
    mark("bumper length of {cart}"),
    mark("mass"),
    mark("position"),
    mark("velocity"),
    mark("length"),
    mark("bumper length"),
    mark("bounciness e"),
    mark("stiffness k"),
    mark("length of the track"),
    mark("end of the run"),
    mark("gravity"),
    mark("friction coefficient μ"),
    mark("friction coefficient at rest"),
    mark("angle of the track"),
    mark("drag, force per speed"),
    mark("drag, force per speed squared"),
    mark("force of the push on {cart} by {agent}"),
    mark("begin of the push on {cart} by {agent}"),
    mark("end of the push on {cart} by {agent}"),
    mark("push on {cart} by {agent}"),
    mark("stiffness of the spring"),
    mark("natural length of the spring"),
    mark("damping of the spring"),
    mark("strength of the magnets"),
    mark("power of the distance"),
    mark("energy of the exploder"),
    mark("time of the release"),
    mark("slope"),
    mark("push"),
    mark("drag"),
    mark("exploder"),
    mark("hand"),
)

# Questions before a run, where a lesson asks none of its own: sim/scene/predict.py
ASKS = (
    mark("What will happen?"),
    mark("How long is each force arrow when the bumpers are squeezed the most?"),
    mark("How does the force on {cart} change while they touch?"),
)
