"""CERTIFICATES: an interval for every event time and every end state that provably holds the truth.

Every number is a ball [middle ± radius] of Arb, or an interval of decimals; each operation rounds
outwards, so that the ball of a result holds the result of every choice from the balls that went in
(Moore's inclusion property). A run in balls is therefore a proof, if every branch that it takes is
proved too: which event comes first, whether two bodies meet at all, which way a cart slides. Where
a ball does not decide, the certificate says so instead of guessing: `NotProvableError`.

    arithmetic    balls of Arb, or intervals where it is not installed
    intervals     their arithmetic; rounding: to which side; waves: sines and π
    balls         exact inputs, proofs of signs, bounds that are rounded outwards
    roots         the first zero of a function, isolated by the sign of its derivative
    oscillation   the overlap of a linear contact, in closed form
    damping       the damping of a law from the restitution that it returns
    loads         forces on single carts: slope, friction, pushes
    inputs        the scene's doubles, or what their tolerances allow
    instants      times whose differences are known better than the times
    bodies        what moves, and what is between two neighbours
    phases        one branch of a contact, until something ends it
    touches       the stages of a contact law, impacts
    row           all of it at one moment
    foresight     what comes next, and what of it is provably first
    contacts, run    what then happens
    certificate   the interface: text bounds, order, reason
    band          what tolerances allow, piece by piece

Theory: R. E. Moore, Interval Analysis (1966); S. M. Rump, Verification methods, Acta Numerica 19
(2010) 287; F. Johansson, Arb: efficient arbitrary-precision midpoint-radius interval arithmetic,
IEEE Trans. Comput. 66 (2017) 1281. Nothing of `sim.dynamics` is used: an error there does not show
up here again. A page loads all of it when a reader asks for a proof, and not before.
"""
