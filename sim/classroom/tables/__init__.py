"""Anybody's marks, read from a table; what programs export has a module each in `exports/`."""
