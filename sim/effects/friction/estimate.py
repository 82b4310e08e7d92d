"""friction, as large as it was on real carts."""

from sim.effects.estimates import Estimate
from sim.scene.said import said

ESTIMATE = Estimate(
    numbers={"coefficient": 0.006},
    size="μ = 0.006",
    source=said("carts on wheels in the lesson Real carts: 0.058 m/s² of 9.81 m/s²"),
)
