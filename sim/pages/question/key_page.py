"""The teacher's key of a lesson: answers, rubrics, beliefs, notes; as a file and as a page."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from sim.dynamics.result.outcome import UnsolvedError
from sim.lesson import Question
from sim.lesson.key_file import item_key, key_file
from sim.lesson.kinds.run import Reading
from sim.pages.blocks.scene_block import Lesson
from sim.pages.question.as_opened import as_opened
from sim.pages.question.inside import to_html, to_inline
from sim.pages.question.of_lesson import lesson_asks
from sim.pages.question.render import FORM_NAMES
from sim.pages.templates import templates
from sim.scene import Fence


@dataclass(frozen=True, slots=True)
class Key:
    """The key of one lesson: for programs and for people."""

    content: dict[str, Any]
    page: str


def lesson_key(text: str, lesson: Lesson, name: str, site: str) -> Key | None:
    """The key of a lesson's text; None if it asks nothing. Raises `AuthorError`."""
    asks = lesson_asks(text, lesson)
    own, forms = asks.own, asks.forms
    if not own and not forms:
        return None
    parts = [("Worksheet", own)] if own else []
    parts += [(form.title or FORM_NAMES[form.form], form.items) for form in forms]
    rows = [
        (title, [_row(item, k, asks.scenes) for k, item in enumerate(part, 1)])
        for title, part in parts
    ]
    page = (
        templates("sim.pages.question").get_template("key.html.j2").render(lesson=name, parts=rows)
    )
    return Key(
        key_file(site, name, own, forms, title=asks.title, optional=asks.optional), str(page)
    )


def _row(item: Question, number: int, scenes: Mapping[str, Fence]) -> dict[str, Any]:
    key = item_key(item)
    right = key["key"].get("correct", [])
    beliefs = key["key"].get("beliefs", {})
    return {
        "number": number,
        "id": item.id,
        "kind": item.KIND,
        "ask": Markup(to_html(item.common.ask)),
        "options": [
            {
                "letter": letter.upper(),
                "text": Markup(to_inline(item.texts()[f"option-{option}"])),
                "right": option in right,
                "belief": key["beliefs"].get(beliefs.get(option, ""), ""),
            }
            for letter, option in zip("abcdefghijkl", key.get("options", []), strict=False)
            if f"option-{option}" in item.texts()
        ],
        "answer": answer_words(item, key["key"]) + _where_it_opens(item, scenes),
        "rubric": [(marks, Markup(to_html(text))) for marks, text in key.get("rubric", {}).items()],
        "explain": Markup(to_html(key.get("explain", ""))),
        "note": Markup(to_html(key.get("note", ""))),
    }


def _where_it_opens(item: Question, scenes: Mapping[str, Fence]) -> str:
    """Of a reading: the number with the settings of the page, three digits of it."""
    if not isinstance(item, Reading) or item.scene not in scenes:
        return ""
    try:
        found = as_opened(item, scenes[item.scene].scene)
    except UnsolvedError:
        return ""
    return "" if found is None else f" (as the page opens: {found:.3g} {item.unit}".rstrip() + ")"


def answer_words(item: Question, key: dict[str, Any]) -> str:
    """The right answer of the kinds without options, in a line."""
    texts = {name: Markup(to_inline(text)) for name, text in item.texts().items()}
    if item.KIND == "number":
        unit = item.data(key=False)["unit"]
        return f"{key['answer']:g} ± {key['tolerance']:g} {unit}".strip()
    if item.KIND == "reading":
        data = item.data(key=False)
        size = 100 * key["tolerance"] if key["relative"] else key["tolerance"]
        near = f"{size:g} {'%' if key['relative'] else data['unit']}"
        return f"{data['quantity']} at {data['at']} in the student's own run, ± {near}"
    if item.KIND == "ordering":
        return Markup(" → ").join(texts[f"line-{line}"] for line in key["order"])
    if item.KIND == "table":
        cells = key["cells"].items()
        asked = item.data(key=False)["cells"]
        return "; ".join(
            f"{name}: {cell['answer']:g} {asked[name]['unit']} ± {cell['tolerance']:g}".strip()
            for name, cell in cells
        )
    if item.KIND == "interactions":
        return "; ".join(f"{' – '.join(link['between'])} ({link['by']})" for link in key["links"])
    if item.KIND == "matching":
        pairs = key["pairs"].items()
        joined = Markup("{} – {}").format
        return Markup("; ").join(
            joined(texts[f"left-{k}"], texts[f"right-{letter}"]) for k, letter in pairs
        )
    return " / ".join(key.get("accept", []))
