"""Goals of challenges: what an author writes, and which runs reach it."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.lesson.goal import NEAR, Goal, Term, read_goal
from sim.scene.problem import Problem
from tests.web.scene.given.widget_site import in_node

CARTS = {
    "A": {"mass": 1, "position": 0.3, "velocity": 0.5},
    "B": {"mass": 1, "position": 0.8},
}


def goal_of(text: str) -> Goal:
    problems: list[Problem] = []
    goal = read_goal(text, ("goal",), problems)
    assert goal, problems
    return goal


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("v.A = 0", Goal(Term(1, "v.A", "end"), "=", Term(0.0))),
        ("v.A<-20 cm/s", Goal(Term(1, "v.A", "end"), "<", Term(-0.2))),
        ("largest F.A-B > 20 N", Goal(Term(1, "F.A-B", "largest"), ">", Term(20.0))),
        ("F.B = 2 F.A", Goal(Term(1, "F.B", "largest"), "=", Term(2.0, "F.A", "largest"))),
        ("a.A > 2 m/s²", Goal(Term(1, "a.A", "largest"), ">", Term(2.0))),
        ("3·p.A > start p.B", Goal(Term(3, "p.A", "end"), ">", Term(1, "p.B", "start"))),
    ],
)
def test_a_goal_is_read_as_it_is_meant(text: str, goal: Goal) -> None:
    assert goal_of(text) == goal


@pytest.mark.parametrize(
    ("value", "code"),
    [
        ("stop A", "not-a-goal"),
        ("v.A = 0 = v.B", "not-a-goal"),
        ("E.A = 0", "unknown-path"),
        ("v.A = x.B", "not-a-goal"),
        ("v.A = 3 kg", "wrong-unit"),
        (7, "not-a-goal"),
    ],
)
def test_what_is_no_goal_is_told_with_an_example(value: object, code: str) -> None:
    problems: list[Problem] = []
    assert read_goal(value, ("goal",), problems) is None
    ((found, hint),) = [(problem.code, problem.hint) for problem in problems]
    assert found == code
    assert hint


@pytest.mark.parametrize(
    ("text", "contact", "reached"),
    [
        ("v.A = 0", {"restitution": 1}, True),  # equal masses exchange their velocities
        ("v.A = 0", {"restitution": 0.8}, False),
        ("v.A = 0", {"restitution": 0.97}, True),  # 0.0075 m/s, and 2 % are 0.01 m/s
        ("v.A = 0", {"restitution": 0.95}, False),
        ("v.A < v.B", {"restitution": 0.8}, True),
        ("p.B = 0.5 kg m/s", {"restitution": 1}, True),
        ("F.B = F.A", {"restitution": 0.6}, True),
        ("F.B = 2 F.A", {"restitution": 0.6}, False),
        ("F.A-B > 0.1 N", {"restitution": 1}, True),
        ("largest v.A = 0.5 m/s", {"restitution": 0.3}, True),
    ],
)
def test_the_page_says_of_a_run_what_mechanics_says(
    text: str, contact: dict[str, Any], reached: bool
) -> None:
    scene = {"carts": CARTS, "contact": {**contact, "stiffness": 300}, "until": 3}
    header, numbers = answer({"id": 0, "kind": "run", "scene": scene})
    met = in_node(
        """const { fromWire } = await import(view + "/trajectory.js");
        const { isMet } = await import(source + "/question/marking/goal.js");
        const run = fromWire(data.header, Float64Array.from(data.numbers));
        give(isMet(data.goal, run, { A: 1, B: 1 }, data.near));""",
        {
            "header": json.loads(json.dumps(header)),
            "numbers": list(numbers),
            "goal": asdict(goal_of(text)),
            "near": NEAR,
        },
    )
    assert met is reached


def test_the_force_on_a_cart_with_a_hyphen_in_its_name_is_that_of_its_pairs() -> None:
    scene = {
        "carts": {f"cart-{k}": cart for k, cart in enumerate(CARTS.values(), 1)},
        "contact": {"restitution": 1, "stiffness": 300},
        "until": 3,
    }
    header, numbers = answer({"id": 0, "kind": "run", "scene": scene})
    goals = ["F.cart-1 > 5 N", "F.cart-1 < 5 N", "F.cart-1 = F.cart-2"]
    met = in_node(
        """const { fromWire } = await import(view + "/trajectory.js");
        const { isMet } = await import(source + "/question/marking/goal.js");
        const run = fromWire(data.header, Float64Array.from(data.numbers));
        const masses = { "cart-1": 1, "cart-2": 1 };
        give(data.goals.map((goal) => isMet(goal, run, masses, data.near)));""",
        {
            "header": json.loads(json.dumps(header)),
            "numbers": list(numbers),
            "goals": [asdict(goal_of(text)) for text in goals],
            "near": NEAR,
        },
    )
    assert met == [True, False, True]  # 0.5 m/s, k 300 N/m, 1 kg each: 6.1 N
