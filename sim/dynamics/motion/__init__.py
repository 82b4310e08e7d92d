"""Motions until something ends them: flights, pairs, coupled groups, each a formula in time."""
