"""Runs that are computed when the site is built: what sliders go by where Python cannot start.

`grid` chooses the values, `pack` runs them and makes the scripts that the page loads when a reader
first moves a slider before Python answers, or after it has failed.
"""

from sim.pages.prepared.grid import Grid, grid_of
from sim.pages.prepared.pack import FOLDER, MOST_BYTES, Prepared, prepare

__all__ = ["FOLDER", "MOST_BYTES", "Grid", "Prepared", "grid_of", "prepare"]
