"""An interaction diagram: objects, and the links between those that push or pull each other.

    objects: [book, table, Earth]
    contact: [[book, table]]
    distance: [[book, Earth]]
    focus: book
    missing:
      - {between: [book, Earth], feedback: "What would the book do without the table?"}
    wrong:
      - {between: [book, Earth], by: contact, feedback: "What does the book touch?"}

A link is two forces, one on each of its objects: the page says both, whichever was meant first. It
has no direction and no size, so those are not asked here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self, cast

from sim.lesson import keys
from sim.lesson.keys import PROSE, PROSES, Key
from sim.lesson.kinds.links import (
    HINT,
    INVENTED_KEYS,
    LINKS_SCHEMA,
    MISSING_KEYS,
    WAYS,
    By,
    Known,
    Link,
    ends_of,
    read_known,
    read_links,
    rows_schema,
)
from sim.lesson.mark import Mark, all_or_nothing, is_empty
from sim.lesson.question import Common, Question
from sim.scene.problem import Path, Problem

FEWEST, MOST = 2, 6  # objects: more do not fit a phone
LONGEST = 14  # characters of a name, as many as a box on a phone holds


@dataclass(frozen=True, slots=True, kw_only=True)
class Interactions(Question):
    """The value is a list of links `{between: [a, b], by}`, objects in the order of the author."""

    KIND: ClassVar[str] = "interactions"
    SAYS: ClassVar[str] = "draw who pushes or pulls whom"
    KEYS: ClassVar[tuple[Key, ...]] = (
        Key("objects", f"the boxes, {FEWEST} to {MOST}; at most {LONGEST} characters each",
            "[book, table, Earth]", {"type": "array", "items": PROSE, "minItems": FEWEST,
            "maxItems": MOST}, True),
        Key("contact", "pairs that act on each other by touching", "[[book, table]]", LINKS_SCHEMA),
        Key("distance", "pairs that act without touching", "[[book, Earth]]", LINKS_SCHEMA),
        Key("focus", "objects whose forces are listed beside the diagram", "book", PROSES),
        Key("missing", "what is said where a right link is missing: `between`, `by`, `feedback`",
            '[{between: [book, Earth], feedback: "Why does it fall?"}]', rows_schema(MISSING_KEYS)),
        Key("wrong", "what is said to an invented link: `between`, `by`, `belief`, `feedback`",
            '[{between: [book, Earth], by: contact, feedback: "Do they touch?"}]',
            rows_schema(INVENTED_KEYS)),
    )  # fmt: skip
    objects: tuple[str, ...]
    links: tuple[Link, ...]
    focus: tuple[int, ...] = ()
    missing: tuple[Known, ...] = ()
    wrong: tuple[Known, ...] = ()

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """Different objects, at least one link, and rows about links that can be meant."""
        before = len(problems)
        objects = keys.texts(table, "objects", path, problems, "objects: [book, table, Earth]")
        fits = FEWEST <= len(set(objects)) == len(objects) <= MOST
        if len(problems) == before and (not fits or max(map(len, objects)) > LONGEST):
            message = (
                f"objects lists {FEWEST} to {MOST} different names of up to {LONGEST} characters"
            )
            where = (*path, "objects") if "objects" in table else path
            problems.append(Problem(where, "not-a-list", message, "objects: [book, table, Earth]"))
        # Whatever is said about the rest would follow from this.
        if len(problems) > before and "objects" in table:
            return cls(common=common, objects=(), links=())
        links = read_links(table, objects, path, problems)
        if not links and (len(problems) == before or "objects" not in table):
            message = "contact or distance lists at least one link"
            problems.append(Problem(path, "missing", message, HINT))
        focus = keys.texts(table, "focus", path, problems, "focus: book")
        if not set(focus) <= set(objects):
            message = f"focus is one of the objects: {', '.join(objects)[:80]}"
            problems.append(Problem((*path, "focus"), "not-a-choice", message, "focus: book"))
            focus = ()
        missing = read_known(table, "missing", objects, set(links), path, problems)
        wrong = read_known(table, "wrong", objects, set(links), path, problems)
        return cls(
            common=common, objects=objects, links=links, missing=tuple(missing),
            wrong=tuple(wrong), focus=tuple(objects.index(name) for name in focus),
        )  # fmt: skip

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """The boxes, the right links, and the beliefs behind invented ones."""
        objects, key = tuple(map(str, row["objects"])), row["key"]

        def ends(told: Mapping[str, Any]) -> tuple[int, int]:
            a, b = told["between"]
            return objects.index(a), objects.index(b)

        return cls(
            common=common,
            objects=objects,
            links=tuple(Link(*ends(link), link["by"]) for link in key["links"]),
            focus=tuple(objects.index(name) for name in row["focus"]),
            wrong=tuple(
                Known(*ends(told), tuple(told["by"]), "", str(told["belief"]))
                for told in key["wrong"]
            ),
        )

    def asked(self) -> dict[str, Any]:
        """The boxes, and those whose forces are listed."""
        return {"objects": list(self.objects), "focus": [self.objects[k] for k in self.focus]}

    def key(self) -> dict[str, Any]:
        """The right links, and the rows about missing and invented ones."""
        return {
            "links": [self._row(link) for link in self.links],
            "missing": [self._told(known) for known in self.missing],
            "wrong": [self._told(known) | {"belief": known.belief} for known in self.wrong],
            "feedback": sorted(self.feedback()),
        }

    def feedback(self) -> dict[str, str]:
        """`missing-1`, `wrong-1`: the rows that say something."""
        rows = {f"missing-{k}": known.feedback for k, known in enumerate(self.missing, start=1)}
        rows |= {f"wrong-{k}": known.feedback for k, known in enumerate(self.wrong, start=1)}
        return {name: text for name, text in rows.items() if text}

    def meaning(self) -> dict[str, Any]:
        """The boxes alone: what stands beside them changes no answer."""
        return {"objects": list(self.objects)}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Right as a whole; partly with half of the links and none invented.

        `shown` names each right link (`link-1-2-contact`), the rows about invented links that fit,
        and of those about missing ones the first: one question at a time.
        """
        del own
        of = self.common.marks
        if is_empty(value):
            return Mark("empty", 0, of)
        drawn = self.drawn(value)
        if drawn is None:
            return Mark("unclear", 0, of)
        right = set(self.links)
        lost, invented = right - drawn, drawn - right
        asks = _fitting("missing", self.missing, lost)
        answers = _fitting("wrong", self.wrong, invented)
        shown = [f"link-{link.name}" for link in self.links if link in drawn]
        return all_or_nothing(
            not lost and not invented,
            not invented and 2 * len(lost) <= len(right),
            of,
            shown=(*shown, *asks[:1], *answers),
            beliefs=tuple(one.belief for one in self.wrong if one.belief and one.fits(invented)),
        )

    def _row(self, link: Link) -> dict[str, Any]:
        return {"between": [self.objects[link.a], self.objects[link.b]], "by": link.by}

    def _told(self, known: Known) -> dict[str, Any]:
        return {"between": [self.objects[known.a], self.objects[known.b]], "by": list(known.by)}

    def drawn(self, value: object) -> set[Link] | None:
        """The links of an answer; None where it cannot be understood."""
        if not isinstance(value, (list, tuple)):
            return None
        links = set()
        for row in value:
            if not isinstance(row, Mapping) or row.get("by") not in WAYS:
                return None
            ends = ends_of(row.get("between"), self.objects)
            if ends is None:
                return None
            links.add(Link(*ends, cast("By", row["by"])))
        return links


def _fitting(word: str, known: tuple[Known, ...], links: set[Link]) -> list[str]:
    """The names of the rows that say something to one of the links."""
    rows = enumerate(known, start=1)
    return [f"{word}-{k}" for k, one in rows if one.feedback and one.fits(links)]
