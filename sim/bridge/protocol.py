"""The protocol between page and simulation: plain values in, a header and numbers out.

    {"id": 7, "kind": "run", "scene": {...plain scene...}, "set": {"A.mass": 2}}

(`"samples"`, if given, is the number of samples per quarter swing of a contact)

is answered by a header (JSON) and one array of float64, column after column. The header of a
refusal has `"ok": false` and the problems, each with its key path; nothing is ever raised for
what a reader or an author typed. Each other kind of request (OTHERS) has a module of its own, which
is loaded when it is asked for.
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping
from importlib import import_module
from typing import Any

from sim.bridge.alive import alive
from sim.dynamics.loop.run import is_of_the_numbers, out_of_range, run
from sim.dynamics.report.document import report
from sim.dynamics.report.plan import not_simulated
from sim.dynamics.result.finished import Run
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.result.trajectory import PER_STRETCH, Trajectory, trajectory
from sim.scene import Problem, Scene, SceneError, apply_changes, read_scene
from sim.scene.effects import kinds
from sim.scene.reading.effects import all_effects
from sim.scene.said import said
from sim.scene.said import wire as said_by
from sim.scene.track import named_ends

MOST_STEPS_DRAWN = 2_500
"""Steps of contacts that push each other: a few seconds in a page."""

MOST_EVENTS_DRAWN = 20_000
"""A page stops a run here: more events than this can neither be drawn nor listed."""

OTHERS = {
    "map": "sim.bridge.map_answer",
    "cost": "sim.bridge.cost_answer",
    "how": "sim.bridge.how_answer",
    "hard": "sim.bridge.hard_answer",
    "energy": "sim.bridge.energy_answer",
    "model": "sim.bridge.model_text",
    "relevance": "sim.bridge.relevance_answer",
    "class": "sim.bridge.class_answer",
    "measured": "sim.bridge.measured_answer",
    "worlds": "sim.bridge.worlds_answer",
    "law": "sim.bridge.law_answer",
    "certify": "sim.bridge.certify_answer",
    "teach": "sim.pages.teach.answer",
}
"""Module of each other kind of request; it holds a function KIND_answer. The last six are in
packages of their own, which only the pages load that ask for them."""

OF_RUNS = ("map", "cost", "how", "hard", "worlds", "law")
"""Kinds that run what a reader has set: numbers beyond all bounds are its doing there, and no fault
of ours."""

Answer = tuple[dict[str, Any], "array[float]"]


def answer(request: Mapping[str, Any]) -> Answer:
    """Answer one request."""
    identity = request.get("id")
    if request.get("kind") in OTHERS:
        return _other(request)
    if request.get("kind") != "run":
        problem = Problem(("kind",), "unknown-kind", said("this request is not known"), "kind: run")
        return refusal(identity, [problem])
    try:
        plain = plain_of(request)
        scene = read_scene(plain)
        if scene.written:
            header, numbers = import_module(OTHERS["law"]).run_written(plain, scene)
            return {"id": identity, "ok": True, **header}, numbers
        finished = run(
            scene, max_events=MOST_EVENTS_DRAWN, max_steps=MOST_STEPS_DRAWN, progress=_at_work
        )
    except SceneError as error:
        return refusal(identity, error.problems)
    except UnsolvedError as error:
        return refusal(identity, [Problem((), "unsolved", error.message, error.hint)])
    samples = request.get("samples")
    header, numbers = describe(finished, samples if isinstance(samples, int) else PER_STRETCH)
    header["effects"] = effects_of(plain, finished.scene)
    return {"id": identity, "ok": True, **header}, numbers


def _at_work(t: float, events: int) -> None:
    """On a slow laptop a run takes longer than a page waits for a silent Python."""
    del t, events
    alive()


def plain_of(request: Mapping[str, Any]) -> dict[str, Any]:
    """The scene that a request is about, with the values that the reader has set; may raise
    `SceneError`."""
    return apply_changes(request.get("scene") or {}, request.get("set") or {})


def _other(request: Mapping[str, Any]) -> Answer:
    """What is loaded only where it is asked for."""
    kind = str(request.get("kind"))
    try:
        asked = getattr(import_module(OTHERS[kind]), f"{kind}_answer")
        header, numbers = asked(request)
    except SceneError as error:
        return refusal(request.get("id"), error.problems)
    except UnsolvedError as error:
        problem = Problem((), "unsolved", error.message, error.hint)
        return refusal(request.get("id"), [problem])
    except (ArithmeticError, ValueError) as error:
        if kind not in OF_RUNS or not is_of_the_numbers(error):
            raise
        return refusal(request.get("id"), [_beyond(stepped="method" in request)])
    return {"id": request.get("id"), "ok": True, **header}, numbers


def _beyond(*, stepped: bool) -> Problem:
    """Numbers overflowed: the steps of a method are too long, or no numbers are enough."""
    if stepped:
        message = said("the numbers of this method grow beyond all bounds")
        return Problem((), "unsolved", message, said("a shorter step"))
    error = out_of_range()
    return Problem((), "unsolved", error.message, error.hint)


def refusal(identity: object, problems: list[Problem] | tuple[Problem, ...]) -> Answer:
    """The answer to a request that cannot be run."""
    listed = [
        {
            "path": list(p.path),
            "code": p.code,
            "message": said_by(p.message),
            "hint": said_by(p.hint),
        }
        for p in problems
    ]
    return {"id": identity, "ok": False, "problems": listed}, array("d")


def describe(finished: Run, per_stretch: int = PER_STRETCH) -> Answer:
    """Header and numbers of a finished run."""
    return wire(
        finished, trajectory(finished, max(1, per_stretch), at_work=alive), report(finished)
    )


def wire(finished: Run, samples: Trajectory, told: dict[str, Any]) -> Answer:
    """The same of a run with its samples and its report, whoever made them."""
    scene = finished.scene
    numbers = array("d")
    for column in samples.columns.values():
        numbers.extend(column)
    header = {
        "title": scene.title,
        "until": scene.until,
        "gravity": scene.gravity,
        "bodies": _bodies(scene),
        "track": track_of(scene),
        "contacts": _contacts(scene),
        "rows": samples.rows,
        "columns": [list(name) for name in samples.columns],
        "notSimulated": list(not_simulated(scene)),
        **told,
        "plan": [{**phase, "why": said_by(phase["why"])} for phase in told["plan"]],
        "warnings": [{**row, "message": said_by(row["message"])} for row in told["warnings"]],
    }
    return header, numbers


def track_of(scene: Scene) -> dict[str, Any]:
    """The track and its ends; `left_is` and `right_is` only where it is not a wall."""
    track = scene.track
    ends = {"left": track.left, "right": track.right, "length": track.length}
    return {**ends, **named_ends(track)}


def _bodies(scene: Scene) -> list[dict[str, Any]]:
    return [
        {
            "name": cart.name,
            "mass": cart.mass,
            "position": cart.position,
            "velocity": cart.velocity,
            "length": cart.length,
            "bumper_length": cart.bumper_length,
        }
        for cart in scene.carts
    ]


def effects_of(plain: Mapping[str, Any], scene: Scene) -> list[dict[str, Any]]:
    """Everything that the scene lists, with what is switched off: SI numbers, carts, agents.

    `agent` and `called` are English: who pushes (empty: `by`, or the other of the two), and the
    effect's name in a sentence. Forces on single carts have columns ("E", kind, cart).
    """
    return [
        {
            "kind": effect.kind,
            "index": effect.index,
            "active": effect.active,
            "numbers": dict(effect.numbers),
            "carts": list(effect.carts),
            "between": None if effect.between is None else list(effect.between),
            "by": effect.by,
            "agent": kinds()[effect.kind].agent,
            "called": kinds()[effect.kind].called or effect.kind,
        }
        for effect in all_effects(plain, scene)
    ]


def _contacts(scene: Scene) -> list[dict[str, Any]]:
    listed = []
    for k, contact in enumerate(scene.contacts):
        if contact is not None:
            names = scene.names_at(k)
            listed.append(
                {
                    "pair": "-".join(names),
                    "bodies": list(names),
                    "law": contact.law,
                    "restitution": contact.restitution,
                    "stiffness": contact.stiffness,
                }
            )
    return listed
