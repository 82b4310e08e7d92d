"""What a pair takes from the scene's own contact, and what it cannot take."""

from __future__ import annotations

import itertools
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.scene import Problem, SceneError, apply_changes, read_fence, read_scene
from sim.scene.fence.controls import read_controls
from sim.scene.laws import laws

STIFFNESS = {"hertz": "1e5 N/m^1.5"}
"""As an author writes it; N/m for all other laws that take one."""


def three(contact: dict[str, Any]) -> dict[str, Any]:
    """A runs into B, B into C; a wall on the left."""
    carts = {
        name: {"mass": "0.5 kg", "position": x, "velocity": v}
        for name, x, v in (("A", 0.4, 1), ("B", 1.0, 0), ("C", 1.6, 0))
    }
    return {"carts": carts, "track": {"left": "wall"}, "contact": contact, "until": 2}


def own_of(law: str) -> dict[str, Any]:
    kind = laws()[law]
    found: dict[str, Any] = {"law": law}
    if kind.stiffness is not None:
        found["stiffness"] = STIFFNESS.get(law, "400 N/m")
    if kind.restitution is not None:
        found["restitution"] = "0.5"
    return found


def told(plain: dict[str, Any]) -> list[tuple[str, str]]:
    with pytest.raises(SceneError) as caught:
        read_scene(plain)
    return [(problem.where, problem.message) for problem in caught.value.problems]


@pytest.mark.parametrize(
    ("outer", "inner", "unit"), [("hertz", "bumper", "N/m^1.5"), ("bumper", "hertz", "N/m")]
)
def test_a_pair_does_not_take_a_stiffness_in_the_unit_of_another_law(
    outer: str, inner: str, unit: str
) -> None:
    contact = {"law": outer, "stiffness": f"1e6 {unit}", "pairs": {"B-C": {"law": inner}}}
    assert told(three(contact)) == [("contact.pairs.B-C", "“B-C” needs its own stiffness")]
    with_wall = contact | {"pairs": {"left-A": {"law": inner}}}
    assert told(three(with_wall)) == [("contact.pairs.left-A", "“left-A” needs its own stiffness")]


def test_a_change_that_gives_a_pair_another_law_is_told_what_it_lacks() -> None:
    contact = {"law": "hertz", "stiffness": "1e6 N/m^1.5"}
    changed = apply_changes(three(contact), {"contact.pairs.B-C.law": "bumper"})
    assert told(changed) == [("contact.pairs.B-C", "“B-C” needs its own stiffness")]
    both = {"contact.pairs.B-C.law": "bumper", "contact.pairs.B-C.stiffness": "400 N/m"}
    assert read_scene(apply_changes(three(contact), both)).contacts[2] is not None


def test_a_pair_cannot_take_a_restitution_that_its_law_cannot_give() -> None:
    contact = {"restitution": 0, "pairs": {"B-C": {"law": "push-only"}}}
    ((where, _),) = told(three(contact))
    assert where == "contact.pairs.B-C.restitution"


def test_what_is_wrong_with_the_scenes_own_contact_is_told_once() -> None:
    contact = {"stiffness": "hard", "pairs": {"A-B": {"restitution": 0.5}, "B-C": {"law": "hertz"}}}
    assert [where for where, _ in told(three(contact))] == ["contact.stiffness"]


@pytest.mark.parametrize(("outer", "inner"), list(itertools.product(laws(), laws())))
def test_two_neighbours_have_a_contact_or_the_scene_is_refused(outer: str, inner: str) -> None:
    """Whichever law the scene and one pair of it name: no cart drives through another."""
    plain = three(own_of(outer) | {"pairs": {"B-C": {"law": inner}, "left-A": {"law": inner}}})
    try:
        scene = read_scene(plain)
    except SceneError:
        return
    assert [contact is None for contact in scene.contacts] == [False, False, False, True]
    done = run(scene)
    assert done.x == tuple(sorted(done.x))
    assert done.v[2] > 0.0  # momentum has come through


@pytest.mark.parametrize("key", ["restitution", "stiffness"])
def test_a_slider_of_the_contact_begins_where_pairs_without_their_own_stand(key: str) -> None:
    """Not at the wall's, which is the first from the left and has its own."""
    contact = {
        "restitution": 0.5,
        "stiffness": "400 N/m",
        "pairs": {"left-A": {"restitution": 1, "stiffness": "900 N/m"}},
    }
    scene = read_scene(three(contact))
    slider = {"set": f"contact.{key}", "from": 0, "to": 1, "step": 0.1}
    if key == "stiffness":
        slider |= {"from": "100 N/m", "to": "1000 N/m", "step": "100 N/m"}
    problems: list[Problem] = []
    (control,) = read_controls([slider], scene, problems)
    assert not problems
    moved = apply_changes(three(contact), {f"contact.{key}": control.value})
    assert read_scene(moved) == scene


def test_a_slider_for_a_stiffness_counts_in_the_unit_of_its_law() -> None:
    limits = {"from": "1e5 N/m^1.5", "to": "1e6 N/m^1.5", "step": "1e5 N/m^1.5"}
    contact = {"law": "hertz", "stiffness": "4e5 N/m^1.5"}
    controls = [{"set": "contact.stiffness", **limits}]
    fence = read_fence({"id": "one", "controls": controls, **three(contact)})
    assert [one.unit for one in fence.controls] == ["N/m^1.5"]
