"""REAL CARTS: readings of a class's own carts, laid over the model and fitted by it.

Nothing here knows where a file comes from. Reading, the model and its sentences need the standard
library alone; numpy and scipy are imported in the functions that fit.
"""
