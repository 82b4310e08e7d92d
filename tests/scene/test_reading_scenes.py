"""From plain values to a scene, and every mistake with its path."""

from __future__ import annotations

import pytest

from sim.scene import SceneError, apply_changes, read_fence, read_scene
from tests import registry
from tests.scene.refused import problems

GOOD = registry.two_carts()


def test_defaults_are_those_of_the_interface():
    scene = read_scene({"carts": {"A": {"mass": 1, "position": 0}}})
    (cart,) = scene.carts
    assert (cart.velocity, cart.length, cart.bumper_length) == (0.0, 0.2, 0.04)
    assert (scene.track.left, scene.track.right, scene.track.length) == ("open", "open", None)
    assert (scene.until, scene.gravity, scene.effects) == (5.0, 9.81, ())
    two = read_scene(registry.two_carts(velocities=(0, 0)))
    assert two.contacts[1].law == "bumper"
    assert (two.contacts[1].restitution, two.contacts[1].stiffness) == (1.0, 500.0)


def test_gaps_are_exact_fractions_rounded_once():
    plain = {"carts": {"A": {"mass": 1, "position": "0.1"}, "B": {"mass": 1, "position": "0.3"}}}
    assert read_scene(plain).gaps[1] == 0.0  # 0.3 − 0.1 − 0.2 is −2.8e-17 in floats


def test_a_touching_chain_a_million_kilometres_away_still_touches():
    plain = {
        "carts": {
            n: {"mass": 1, "position": f"1000000000.{k}"} for n, k in zip("ABC", "135", strict=True)
        }
    }
    assert read_scene(plain).gaps[1:3] == (0.0, 0.0)


def test_carts_are_sorted_from_left_to_right():
    plain = {"carts": {"B": {"mass": 1, "position": 0}, "A": {"mass": 1, "position": 1}}}
    assert [cart.name for cart in read_scene(plain).carts] == ["B", "A"]


BAD = [
    ({"carts": {}}, "carts", "wrong-count"),
    ({}, "carts", "not-a-table"),
    ({**GOOD, "colour": "red"}, "colour", "unknown-key"),
    ({**GOOD, "until": 0}, "until", "out-of-range"),
    ({**GOOD, "until": "5 m"}, "until", "wrong-unit"),
    ({**GOOD, "title": 3}, "title", "not-text"),
    ({**GOOD, "track": {"right": "wall"}}, "track", "missing"),
    ({**GOOD, "track": {"left": "glass"}}, "track.left", "not-a-choice"),
    ({**GOOD, "contact": {"restitution": "1.2"}}, "contact.restitution", "out-of-range"),
    ({**GOOD, "contact": {"restitution": "-0.1"}}, "contact.restitution", "out-of-range"),
    ({**GOOD, "contact": {"stiffness": 0}}, "contact.stiffness", "out-of-range"),
    ({**GOOD, "contact": {"law": "velcroo"}}, "contact.law", "not-a-choice"),
    (
        {**GOOD, "contact": {"law": "instant", "stiffness": 3}},
        "contact.stiffness",
        "not-for-this-law",
    ),
    (
        {**GOOD, "contact": {"law": "velcro", "restitution": 1}},
        "contact.restitution",
        "not-for-this-law",
    ),
    (
        {**GOOD, "contact": {"law": "push-only", "restitution": 0}},
        "contact.restitution",
        "out-of-range",
    ),
    ({**GOOD, "contact": {"pairs": {"A-C": {}}}}, "contact.pairs.A-C", "unknown-pair"),
    ({**GOOD, "effects": [{"frictoin": {}}]}, "effects.0.frictoin", "unknown-effect"),
    ({**GOOD, "effects": {"friction": {}}}, "effects", "not-a-list"),
    ({**GOOD, "effects": [{"friction": {}}]}, "effects.0.friction", "missing"),
    (
        {**GOOD, "effects": [{"push": {"cart": "C", "force": 1}}]},
        "effects.0.push.cart",
        "unknown-body",
    ),
    (
        {**GOOD, "effects": [{"spring": {"between": ["A", "left"], "stiffness": 1, "length": 1}}]},
        "effects.0.spring.between",
        "unknown-body",
    ),
    ({**GOOD, "start": {"overlap": "yes"}}, "start.overlap", "not-a-choice"),
    (registry.two_carts(masses=(0, 1)), "carts.A.mass", "out-of-range"),
    (registry.two_carts(masses=(-1, 1)), "carts.A.mass", "out-of-range"),
    (registry.two_carts(masses=("heavy", 1)), "carts.A.mass", "not-a-number"),
    (registry.two_carts(masses=(float("nan"), 1)), "carts.A.mass", "not-finite"),
    (registry.two_carts(gap="-0.1"), "carts.B.position", "overlap"),
    ({"carts": {"left": {"mass": 1, "position": 0}}}, "carts.left", "bad-name"),
    ({"carts": {"9": {"mass": 1, "position": 0}}}, "carts.9", "bad-name"),
    ({"carts": {"ON": {"mass": 1, "position": 0}}}, "carts.ON", "bad-name"),
    ({"carts": {"True": {"mass": 1, "position": 0}}}, "carts.True", "bad-name"),
    (
        {"carts": {"A": {"mass": 1, "position": 0, "bumper_length": 1}}},
        "carts.A.bumper_length",
        "out-of-range",
    ),
    ({"carts": {"A": {"mass": 1}}}, "carts.A", "missing"),
    (
        {"carts": {"A": {"mass": 1, "position": "0.05"}}, "track": {"left": "wall"}},
        "carts.A.position",
        "overlap",
    ),
]


@pytest.mark.parametrize(("plain", "where", "code"), BAD)
def test_every_mistake_has_a_path_and_a_code(plain, where, code):
    assert (where, code) in problems(plain)


def test_all_mistakes_are_reported_at_once():
    plain = {"carts": {"A": {"mass": -1, "positon": 0}}, "until": "soon", "contact": {"law": "x"}}
    found = {where for where, _ in problems(plain)}
    assert {"carts.A.mass", "carts.A.positon", "until", "contact.law"} <= found


def test_an_overlap_is_allowed_where_the_scene_says_so():
    plain = registry.two_carts(gap="-0.01")
    assert read_scene({**plain, "start": {"overlap": True}}).gaps[1] == -0.01
    released = {**plain, "effects": [{"release": {"between": ["A", "B"], "energy": 1}}]}
    assert read_scene(released).gaps[1] == -0.01


def test_names_with_hyphens_make_pairs_too():
    plain = {
        "carts": {"big-one": {"mass": 1, "position": 0}, "b-2": {"mass": 1, "position": 1}},
        "contact": {"pairs": {"b-2-big-one": {"restitution": "0.5"}}},
    }
    assert read_scene(plain).contacts[1].restitution == 0.5


@pytest.mark.parametrize(
    ("target", "value", "read_back"),
    [
        ("A.mass", 3, lambda s: s.carts[0].mass == 3),
        ("A.velocity", "30 cm/s", lambda s: s.carts[0].velocity == 0.3),
        ("contact.restitution", "0.25", lambda s: s.contacts[1].restitution == 0.25),
        ("contact.pairs.A-B.law", "paper", lambda s: s.contacts[1].law == "paper"),
        ("until", 9, lambda s: s.until == 9),
    ],
)
def test_a_change_by_path_changes_that_and_nothing_else(target, value, read_back):
    changed = apply_changes(GOOD, {target: value})
    assert read_back(read_scene(changed))
    assert registry.two_carts() == GOOD


def test_a_path_that_leads_nowhere_is_refused_with_the_nearest_one():
    with pytest.raises(SceneError, match=r"did you mean “A\.mass”"):
        apply_changes(GOOD, {"A.mas": 1})


FENCE = {**GOOD, "id": "crash"}


def test_a_fence_knows_how_it_is_shown():
    fence = read_fence(
        {
            **FENCE,
            "view": "moving 0.3 m/s",
            "show": ["v", "F"],
            "controls": [{"set": "A.mass", "from": "0.5 kg", "to": "5 kg", "step": "100 g"}],
            "predict": {"arrows": ["A-B"]},
        }
    )
    (control,) = fence.controls
    assert (control.low, control.high, control.step, control.value) == (0.5, 5.0, 0.1, 1.0)
    assert (fence.view_speed, fence.show, fence.predict.pairs) == (0.3, ("v", "F"), (("A", "B"),))
    assert set(fence.plain) == set(GOOD)


@pytest.mark.parametrize(
    ("extra", "where"),
    [
        ({"id": "Crash 1"}, "id"),
        ({"show": ["x", "q"]}, "show"),
        ({"carts": {"A": {"mass": 1, "position": 0, "skin": "boat"}}}, "carts.A.skin"),
        ({"view": "moving"}, "view"),
        ({"slow": "maybe"}, "slow"),
        ({"controls": [{"set": "A.colour", "from": 1, "to": 2, "step": 1}]}, "controls.0.set"),
        ({"controls": [{"set": "A.mass", "from": 2, "to": 5, "step": 1}]}, "controls.0"),
        ({"controls": [{"set": "A.mass", "from": 5, "to": 2, "step": 1}]}, "controls.0"),
        ({"controls": [{"set": "A.mass", "from": 0, "to": 2, "step": 1}]}, "controls.0.from"),
        ({"predict": {"arrows": ["A-Z"]}}, "predict.arrows"),
        ({"predict": {"curve": "F.Z"}}, "predict.curve"),
        ({"predict": {"curve": "a.A"}}, "predict.curve"),
        ({"predict": {"arrows": ["A-B"], "scale": "pounds"}}, "predict.scale"),
        ({"predict": {"choice": ["one"]}}, "predict.choice"),
        ({"predict": {"choice": ["one", "two", " one "]}}, "predict.choice.2"),
        ({"predict": {}}, "predict"),
        ({"predict": {"text": "why?", "talk": "perhaps"}}, "predict.talk"),
        ({"with": ["lense"]}, "with"),
        ({"forces": "hidden", "show": ["x", "F"]}, "show"),
        ({"forces": "none", "show": ["x", "F"]}, "show"),
        ({"presets": {"heavy": {"A.weight": 1}}}, "presets.heavy"),
        ({"presets": {"heavy": {"A.mass": -1}}}, "presets.heavy.A.mass"),
    ],
)
def test_a_fence_has_its_own_mistakes(extra, where):
    assert where in {place for place, _ in problems({**FENCE, **extra}, read_fence)}


def test_a_control_counts_in_the_unit_that_its_limits_are_written_in():
    controls = [
        {"set": "A.velocity", "from": "0 mm/s", "to": "1500 mm/s", "step": "0.1 mm/s"},
        {"set": "A.mass", "from": "0.5 kg", "to": "2000 g", "step": "0.1 kg"},
    ]
    slow, mixed = read_fence({**FENCE, "controls": controls}).controls
    assert (slow.unit, slow.shown(slow.high), slow.high) == ("mm/s", 1500.0, 1.5)
    assert (mixed.unit, mixed.per) == ("kg", 1.0)


def test_a_misspelt_key_is_told_once():
    plain = {"carts": {"A": {"mas": 1, "position": 0}}}
    assert problems(plain) == {("carts.A.mas", "unknown-key")}


def test_a_decimal_comma_is_called_by_its_name():
    plain = {"carts": {"A": {"mass": 0, "5 kg": None, "position": 0}}}
    assert ("carts.A.mass", "decimal-comma") in problems(plain)
    no_number = {"carts": {"A": {"mass": "a few", "5 kg": None, "position": 0}}}
    assert ("carts.A.5 kg", "decimal-comma") in problems(no_number)
