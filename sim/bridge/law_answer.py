"""Laws that somebody wrote, as the wire delivers them: a run, and parts of a judgement.

    {"id": 9, "kind": "law", "do": "run", "scene": {… with "laws": {"mine.py": "def force …"}}}
    {"id": 10, "kind": "law", "do": "judge", "law": "mine.py", "scene": {…}, "part": 0,
     "before": null}

A run is answered like any other (see `protocol`), with columns ("on", pair, body) [N] where the two
sides were answered differently. `law`: which of the scene's laws is judged; without it the first.
`before` is what the part before has told. A law that cannot be asked is a problem with
its line: path ("laws", file, line).
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping
from typing import Any

from sim.bridge.protocol import effects_of, plain_of, wire
from sim.mine.document import document
from sim.mine.follow import follow
from sim.mine.judge.document import for_page, judged_so_far
from sim.mine.judge.search import PARTS, judge_part
from sim.mine.wrong import WrongLawError
from sim.scene import Problem, Scene, SceneError, read_scene
from sim.scene.said import said

Answer = tuple[dict[str, Any], "array[float]"]


def law_answer(request: Mapping[str, Any]) -> Answer:
    """Header and numbers; raises SceneError or UnsolvedError."""
    plain = plain_of(request)
    scene = read_scene(plain)
    if not scene.written:
        message = said("this scene names no law of its own")
        raise SceneError([Problem(("contact", "law"), "no-law", message, "")])
    if request.get("do") == "judge":
        return _judged(request, scene), array("d")
    return run_written(plain, scene)


def run_written(plain: Mapping[str, Any], scene: Scene) -> Answer:
    """The run of a scene with such a law."""
    try:
        done = follow(scene)
    except WrongLawError as error:
        raise SceneError([problem_of(error)]) from error
    header, numbers = wire(done.run, done.samples, document(done))
    header["effects"] = effects_of(plain, scene)
    header["unequal"] = done.unequal
    return header, numbers


def _judged(request: Mapping[str, Any], scene: Scene) -> dict[str, Any]:
    """One part: what was found up to now, and which part comes next (null: none)."""
    file = str(request.get("law") or next(iter(scene.written)))
    if file not in scene.written:
        message = said("there is no text of the law {name}", name=file)
        raise SceneError([Problem(("laws", file), "no-such-law", message, "")])
    text = scene.written[file]
    part, before = int(request.get("part") or 0), request.get("before")
    so_far = judged_so_far(before, {file: text}) if isinstance(before, Mapping) else None
    try:
        judged = judge_part(text, file, part, so_far, scene=scene)
    except WrongLawError as error:
        raise SceneError([problem_of(error)]) from error
    following = part + 1 if part + 1 < PARTS else None
    return {"judged": for_page(judged), "next": following, "parts": PARTS}


def problem_of(error: WrongLawError) -> Problem:
    """Where, what, and what would help."""
    message = said("line {line}: {message}", line=str(error.line), message=error.message)
    return Problem(("laws", error.file, error.line), "law", message, error.hint)
