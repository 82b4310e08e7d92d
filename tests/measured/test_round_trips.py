"""What is given back can be read again, and says the same."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.measured.model.fit import Asked, fit
from sim.measured.model.motion import Motion
from sim.measured.report import model_as_tracker, motion_report
from sim.measured.tracks import read_measured
from sim.pages.blocks.scene_block import Lesson, SiteIds, read_scene_block
from sim.pages.text.fence_scan import scan
from sim.pages.text.yaml.source import load
from sim.scene import read_fence
from tests.measured.makers import as_text, film, truth

FRICTION = ({"friction": {"coefficient": "0.005"}},)
TILT = ({"incline": {"angle": "0.3 deg"}},)
CASES: list[Any] = [
    ("bumper", "none", ()),
    ("paper", "none", ()),
    ("bumper", "friction", FRICTION),
    ("bumper", "tilt", TILT),
]


@pytest.mark.parametrize(("law", "effect", "listed"), CASES)
def test_the_fitted_fence_is_a_good_one_and_runs_as_fitted(
    law: Any, effect: Any, listed: Any
) -> None:
    made = truth(law=law, effects=listed, v=(0.8, -0.2))
    measured = film(made, noise=1e-3)
    found = fit(measured, Asked(law=law, effect=effect))
    report = motion_report(measured, found)
    (block,) = scan(report["fence"].splitlines())
    fence = read_scene_block(block, Lesson("lesson.md"), SiteIds(), first_line=1).fence
    finished = run(fence.scene)
    near = 2e-5 if effect == "friction" else 1e-8  # m; friction: second order, see contact.py
    motion, begin = Motion(found.parameters, law), measured.tracks[0].t[0]
    for k in range(40):
        t = k / 40 * fence.scene.until
        wanted = motion.state(begin + t)[0]
        shift = found.parameters.distance - fence.scene.carts[0].length
        left, right = sample(finished, t)[0]
        assert left == pytest.approx(wanted[0], abs=near)
        assert right + shift == pytest.approx(wanted[1], abs=near)


def test_marks_far_from_the_middle_still_give_a_scene() -> None:
    measured = film(truth())
    moved = read_measured([as_text(measured).replace("B", "C")])
    tracks = (moved.tracks[0], moved.tracks[1])
    close = type(tracks[1])(
        "C", tracks[1].t, tuple(x - 0.19 for x in tracks[1].value), tracks[1].lines
    )
    found = fit(type(moved)("length", (tracks[0], close), ()))
    assert found.parameters.distance < 0.1
    report = motion_report(type(moved)("length", (tracks[0], close), ()), found)
    read_fence(dict(load(report["scene"]).plain), named=False)


@pytest.mark.parametrize(
    ("names", "in_scene"),
    [
        (("Left", "Right"), ["Left", "Right"]),
        (("left", "Right"), ["A", "B"]),
        (("On", "b"), ["A", "B"]),
        (("cart 1", "b"), ["A", "B"]),
    ],
)
def test_carts_keep_every_name_that_a_scene_takes(names, in_scene) -> None:
    made = film(truth())
    tracks = [replace(one, name=name) for one, name in zip(made.tracks, names, strict=True)]
    measured = replace(made, tracks=(tracks[0], tracks[1]))
    report = motion_report(measured, fit(measured))
    scene = read_fence(dict(load(report["scene"]).plain), named=False).scene
    assert [cart.name for cart in scene.carts] == in_scene


def test_the_models_run_is_read_back_as_tracker_text() -> None:
    measured = film(truth())
    found = fit(measured)
    back = read_measured([model_as_tracker(measured, found)])
    assert back.names == measured.names
    again = fit(back)
    assert again.parameters.e == pytest.approx(found.parameters.e, abs=1e-6)
    assert again.parameters.ratio == pytest.approx(found.parameters.ratio, rel=1e-6)
    assert again.noise < 1e-8


def test_a_film_with_its_own_clock_gives_a_scene_that_starts_at_zero() -> None:
    from sim.measured.synthetic import filmed

    made = truth()
    late = filmed(made.scene, rate=120, noise=0.0, seed=1, begin=12.5)
    found = fit(late)
    assert found.parameters.touch == pytest.approx(12.5 + made.touch, abs=1e-9)
    scene = read_fence(dict(load(motion_report(late, found)["scene"]).plain), named=False).scene
    assert scene.carts[0].position == pytest.approx(made.scene.carts[0].position, abs=1e-8)
