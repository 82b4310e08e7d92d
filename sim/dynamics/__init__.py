"""NUMERICS: from a described scene to a finished run.

`run` is the loop, `report` what comes out. Standard library only; numpy and scipy are imported in
the functions that need them. How it works: docs/developers/dynamics.md.
"""
