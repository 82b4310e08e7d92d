"""From a row of a key file to the question that it was made of, a kind after the other."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.classroom.refusal import RefusalError
from sim.lesson.kinds.arrange import Matching, Ordering
from sim.lesson.kinds.choice import Multiple, Option, Single
from sim.lesson.kinds.idea import Idea
from sim.lesson.kinds.interactions import Interactions
from sim.lesson.kinds.links import Known, Link
from sim.lesson.kinds.number import Number, Wrong
from sim.lesson.kinds.sure import Confidence
from sim.lesson.kinds.table import Open, Table
from sim.lesson.kinds.words import Long, Short
from sim.lesson.question import Common, Question
from sim.lesson.read import KINDS

CHOSEN: dict[str, type[Single | Idea]] = {kind.KIND: kind for kind in (Single, Multiple, Idea)}
"""Kinds in which options are chosen; in an idea none of them is right."""


def question_of(row: Mapping[str, Any], common: Common) -> Question:
    """The question; raises KeyError, TypeError or ValueError where the row is damaged."""
    kind, key, texts = str(row["type"]), row["key"], row.get("texts", {})
    said = {str(k): str(v) for k, v in row.get("feedback", {}).items()}
    if kind in CHOSEN:
        options = tuple(
            Option(
                id=str(name),
                text=str(texts.get(f"option-{name}", "")),
                correct=name in key["correct"],
                belief=str(key["beliefs"].get(name, "")),
                feedback=said.get(f"option-{name}", ""),
            )
            for name in row["options"]
        )
        return CHOSEN[kind](common=common, options=options)
    if kind == "number":
        wrong = tuple(
            Wrong(
                value=float(w["value"]),
                tolerance=float(w["tolerance"]),
                belief=w["belief"],
                feedback=said.get(f"wrong-{k}", ""),
            )
            for k, w in enumerate(key["wrong"])
        )
        units = {str(name): float(factor) for name, factor in row["units"].items()}
        return Number(
            common=common, answer=float(key["answer"]), tolerance=float(key["tolerance"]),
            unit=str(row["unit"]), units=units, wrong=wrong,
        )  # fmt: skip
    if kind in ("short", "long"):
        rubric = {int(marks): str(text) for marks, text in row.get("rubric", {}).items()}
        rubric = rubric or {common.marks: ""}
        if kind == "long":
            return Long(common=common, rubric=rubric)
        known = tuple(
            (tuple(w["texts"]), str(w["belief"]), said.get(f"wrong-{k}", ""))
            for k, w in enumerate(key["wrong"])
        )
        return Short(common=common, rubric=rubric, accept=tuple(key["accept"]), wrong=known)
    if kind == "ordering":
        return Ordering(common=common, order=tuple(texts[f"line-{k}"] for k in key["order"]))
    if kind == "matching":
        return _matching(row, common)
    if kind == "table":
        return _table(row, common)
    if kind == "interactions":
        return _interactions(row, common)
    if kind == "confidence":
        return Confidence(common=common)
    return KINDS[kind].from_key(row, common)


def _table(row: Mapping[str, Any], common: Common) -> Table:
    """Heads, given cells, and the interval of each other one."""
    cells, asked = row["key"]["cells"], row["cells"]

    def cell(name: str, given: str | None) -> str | Open:
        if given is not None:
            return given
        right = cells[name]
        unit = str(asked[name]["unit"])
        return Open(float(right["answer"]), float(right["tolerance"]), unit, {})

    rows = tuple(
        tuple(cell(f"{r}-{c}", given) for c, given in enumerate(line, start=1))
        for r, line in enumerate(row["rows"], start=1)
    )
    plot = (int(row["plot"][0]) - 1, int(row["plot"][1]) - 1) if row["plot"] else None
    return Table(common=common, columns=tuple(row["columns"]), rows=rows, plot=plot)


def _interactions(row: Mapping[str, Any], common: Common) -> Interactions:
    """The boxes, the right links, and the beliefs behind invented ones."""
    objects, key = tuple(map(str, row["objects"])), row["key"]

    def ends(told: Mapping[str, Any]) -> tuple[int, int]:
        a, b = told["between"]
        return objects.index(a), objects.index(b)

    return Interactions(
        common=common,
        objects=objects,
        links=tuple(Link(*ends(link), link["by"]) for link in key["links"]),
        focus=tuple(objects.index(name) for name in row["focus"]),
        wrong=tuple(
            Known(*ends(told), tuple(told["by"]), "", str(told["belief"])) for told in key["wrong"]
        ),
    )


def _matching(row: Mapping[str, Any], common: Common) -> Matching:
    """The pairs in their order, then what belongs to nothing."""
    pairs, texts = row["key"]["pairs"], row["texts"]
    letters = [pairs[number] for number in row["left"]]
    others = [letter for letter in row["right"] if letter not in letters]
    question = Matching(
        common=common,
        left=tuple(texts[f"left-{number}"] for number in row["left"]),
        right=tuple(texts[f"right-{letter}"] for letter in (*letters, *others)),
    )
    if question.key()["pairs"] != pairs:
        raise RefusalError("the letters of this item are not those of the page")
    return question
