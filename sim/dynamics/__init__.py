"""NUMERICS: from a described scene to a finished run.

    loop -> motion -> state        the run, the motions it goes from one to the next, what moves
    report -> result -> state      in words and JSON, what a run leaves behind
    batch, stepping, cost          many runs at once, common methods beside ours, what each costs

Standard library only; numpy and scipy are imported in the functions that need them. How it works:
docs/developers/dynamics.md.
"""
