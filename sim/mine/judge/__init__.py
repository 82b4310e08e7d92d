"""THE JUDGE: looks for a scene in which a law breaks what every force between two bodies keeps.

    chance.py    the same random numbers everywhere
    scenes.py    two carts on an open track, at random or near a scene that is bad already
    trial.py     one such scene run: as it is, seen from a train, in a mirror, with names exchanged
    checks.py    the six laws, each a number of a trial: nought where it is kept
    search.py    trials within a budget of questions, the worst of each law
    verdict.py   what came out, as values and sentences
    as_yaml.py   a scene as an author would write it

Everything is a function of the law's text, a seed and a budget counted in questions to the law.
"""
