"""What was asked: from the keys where they are there, else from the answers themselves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.report.items.choices import letter
from sim.classroom.report.items.rows import item_rows, question_label
from sim.classroom.summary.of_answers import meta_of
from sim.country.cells import Cell
from sim.country.refusal import CountryError
from sim.country.rows import BETWEEN, OPTIONS
from sim.scene.said import said

MOST_ITEMS = 2_000
"""Questions of a form, as in a summary."""

MOST_OPTIONS = 200
"""Different answers to one question that are listed."""


@dataclass(frozen=True, slots=True)
class Asked:
    """Questions of a form in their order, as the rows of a report ask them."""

    items: tuple[Mapping[str, Any], ...]


def asked_in(cells: Sequence[Cell], key: KeyedForm | None) -> Asked:
    """The questions of a form; raises `CountryError` where there are far too many."""
    by_item: dict[str, list[Cell]] = {}
    for cell in cells:
        by_item.setdefault(cell["item"], []).append(cell)
    if len(by_item) > MOST_ITEMS:
        raise CountryError(said("a form with more than {most} questions", most=f"{MOST_ITEMS:,}"))
    if key is not None and by_item.keys() <= key.items.keys():
        return Asked(tuple(map(meta_of, item_rows([], key, ()))))
    order = sorted(by_item, key=lambda name: (_place(by_item[name]), name))
    return Asked(tuple(_meta(name, by_item[name]) for name in order))


def _place(cells: Sequence[Cell]) -> int:
    return min((c["position"] for c in cells if c["position"] is not None), default=0)


def _meta(name: str, cells: Sequence[Cell]) -> dict[str, Any]:
    place = _place(cells)
    kind = min(cell["type"] for cell in cells)
    choices = _choices(cells) if kind in OPTIONS else []
    return {
        "id": name, "label": question_label(place) if place else name, "ask": "", "type": kind,
        "worth": max((cell["worth"] or 0 for cell in cells), default=0),
        "sure": bool(place) and any(cell["certain"] for cell in cells), "choices": choices,
    }  # fmt: skip


def _choices(cells: Sequence[Cell]) -> list[dict[str, Any]]:
    """Options that somebody chose; right is what alone gave all marks."""
    options = sorted({o for cell in cells for o in cell["chosen"].split(BETWEEN) if o})
    wholes = {cell["chosen"] for cell in cells if cell["verdict"] == "right" and cell["worth"]}
    right = {part for whole in wholes for part in whole.split(BETWEEN)}
    marked = any(cell["verdict"] is not None for cell in cells)
    return [
        {"option": o, "label": letter(o), "text": "",
         **({"correct": o in right, "belief": "", "says": ""} if marked else {})}
        for o in options[:MOST_OPTIONS]
    ]  # fmt: skip
