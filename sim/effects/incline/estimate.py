"""incline, of a track that was levelled with care."""

import math

from sim.effects.estimates import Estimate
from sim.scene.said import said

ESTIMATE = Estimate(
    numbers={"angle": math.radians(0.1)},
    size="0.1°",
    source=said("1.7 mm in 1 m: what a spirit level and patience leave"),
)
