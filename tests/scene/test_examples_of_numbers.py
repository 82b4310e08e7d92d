"""What a hint offers for a number is usual where the key has it: friction of 0.8 stops a cart at
once, and a push from 6 s on begins when the run is over."""

from __future__ import annotations

import pytest

from sim.scene import SceneError, read_fence
from sim.scene.effects import kinds
from sim.scene.fields import UNTIL, Field
from sim.scene.problem import Problem
from sim.scene.quantity import exact, read_quantity

CARTS = {"A": {"mass": 1, "position": 0}}


def _hints(**more: object) -> str:
    with pytest.raises(SceneError) as refused:
        read_fence({"id": "a", "carts": CARTS, **more}, named=False)
    return "\n".join(problem.hint for problem in refused.value.problems)


@pytest.mark.parametrize("friction", [{"coefficient": -0.01}, {"coefficient": None}, {}])
def test_a_wrong_friction_is_answered_with_a_usual_one(friction: dict[str, object]) -> None:
    assert "coefficient: 0.02" in _hints(effects=[{"friction": friction}])


def test_a_switch_of_a_friction_that_is_not_there_offers_a_usual_one() -> None:
    assert "{coefficient: 0.02, active: false}" in _hints(controls=[{"switch": "friction"}])


@pytest.mark.parametrize(
    ("kind", "field"),
    [(name, field) for name, kind in kinds().items() for field in kind.fields],
    ids=lambda one: one.key if isinstance(one, Field) else one,
)
def test_every_example_of_an_effect_is_allowed_where_it_is_offered(kind: str, field: Field) -> None:
    example = field.dimension.example
    assert not isinstance(field.read(example, (kind,)), Problem)
    if field.dimension.si == "s":
        usual_end = exact(UNTIL.default or "")
        assert read_quantity(example, field.dimension) < usual_end
