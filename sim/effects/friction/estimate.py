"""friction, as large as is usual for carts on wheels: assumed, not measured here."""

from sim.effects.estimates import Estimate
from sim.scene.said import said

ESTIMATE = Estimate(
    numbers={"coefficient": 0.006},
    size="μ = 0.006",
    source=said(
        "assumed: usual for carts on wheels are 0.005 to 0.05, on an air track 0.0005 to 0.002"
    ),
)
