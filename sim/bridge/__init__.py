"""WIRE: what the page asks and what the simulation answers."""
