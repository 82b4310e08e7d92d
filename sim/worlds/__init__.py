"""WORLDS: what would be seen if a belief about forces were true. None of them exists.

    describe.py   what a lesson may name: kinds of worlds, and how `worlds:` is read
    kinds/        one module a world: its belief, its words, its forces
    force.py      what a world can change: shares of a push, its delay, a resistance, the walls
    field.py      the forces of a scene with that change booked under the world's name
    follow.py     located steps through such a scene, and the run
    breaks.py     which laws the run has broken, and by how much

Nothing of it is imported, evaluated or shipped where no scene names a world. What a run of one
gives says `impossible`. Layers: bridge, cli -> worlds -> dynamics -> effects, laws -> scene.
"""
