"""LAWS THAT SOMEBODY WROTE: a function `force` in Python, run in a scene, and judged.

    arguments.py   what a function may ask for by the name of an argument
    allowed.py     which Python a law may use: numbers, loops that end, the module math
    bounded.py     its operators, where they could grow; growing.py: the bounds
    instance.py    from a text to a function that answers, or says at which line it went wrong
    contact.py     one pair's force as a stepping method asks for it, each side asked for itself
    field.py       the forces of a scene with it
    embedded.py    steps that follow a tolerance (Dormand & Prince), events located
    follow.py      a run; document.py: the run as one JSON object
    judge/         the search for a scene in which the law breaks what every force must keep

A scene names the file (`contact: {law: mine.py}`) and carries its text (`laws: {mine.py: …}`).
Nothing of it is imported, evaluated or shipped where no scene does.
Layers: bridge, pages, cli -> mine -> dynamics -> effects, laws -> scene.
"""
