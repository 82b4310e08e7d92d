"""A misspelt word in a scene is answered with the nearest right one."""

from __future__ import annotations

from typing import Any

import pytest
import yaml

from sim.scene import SceneError, quantity, read_fence
from sim.scene.effects import kinds
from sim.scene.problem import Problem
from sim.scene.said import in_words

TWO = {"A": {"mass": 1, "position": 0.5}, "B": {"mass": 1, "position": 1.5}}


def problems(**more: Any) -> tuple[Problem, ...]:
    with pytest.raises(SceneError) as caught:
        read_fence({"carts": TWO, **more}, named=False)
    return caught.value.problems


@pytest.mark.parametrize(
    ("more", "meant"),
    [
        ({"contact": {"law": "bumpr"}}, "bumper"),
        ({"contact": {"law": "Hertz"}}, "hertz"),
        ({"contact": {"pairs": {"A-B": {"law": "velkro"}}}}, "velcro"),
        ({"contact": {"stifness": 400}}, "stiffness"),
        ({"show": ["velocty"]}, "v"),
        ({"show": ["x", "momentun"]}, "p"),
        ({"show": ["energie"]}, "energy"),
        ({"show": ["f"]}, "F"),
        ({"show": "velocity"}, "v"),
        ({"Show": ["x"]}, "show"),
        ({"with": ["stopwach"]}, "stopwatch"),
        ({"packages": ["numpi"]}, "numpy"),
        ({"forces": "hiden"}, "hidden"),
        ({"slow": "nevr"}, "never"),
        ({"boxes": "alke"}, "alike"),
        ({"track": {"length": 2, "left": "wal"}}, "wall"),
    ],
)
def test_the_nearest_word_is_offered(more: dict[str, Any], meant: str) -> None:
    (problem,) = problems(**more)
    assert problem.hint == f"did you mean “{meant}”?"


@pytest.mark.parametrize(
    ("more", "hint"),
    [
        ({"contact": {"law": "qqq"}}, "laws: bumper, "),
        ({"show": ["qqq"]}, "show: [x, v]"),
        ({"show": None}, "show: [x, v]"),
        ({"forces": "qqq"}, "forces: shown"),
    ],
)
def test_a_word_that_is_near_to_none_is_answered_with_those_there_are(
    more: dict[str, Any], hint: str
) -> None:
    (problem,) = problems(**more)
    assert problem.hint.startswith(hint)


def test_a_skin_that_is_none_is_answered_with_all_of_them() -> None:
    """Of “car” the author read only “cart”, and never of vans and trucks."""
    (problem,) = problems(carts={"A": {"mass": 1, "position": 0, "skin": "car"}})
    assert problem.hint.startswith("did you mean “cart”? There are cart, van, truck,")


@pytest.mark.parametrize("name", kinds())
def test_every_everyday_word_of_an_effect_leads_to_an_example_that_can_be_read(name: str) -> None:
    for word in kinds()[name].everyday:
        (problem,) = problems(effects=[{word: {}}])
        assert problem.hint.startswith(f"did you mean “{name}”? For example - {name}: ")
        (entry,) = yaml.safe_load(problem.hint.partition("For example ")[2])
        ends = {"A": {"mass": 1, "position": 0.5}, "B": {"mass": 1, "position": 0.7}}
        carts = ends if name == "release" else TWO
        assert read_fence({"carts": carts, "effects": [entry]}, named=False)


def test_no_everyday_word_means_two_effects() -> None:
    words = [word for kind in kinds().values() for word in (kind.name, *kind.everyday)]
    assert len(words) == len(set(words))


@pytest.mark.parametrize(
    ("written", "kind", "meant"),
    [
        ("3 Minutes", quantity.TIME, "3 min"),
        ("2 M/S", quantity.SPEED, "2 m/s"),
        ("1 KN", quantity.FORCE, "1 kN"),
        ("0.6 KG", quantity.MASS, "0.6 kg"),
        ("2 tons", quantity.MASS, "2 t"),
    ],
)
def test_a_unit_written_out_or_in_capitals_is_told_with_its_number(
    written: str, kind: quantity.Dimension, meant: str
) -> None:
    with pytest.raises(quantity.QuantityError) as caught:
        quantity.read_quantity(written, kind)
    assert caught.value.hint == f"did you mean “{meant}”?"


@pytest.mark.parametrize(
    ("written", "kind"),
    [("2 MN", quantity.FORCE), ("2 Mm", quantity.LENGTH), ("2 Mg", quantity.MASS)],
)
def test_a_million_of_a_unit_is_never_taken_for_a_thousandth(
    written: str, kind: quantity.Dimension
) -> None:
    with pytest.raises(quantity.QuantityError) as caught:
        quantity.read_quantity(written, kind)
    assert not caught.value.hint.startswith("did you mean")


ROW = {**TWO, "C": {"mass": 1, "position": 2.5}}
WALL = {"length": 4, "right": "wall"}


@pytest.mark.parametrize(
    ("arrows", "message", "hint"),
    [
        (
            ["A-B", "C-B"],
            "“C-B” names two neighbours from right to left",
            "from left to right: arrows: [B-C]",
        ),
        (["A-C"], "“A-C” are not two neighbours", "neighbours here: arrows: [A-B, B-C, C-right]"),
        ("AB", "“AB” are not two neighbours", "neighbours here: arrows: [A-B, B-C, C-right]"),
        ([], "arrows lists pairs of neighbours", "arrows: [A-B, B-C, C-right]"),
    ],
)
def test_arrows_of_no_pair_are_answered_with_the_pairs_of_this_scene(
    arrows: object, message: str, hint: str
) -> None:
    (problem,) = problems(carts=ROW, track=WALL, predict={"arrows": arrows})
    assert (problem.where, problem.message, problem.hint) == ("predict.arrows", message, hint)


def test_arrows_where_nothing_can_touch_are_told_so() -> None:
    (problem,) = problems(carts={"A": TWO["A"]}, predict={"arrows": ["A-B"]})
    assert problem.message.startswith("nothing can touch anything here")


@pytest.mark.parametrize(
    "more", [{"contact": {"law": "bumpr"}}, {"show": ["velocty"]}, {"forces": "hiden"}]
)
def test_the_hint_is_told_in_the_language_of_the_page(more: dict[str, Any]) -> None:
    """Before, it was English text that no catalogue knew, below a sentence that was translated."""
    (problem,) = problems(**more)
    assert in_words(problem.hint, {"did you mean {name}?": "maksudnya {name}?"}).startswith(
        "maksudnya “"
    )


@pytest.mark.parametrize("asked", [{"arrows": ["A-B"]}, {"curve": "F.A"}])
def test_a_force_of_one_instant_is_not_asked_for(asked: dict[str, Any]) -> None:
    """The page said “In this run nothing touches A” beside a collision."""
    (problem,) = problems(carts=TWO, contact={"law": "instant"}, predict=asked)
    assert problem.code == "not-for-this-law"
    assert "law: bumper" in problem.hint
    spring = {"spring": {"stiffness": 5, "length": 0.1, "between": ["A", "B"]}}
    sudden = {"carts": TWO, "contact": {"law": "instant"}, "effects": [spring]}
    assert read_fence({"id": "one", **sudden, "predict": asked}).predict


def test_the_example_of_an_effect_stands_in_a_sentence_of_the_language_of_the_page() -> None:
    (problem,) = problems(effects=[{"brake": {}}])
    words = {"did you mean {name}? For example {example}": "maksudnya {name}? Contohnya {example}"}
    assert in_words(problem.hint, words).startswith("maksudnya “friction”? Contohnya - friction: ")
