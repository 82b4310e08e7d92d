"""What stands at an end of the track: the author names it, words tell it, no motion knows it."""

from __future__ import annotations

from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.cli.tables import run_as_text
from sim.dynamics.loop.run import run
from sim.dynamics.report.document import report
from sim.scene import SceneError, apply_changes, read_fence, read_scene
from sim.scene.fence.map import read_map
from sim.scene.fence.presets import numbers_of
from sim.scene.track import WHAT, body_name

THINGS = WHAT[1:]
AGAINST: dict[str, Any] = {
    "carts": {
        "A": {"mass": "0.5 kg", "position": "0.5 m", "velocity": "0.5 m/s", "bumper_length": 0}
    },
    "track": {"length": "1.2 m", "right": "wall"},
    "contact": {"restitution": 0.2, "stiffness": "40 N/m"},
    "until": "3 s",
}


def with_track(**track: Any) -> dict[str, Any]:
    return {**AGAINST, "track": {**AGAINST["track"], **track}}


def refusal(track: dict[str, Any], **more: Any) -> tuple[str, str, str, str]:
    with pytest.raises(SceneError) as caught:
        read_scene({**AGAINST, "track": track, **more})
    (problem,) = caught.value.problems
    return problem.where, problem.code, problem.message, problem.hint


@pytest.mark.parametrize("what", WHAT)
@pytest.mark.parametrize("side", ["left", "right"])
def test_a_wall_may_be_named(side: str, what: str) -> None:
    track = read_scene(with_track(left="wall", **{f"{side}_is": what})).track
    assert {"left": track.left_is, "right": track.right_is}[side] == what
    assert {track.left_is, track.right_is} <= {what, "wall"}


def test_without_a_name_it_is_a_wall() -> None:
    track = read_scene(AGAINST).track
    assert (track.left_is, track.right_is) == ("wall", "wall")


def test_an_unknown_name_is_refused_with_the_nearest_one() -> None:
    track = {"length": 2, "right": "wall", "right_is": "foamy"}
    assert refusal(track) == (
        "track.right_is",
        "not-a-choice",
        "right_is must be wall, foam, spring or board (got foamy)",
        "did you mean “foam”?",
    )
    assert refusal({**track, "right_is": 7})[3] == "track: {right: wall, right_is: foam}"


@pytest.mark.parametrize("what", WHAT)
def test_an_end_that_is_open_cannot_be_called_foam_or_spring(what: str) -> None:
    assert refusal({"length": 2, "left_is": what}) == (
        "track.left_is",
        "no-wall",
        "left_is says what stands on the left, but the track is open there",
        f"track: {{length: 2.4 m, left: wall, left_is: {what}}}, or remove left_is",
    )


def test_an_end_that_is_neither_open_nor_a_wall_is_told_once() -> None:
    assert refusal({"length": 2, "right": "foam", "right_is": "foam"})[0] == "track.right"


@pytest.mark.parametrize("what", THINGS)
def test_a_run_does_not_know_what_it_runs_into(what: str) -> None:
    header, numbers = answer({"id": 0, "kind": "run", "scene": AGAINST})
    named, same = answer({"id": 0, "kind": "run", "scene": with_track(right_is=what)})
    assert same.tobytes() == numbers.tobytes()
    assert named["track"] == {**header["track"], "right_is": what}
    for part in set(header) - {"track", "plan"}:
        assert named[part] == header[part], part
    facts = [[{**phase, "why": ""} for phase in one["plan"]] for one in (header, named)]
    assert facts[0] == facts[1]


def test_the_header_of_a_run_against_a_wall_is_as_it_was() -> None:
    plain = {"left": "open", "right": "wall", "length": 1.2}
    for scene in (AGAINST, with_track(right_is="wall")):
        assert answer({"id": 0, "kind": "run", "scene": scene})[0]["track"] == plain


@pytest.mark.parametrize("what", THINGS)
def test_plan_and_run_call_it_by_its_name(what: str) -> None:
    scene = read_scene(with_track(right_is=what))
    told = " ".join(phase["why"] for phase in report(run(scene))["plan"])
    assert f"only A with the {what} in contact" in told
    assert "wall" not in told
    assert f"From outside: the {what} gave −0.3 N s." in run_as_text(run(scene))


def test_what_two_ends_gave_is_told_of_both() -> None:
    scene = read_scene(with_track(left="wall", right_is="foam"))
    assert "From outside: the wall and the foam gave" in run_as_text(run(scene))
    assert "From outside: walls gave" in run_as_text(run(read_scene(AGAINST)))


def test_two_ends_of_one_name_are_told_apart_by_their_sides() -> None:
    track = read_scene(with_track(left="wall", left_is="foam", right_is="foam")).track
    names = [body_name(name, track) for name in ("left", "A", "right")]
    assert names == ["the foam on the left", "A", "the foam on the right"]
    other = read_scene(with_track(left="wall", right_is="foam")).track
    assert [body_name(name, other) for name in ("left", "right")] == ["the wall", "the foam"]
    assert body_name("right", read_scene(with_track()).track) == "the wall"
    both = read_scene(with_track(left="wall")).track
    assert body_name("right", both) == "the right wall"


def test_mistakes_and_warnings_call_it_by_its_name() -> None:
    track = with_track(right_is="board")["track"]
    carts = {"A": {**AGAINST["carts"]["A"], "position": "1.15 m"}}
    _, code, message, hint = refusal(track, carts=carts)
    assert (code, message) == ("overlap", "A reaches into the board by 0.05 m at the start")
    assert hint.startswith("move it away: a position is that of the cart's centre")
    carts = {"A": {**AGAINST["carts"]["A"], "bumper_length": "0.02 m"}}
    (warning,) = report(run(read_scene({**AGAINST, "track": track, "carts": carts})))["warnings"]
    assert warning["message"].startswith("The bumper between A and the board would be squeezed")


def test_a_map_calls_it_by_its_name() -> None:
    over = [{"set": "A.mass", "from": "0.5 kg", "to": "1 kg"}]
    more = {"id": "one", "over": over, "show": "F.A-right"}
    labels = [
        read_map({**plain, **more}).show.label for plain in (AGAINST, with_track(right_is="spring"))
    ]
    assert labels == [
        "greatest force between A and the wall",
        "greatest force between A and the spring",
    ]


def preset(**changes: Any) -> dict[str, Any]:
    told = {key.replace("__", "."): value for key, value in changes.items()}
    return {**AGAINST, "id": "one", "presets": {"soft": told}}


def test_a_preset_may_change_it_and_no_number_of_it() -> None:
    fence = read_fence(preset(contact__stiffness="60 N/m", track__right_is="spring"))
    changes = fence.presets["soft"]
    assert read_scene(apply_changes(fence.plain, changes)).track.right_is == "spring"
    assert numbers_of(fence.plain, changes) == {"contact.stiffness": 60.0}


def test_a_preset_that_names_an_unknown_thing_is_refused() -> None:
    with pytest.raises(SceneError) as caught:
        read_fence(preset(track__right_is="mud"))
    (problem,) = caught.value.problems
    assert (problem.where, problem.code) == ("presets.soft.track.right_is", "not-a-choice")
