"""A certificate holds: forty digits of an independent run are inside, or it says why not."""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
from collections.abc import Callable
from time import monotonic
from typing import Any

import pytest
from click.testing import CliRunner

from sim.certify.certificate import certify, document
from sim.certify.run import Limit
from sim.cli import main
from sim.dynamics.loop.run import run
from sim.pages.hard_cases import ALL, HardCase
from sim.scene import Scene, SceneError, read_scene
from tests import registry
from tests.certify.held import HARD_WITHOUT_BOUND, NO_BOUND, misses, widths
from tests.certify.random_scenes import letting_go, plain
from tests.reference.digit_pairs import UnsupportedError

SLOW_CASES = (
    "pi-hard-2",
    "pi-hard-3",
    "pi-hard-4",
    "pi-soft-2",
    "pi-soft-3",
    "pi-soft-4",
    "jepsen-50",
)
SLOW_CASES = (*SLOW_CASES, "a-million-seconds", "rest-on-a-soft-wall", "resting-on-a-slope")
"""Hundreds of events and more: too long for a test, with the oracle."""

SEEDS = range(20)
ULPS = 8
"""Doubles between the bounds of a pair, at the median: what an issue asked for."""


@pytest.mark.parametrize("name", sorted(registry.PATHS))
def test_forty_digits_of_every_scene_lie_inside_its_certificate(name: str) -> None:
    scene = registry.scene(name)
    found = document(certify(scene))
    if name in NO_BOUND:
        assert found["order"] == "not-provable" and found["reason"]
        assert found["final"] == {"x": {}, "v": {}}
    else:
        assert found["order"] == "proved", found["reason"]
        assert misses(scene, found) == []


@pytest.mark.parametrize("name", sorted(set(registry.PATHS) - NO_BOUND))
def test_a_certificate_lists_the_events_of_the_run(name: str) -> None:
    scene = registry.scene(name)
    found, done = certify(scene), run(scene)
    events = [(event.kind, event.bodies) for event in done.record.events]
    assert [(event.kind, event.bodies) for event in found.events] == events
    for proved, event in zip(document(found)["events"], done.record.events, strict=True):
        low, high = map(float, proved["t"])
        assert low - 1e-13 * scene.until <= event.t <= high + 1e-13 * scene.until


@pytest.mark.parametrize("case", [c for c in ALL if c.name not in SLOW_CASES], ids=lambda c: c.name)
def test_forty_digits_of_the_hard_cases_lie_inside_too(case: HardCase) -> None:
    scene = read_scene(case.plain)
    found = document(certify(scene))
    if case.name in HARD_WITHOUT_BOUND:
        assert found["reason"] and not found["final"]["x"]
        return
    assert found["final"]["x"], found["reason"]
    try:
        assert misses(scene, found) == []
    except UnsupportedError:
        for known in case.expected:
            kind, _, cart = known.what.partition(".")
            if kind in ("x", "v") and cart in found["final"][kind]:
                low, high = map(float, found["final"][kind][cart])
                assert low - known.tolerance <= known.value <= high + known.tolerance


@pytest.mark.parametrize("seed", SEEDS)
def test_forty_digits_of_a_random_scene_lie_inside_its_certificate(seed: int) -> None:
    """`make fuzz AREA=certificates` looks at as many as wanted."""
    try:
        scene = read_scene(plain(seed))
        found = document(certify(scene))
        if found["final"]["x"]:
            assert misses(scene, found) == []
        else:
            assert found["reason"]
    except (SceneError, UnsupportedError):
        pytest.skip("no scene, or the oracle cannot tell")


@pytest.mark.parametrize("seed", SEEDS)
def test_forty_digits_of_random_exploders_lie_inside(seed: int) -> None:
    scene = read_scene(letting_go(seed))
    found = document(certify(scene))
    assert found["final"]["x"] or found["reason"]
    if found["final"]["x"]:
        assert misses(scene, found) == []


@pytest.mark.parametrize("stiffness", [None, 40], ids=["at once", "by a spring"])
def test_an_exploder_at_the_start_needs_no_time(stiffness: float | None) -> None:
    """½ mu w² = E: 0.06 J make −0.4 and 0.2 m/s of 0.5 and 1 kg."""
    one = {"between": ["A", "B"], "energy": 0.06} | ({"stiffness": stiffness} if stiffness else {})
    scene = read_scene({
        "carts": {"A": {"mass": 0.5, "position": 1}, "B": {"mass": 1, "position": 1.2}},
        "effects": [{"release": one}], "until": 1,
    })  # fmt: skip
    found = document(certify(scene))
    assert found["order"] == "proved"
    for cart, v in (("A", -0.4), ("B", 0.2)):
        low, high = map(float, found["final"]["v"][cart])
        assert low <= v <= high and high - low < 1e-14


def test_what_bounces_ever_faster_is_given_up_at_once() -> None:
    """Infinitely many bounces have no list; ten thousand of them took minutes."""
    scene = read_scene({
        "carts": {"A": {"mass": 1, "position": 0.4, "velocity": -0.1}},
        "track": {"left": "wall"}, "contact": {"law": "instant", "restitution": 0.5},
        "effects": [{"incline": {"angle": -0.04}}], "until": 9,
    })  # fmt: skip
    found = certify(scene)
    assert "without a last time" in found.reason and len(found.events) < 200
    assert "the wall and A" in found.reason  # not “left and A”


@pytest.mark.parametrize(
    ("left_is", "called"), [("wall", "the left wall"), ("foam", "the foam"), ("board", "the board")]
)
def test_a_reason_calls_the_ends_of_the_track_as_a_run_does(left_is: str, called: str) -> None:
    track = {"left": "wall", "right": "wall", "length": 0.5, "left_is": left_is}
    scene = read_scene({
        "carts": {
            "A": {"mass": 0.5, "position": 0.1, "velocity": -1},
            "B": {"mass": 1, "position": 0.3},
        },
        "track": track, "contact": {"law": "bumper", "restitution": 1, "stiffness": 200},
        "effects": [{"friction": {"coefficient": 0.05}},
                    {"friction": {"coefficient": 0.1, "static": 0.3}}], "until": 3,
    })  # fmt: skip
    reason = certify(scene).reason
    assert f"the end of the contact of {called} and A" in reason


def test_a_reason_names_two_events_and_never_one_of_them_twice() -> None:
    """Where a motion has two ends: a bumper turns, or friction stops a cart."""
    scene = read_scene({
        "carts": {
            "A": {"mass": 0.5, "position": 0.3, "velocity": 1},
            "B": {"mass": 2, "position": 0.8, "velocity": 0.3},
        },
        "track": {"right": "wall", "length": 1.1},
        "contact": {"law": "bumper", "restitution": 0.5, "stiffness": 50},
        "effects": [{"friction": {"coefficient": 0.1, "static": 0.3}}], "until": 3,
    })  # fmt: skip
    reason = certify(scene).reason
    assert reason == "what comes first: the turn of A and B or the stop of A"
    assert reason.values["one"] != reason.values["other"]


def test_a_proof_ends_at_its_moment_and_says_so() -> None:
    """A page plays nothing else meanwhile."""
    scene = registry.scene("light-meets-heavy")
    found = certify(scene, limit=Limit(moment=monotonic()))
    assert not found.x and found.reason == "the proof takes too long here"
    assert certify(scene, limit=Limit(moment=monotonic() + 60)).proved


@pytest.mark.parametrize("made", [plain, letting_go])
def test_most_random_scenes_are_certified(made: Callable[[int], dict[str, Any]]) -> None:
    scenes = [scene for seed in range(40) if (scene := maybe(seed, made)) is not None]
    assert len(scenes) > 30
    proved = [scene for scene in scenes if certify(scene).proved]
    assert len(proved) > 0.8 * len(scenes)


def maybe(seed: int, made: Callable[[int], dict[str, Any]] = plain) -> Scene | None:
    try:
        return read_scene(made(seed))
    except SceneError:
        return None


def test_bounds_of_a_pair_are_a_few_doubles_apart() -> None:
    pairs = [scene for seed in range(80) if (scene := maybe(seed)) and len(scene.carts) == 2]
    wide = [width for scene in pairs for width in widths(document(certify(scene)))]
    assert len(wide) > 100
    assert statistics.median(wide) <= ULPS


def test_the_command_prints_the_interface() -> None:
    path = str(registry.PATHS["light-meets-heavy"])
    shown = json.loads(CliRunner().invoke(main, ["run", path, "--certify", "--json"]).stdout)
    found = shown["certificate"]
    assert found == document(certify(registry.scene("light-meets-heavy")))
    assert {"final", "events", "order", "reason"} <= set(found)
    for kind in ("x", "v"):
        for cart, (low, high) in found["final"][kind].items():
            assert isinstance(low, str) and isinstance(high, str)
            number = shown["final"][kind][cart]
            assert float(low) - 1e-14 <= number <= float(high) + 1e-14
    assert "certificate" not in json.loads(CliRunner().invoke(main, ["run", path, "--json"]).stdout)
    text = CliRunner().invoke(main, ["run", path, "--certify"]).stdout
    assert "The order of the events is proved." in text
    wrong = CliRunner().invoke(main, ["run", path, "--certify", "--method", "rk4"])
    assert wrong.exit_code == 2


def test_nothing_of_it_is_in_a_page_or_in_an_ordinary_run() -> None:
    from sim.pages.runtime.ours import LAYERS

    assert "certify" not in LAYERS
    code = (
        "from sim.cli import main\n"
        "try: main(['run', 'tests/scenes/instant.yml'])\n"
        "except SystemExit: pass\n"
        "import sys; print([n for n in sys.modules if 'flint' in n or 'certify' in n])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip().endswith("[]")
