"""Contact laws: how two neighbours push each other while they touch.

Each law is a file with its formula on top. A law of finite duration gives

* `Figures`, what one isolated contact from first touch comes to, per unit of approach speed
  (every law here is linear, so all of it scales with that speed), and
* `stretches`, the closed form of the overlap from any start, for drawing and for hard cases.
"""

from sim.dynamics.laws.base import Figures, FiniteLaw, Memory
from sim.dynamics.laws.bumper import Bumper
from sim.dynamics.laws.dashpot import Paper, PushOnly, PushOnlyUncorrected
from sim.dynamics.laws.hertz import Hertz
from sim.dynamics.laws.lookup import finite_law

__all__ = [
    "Bumper",
    "Figures",
    "FiniteLaw",
    "Hertz",
    "Memory",
    "Paper",
    "PushOnly",
    "PushOnlyUncorrected",
    "finite_law",
]
