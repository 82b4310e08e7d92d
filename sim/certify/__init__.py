"""CERTIFICATES: an interval for every event time and every end state that provably holds the truth.

Every number is a ball [middle ± radius] of Arb, or an interval of decimals; each operation rounds
outwards, so that the ball of a result holds the result of every choice from the balls that went in
(Moore's inclusion property). A run in balls is therefore a proof, if every branch that it takes is
proved too: which event comes first, whether two bodies meet at all, which way a cart slides. Where
a ball does not decide, the certificate says so instead of guessing: `NotProvableError`.

    numbers       arithmetic (balls of Arb, or intervals where it is not installed), balls (exact
                  inputs, signs that are proved), roots (the first zero of a function)
    oscillation   the overlap of a linear contact, in closed form
    damping       the damping of a law from the restitution that it returns
    equations     a row of bodies that push each other
    series        its Taylor series with a proved remainder
    signals       what is linear in its state; transport: later pieces of it, without wrapping
    loads         forces on single carts: slope, friction, pushes, linear drag; springs
    inputs        the scene's doubles, or what their tolerances allow
    instants      times whose differences are known better than the times
    bodies        what moves, and what is between two neighbours
    phases        one branch of a contact of a pair, until something ends it
    coupled       the same of a longer row, or of carts with springs and in air
    watches       what can end that
    touches       the stages of a contact law; impacts: without a duration
    peaks         when a contact pushes most
    row           all of it at one moment
    foresight     what comes next
    order         what of it is provably first
    forming       what is pressed together, and which motion moves it
    contacts, run what then happens
    certificate   the interface: text bounds, order, reason
    band          what tolerances allow, piece by piece

Theory: R. E. Moore, Interval Analysis (1966); S. M. Rump, Verification methods, Acta Numerica 19
(2010) 287; F. Johansson, Arb: efficient arbitrary-precision midpoint-radius interval arithmetic,
IEEE Trans. Comput. 66 (2017) 1281. Nothing of `sim.dynamics` is used: an error there does not show
up here again. A page loads all of it when a reader asks for a proof, and not before.
"""
