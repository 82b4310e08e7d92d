"""drag, of a box as large as the front of a cart: c = ½ ρ C A."""

from sim.effects.estimates import Estimate
from sim.scene.said import said

ESTIMATE = Estimate(
    numbers={"quadratic": 0.006},
    size="c = 0.006 kg/m",
    source=said("½ ρ C A: air of 1.2 kg/m³, C = 1 as of a box, a front of 10 cm × 10 cm"),
)
