"""LAWS: how two neighbours push each other while they touch; all that is known of one is here.

    __init__.py   LAW, its description: which numbers it takes, and what is refused
    law.py        make, the law itself: force, closed form, energies, what ends a part of it
    stepping.py   the force as a stepping method asks for it
    many.py       its outcome for many contacts at once, as arrays
    model.py      SIZE, its lines in the program in plain Python

A law without a duration has a description only. What several laws share stands beside the folders.
A new law is a new folder: nothing else names one. Layers: dynamics -> laws -> scene.
"""
