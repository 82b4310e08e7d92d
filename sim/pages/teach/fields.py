"""The ordinary values of a block as fields of a form: which they are, what they are called.

What a scene or question may hold is known to its validators; here stands only which of it is
changed often, and by what name a teacher knows it. All else is changed in the block's text.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Literal

from sim.pages.teach.right_answers import may_be_right
from sim.pages.teach.spans import values
from sim.pages.text.fence_scan import Block
from sim.pages.text.yaml.source import KeyPath, Place
from sim.scene.fields import is_word
from sim.scene.laws import laws
from sim.scene.track import WHAT

Kind = Literal["line", "area", "choice"]
Named = Callable[[KeyPath], tuple[str, str] | None]
"""Group and label of a value by where it stands; None for one that is no field."""

TRUTH = ("true", "false")
CHOICES: dict[str, tuple[str, ...]] = {
    "law": tuple(laws()),
    "left": ("open", "wall"),
    "right": ("open", "wall"),
    "left_is": WHAT,
    "right_is": WHAT,
    "level": ("core", "support", "stretch"),
    "correct": TRUTH,
    "sure": TRUTH,
    "active": TRUTH,
    "forces": ("shown", "hidden"),
    "slow": ("auto", "never", "stops"),
}
NUMBERS = ("mass", "position", "velocity", "length", "restitution", "stiffness", "until", "gravity")
LONG = ("ask", "explain", "feedback", "text", "hints", "note", "start")

SCENE_ALONE = {
    "title": "Title",
    "until": "The run ends at",
    "gravity": "Free fall",
    "forces": "Forces are",
    "slow": "Slow motion",
}
SLIDER = {"from": "least", "to": "greatest", "step": "step"}
QUESTION_ALONE = {
    "ask": "Question",
    "answer": "Right answer",
    "tolerance": "How near counts",
    "unit": "Unit",
    "accept": "Right answer",
    "start": "Beginning given",
    "hints": "Hint",
    "explain": "Explanation",
    "note": "Note for teachers",
    "level": "Level",
    "minutes": "Minutes",
    "sure": "Ask how sure",
}
QUESTION_LISTS = {
    "hints": "Hint",
    "accept": "Right answer",
    "order": "Line",
    "others": "More on the right",
    "words": "Word",
}
OPTION = {"text": "text", "correct": "is right", "feedback": "feedback"}
WRONG = {"value": "value", "text": "text", "feedback": "feedback"}
PAIR = {"left": "left", "right": "right"}


@dataclass(frozen=True, slots=True)
class Field:
    """One field. `group`: the heading that it stands under, "" for none."""

    path: KeyPath
    group: str
    label: str
    kind: Kind
    value: str
    place: Place
    options: tuple[str, ...] = ()

    def as_row(self) -> dict[str, Any]:
        """Plain values, as the page gets them."""
        return asdict(self)


def fields(text: str, block: Block) -> tuple[Field, ...]:
    """The fields of a scene or question, in the order of its text."""
    named = {"scene": _in_scene, "question": _in_question}.get(block.name)
    found = tuple(_fields(text, block, named)) if named else ()
    return tuple(_with_rightness(found, may_be_right(block)))


def _fields(text: str, block: Block, named: Named) -> Iterator[Field]:
    for value in values(text, block):
        found = named(value.path)
        if found is None:
            continue
        group, label = found
        shown = value.value.rstrip("\n")
        key = str(next(k for k in reversed(value.path) if isinstance(k, str)))
        options = CHOICES.get(key, ()) if block.name == "scene" or len(value.path) != 4 else ()
        if key in PAIR and block.name == "question":
            options = ()
        if options and shown in options:
            yield Field(value.path, group, label, "choice", shown, value.place, options)
        else:
            long = (key in LONG and block.name == "question") or "\n" in shown or len(shown) > 60
            kind: Kind = "area" if long else "line"
            yield Field(value.path, group, label, kind, shown, value.place)


def _with_rightness(found: Sequence[Field], answers: int) -> Iterator[Field]:
    """The fields; after the text of an answer that does not say so, whether it is right."""
    said = {field.path for field in found}
    for field in found:
        yield field
        match field.path:
            case ("options", int(k)) | ("options", int(k), "text") if k < answers:
                path = ("options", k, "correct")
                if path not in said:
                    nowhere = field.place[0], 0  # no finding can stand here
                    yield Field(path, f"Answer {letter(k)}", OPTION["correct"], "choice",
                                "false", nowhere, TRUTH)  # fmt: skip


def _in_scene(path: KeyPath) -> tuple[str, str] | None:
    match path:
        case (str(key),) if key in SCENE_ALONE:
            return "", SCENE_ALONE[key]
        case ("carts", str(name), str(key)):
            return name if is_word(name) else f"Cart {name}", key.replace("_", " ")
        case ("contact", str(key)):
            return "Contact", key
        case ("contact", "pairs", str(pair), str(key)):
            return f"Contact of {pair}", key
        case ("track", str(key)):
            return "Track", f"{key} end" if key in PAIR else key.replace("_is", " end is")
        case ("controls", int(k), "set"):
            return f"Slider {k + 1}", "changes"
        case ("controls", int(k), str(key)) if key in SLIDER:
            return f"Slider {k + 1}", SLIDER[key]
        case ("effects", int(k), str(kind), str(key)):
            return f"Effect {k + 1}: {kind}", key
        case ("predict", "ask" | "text"):
            return "Prediction", "question"
        case ("predict", "choice", int(k)):
            return "Prediction", f"choice {k + 1}"
    return None


def _in_question(path: KeyPath) -> tuple[str, str] | None:
    match path:
        case (str(key),) if key in QUESTION_ALONE:
            return "", QUESTION_ALONE[key]
        case (str(key), int(k)) if key in QUESTION_LISTS:
            return "", f"{QUESTION_LISTS[key]} {k + 1}"
        case ("options", int(k)):
            return f"Answer {letter(k)}", "text"
        case ("options", int(k), str(key)) if key in OPTION:
            return f"Answer {letter(k)}", OPTION[key]
        case ("wrong", int(k), str(key)) if key in WRONG:
            return f"Wrong answer {k + 1}", WRONG[key]
        case ("missing", int(k), "feedback"):
            return f"Missing link {k + 1}", WRONG["feedback"]
        case ("pairs", int(k), str(key)) if key in PAIR:
            return f"Pair {k + 1}", PAIR[key]
        case ("rubric", str(marks)):
            return "Marking", f"{marks} marks" if marks != "1" else "1 mark"
    return None


def letter(k: int) -> str:
    """The name of an answer on the page: A, B, C …"""
    return chr(ord("A") + k) if k < 26 else str(k + 1)
