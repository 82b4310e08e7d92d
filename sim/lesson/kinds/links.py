"""The links of an interaction diagram, and what is said about missing and invented ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal, cast

from sim.lesson import keys
from sim.lesson.keys import PROSE, Key, one_of
from sim.lesson.kinds.options import read_belief
from sim.scene.problem import Path, Problem

By = Literal["contact", "distance"]
WAYS: tuple[By, ...] = ("contact", "distance")
PAIR: Mapping[str, Any] = {"type": "array", "items": PROSE, "minItems": 2, "maxItems": 2}
LINKS_SCHEMA: Mapping[str, Any] = {"type": "array", "items": PAIR}
BETWEEN = Key("between", "the two objects", "[book, Earth]", PAIR, True)
BY = Key("by", "only a link of this way; default: of either", "contact", one_of(*WAYS))
SAYS = Key("feedback", "shown then, best as a question", '"What does the book touch?"', PROSE)
MISSING_KEYS = (BETWEEN, BY, SAYS)
BELIEF = Key("belief", "tag of the belief behind it", "passive-cannot-push")
INVENTED_KEYS = (BETWEEN, BY, BELIEF, SAYS)
HINT = "contact: [[book, table]]"


def rows_schema(known: tuple[Key, ...]) -> Mapping[str, Any]:
    """The JSON Schema of a list of rows with these keys."""
    table = {key.name: key.schema for key in known}
    row = {"type": "object", "properties": table, "required": ["between"]}
    return {"type": "array", "items": row | {"additionalProperties": False}}


@dataclass(frozen=True, slots=True)
class Link:
    """Two objects by their places in the list, the smaller first, and the way they act."""

    a: int
    b: int
    by: By

    @property
    def name(self) -> str:
        """As in `Mark.shown`, objects counted from 1: `1-2-contact`."""
        return f"{self.a + 1}-{self.b + 1}-{self.by}"


@dataclass(frozen=True, slots=True)
class Known:
    """What is said where a link is missing or invented. `by`: the ways that are meant."""

    a: int
    b: int
    by: tuple[By, ...]
    feedback: str
    belief: str = ""

    def fits(self, links: set[Link]) -> bool:
        """Whether one of the links is meant."""
        return any(Link(self.a, self.b, way) in links for way in self.by)


def ends_of(pair: object, objects: tuple[str, ...]) -> tuple[int, int] | None:
    """The places of two different objects, the smaller first."""
    if not isinstance(pair, (list, tuple)) or len(pair) != 2:
        return None
    names = [str(name) for name in pair]
    if not all(name in objects for name in names):
        return None
    a, b = sorted(map(objects.index, names))
    return (a, b) if a != b else None


def read_links(
    table: Mapping[str, Any], objects: tuple[str, ...], path: Path, problems: list[Problem]
) -> tuple[Link, ...]:
    """The right links under `contact` and `distance`, in the order of the objects."""
    found = set()
    for way in WAYS:
        listed = table.get(way, [])
        if not isinstance(listed, (list, tuple)):
            problems.append(Problem((*path, way), "not-a-list", f"{way} lists pairs", HINT))
            continue
        for k, pair in enumerate(listed):
            ends = ends_of(pair, objects)
            if ends is None:
                message = "a link names two different objects of the list"
                problems.append(Problem((*path, way, k), "not-a-choice", message, HINT))
            elif (link := Link(*ends, way)) in found:
                message = "this link stands there twice"
                problems.append(Problem((*path, way, k), "twice", message, HINT))
            else:
                found.add(link)
    return tuple(sorted(found, key=lambda link: (link.a, link.b, link.by)))


def read_known(
    table: Mapping[str, Any],
    name: Literal["missing", "wrong"],
    objects: tuple[str, ...],
    right: set[Link],
    path: Path,
    problems: list[Problem],
) -> Iterator[Known]:
    """The rows under `missing` or `wrong`; one that could never be shown is a problem."""
    allowed = MISSING_KEYS if name == "missing" else INVENTED_KEYS
    hint = f"{name}: [{{between: [book, Earth], by: contact, feedback: …}}]"
    for here, row in keys.tables(table, name, allowed, path, problems, hint):
        ends = ends_of(row.get("between"), objects)
        if ends is None:
            message = "between names two different objects of the list"
            problems.append(Problem((*here, "between"), "not-a-choice", message, hint))
            continue
        ways = (cast("By", keys.choice(row, "by", WAYS, here, problems)),) if "by" in row else WAYS
        meant = tuple(way for way in ways if (Link(*ends, way) in right) == (name == "missing"))
        if not meant:
            fault = "no right link" if name == "missing" else "a right link"
            message = f"this is {fault}: the row is never shown"
            problems.append(Problem(here, "not-a-choice", message, hint))
        belief = read_belief(row, here, problems) if name == "wrong" else ""
        text = keys.text(row, "feedback", here, problems) or ""
        yield Known(*ends, meant, text, belief)
