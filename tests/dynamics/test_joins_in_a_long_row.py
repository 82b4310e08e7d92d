"""What a join touches of a long row."""

from __future__ import annotations

from typing import Any

from sim.dynamics.loop import impacts
from sim.dynamics.loop.run import run
from sim.dynamics.result.record import Record
from sim.dynamics.state.chain import Chain
from sim.dynamics.state.clock import ZERO
from sim.scene import read_scene

CARTS = 40


class Watched(list[Any]):
    """A list that remembers which places were read, and lets nobody go through all of it."""

    def __init__(self, of: list[Any]) -> None:
        super().__init__(of)
        self.read: set[int] = set()

    def __getitem__(self, place: Any) -> Any:
        self.read.add(place)
        return super().__getitem__(place)

    def __iter__(self) -> Any:
        raise AssertionError("the whole row was gone through")


def row(carts: int) -> dict[str, Any]:
    """The first cart runs into a row that stands still; all have velcro."""
    return {
        "carts": {
            f"C{k}": {
                "mass": f"{1 + k % 3} kg",
                "position": f"{0.3 * k:.1f} m",
                "velocity": f"{int(k == 0)} m/s",
                "length": "0.1 m",
            }
            for k in range(carts)
        },
        "contact": {"law": "velcro"},
        "until": "1000 s",
    }


def test_two_that_join_touch_no_cart_and_no_gap_further_away():
    scene = read_scene(row(CARTS))
    chain = Chain(scene, None)
    chain.gaps, chain.bodies = Watched(chain.gaps), Watched(chain.bodies)
    record = Record(scene, keep_events=False, keep_motion=False)
    gap = chain.gaps[20]
    impacts.merge(chain, gap, ZERO, record)
    assert chain.gaps.read <= {20, 21}
    assert chain.bodies[19] is chain.bodies[20] is gap.left is gap.right
    assert gap.left.carts == (19, 20)
    assert chain.gaps[21].left is gap.left
    assert chain.gaps[19].right is gap.left


def test_a_row_with_velcro_goes_on_as_one_body_with_every_cart_at_its_place():
    done = run(read_scene(row(CARTS)))
    assert done.v == (done.v[0],) * CARTS
    assert abs(done.v[0] * sum(1 + k % 3 for k in range(CARTS)) - 1.0) < 1e-12
    rooms = [b - a for a, b in zip(done.x, done.x[1:], strict=False)]
    assert all(abs(room - 0.1) < 1e-12 for room in rooms)
