"""EFFECTS: what may act on carts besides contacts; all that is known of one is in its folder.

    __init__.py   KIND, its description: fields with units and bounds, rules, names
    force.py      act, its forces, energies and times; imported only where a scene lists it
    model.py      PIECE, its lines in the program in plain Python; imported when asked for
    estimate.py   optional: its usual size where a scene leaves it out, and the source
    constant.py   optional: what is constant of its force, for proofs (`carts run --certify`)
    linear.py     optional: what is linear of it in place and velocity, for the same
    largest.py    optional: how large its force becomes, where a picture's scale asks before a run
    page.md       its page of the docs
    scenes/       scenes that show it; tests, gallery and pages find them by name
    proof.py      the force written down a second time, for the tests' independent oracle
    view.js       how it is drawn; without one it gets arrows with its agent's name

A new effect is a new folder: nothing else names one. Layers: dynamics -> effects -> scene.
"""
