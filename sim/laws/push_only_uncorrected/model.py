"""push-only-uncorrected, in the program in plain Python: as push-only."""

from sim.laws.push_only.model import SIZE

__all__ = ["SIZE"]
