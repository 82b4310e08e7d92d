"""A form: a set of items of a bank, given to students before, after or long after a lesson."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from sim.lesson import keys
from sim.lesson.bank import Bank, known_items
from sim.lesson.keys import PROSE, TEXT, TEXTS, Key, one_of
from sim.lesson.opening import FORMS, RULES, Rule, check_order, read_rule
from sim.lesson.problems import LessonError
from sim.lesson.question import LEVELS, Question
from sim.scene.fence.presentation import ID
from sim.scene.problem import Path, Problem
from sim.scene.tables import mapping, unknown_keys

MODES = ("practice", "exam")
DRAW_KEYS = (
    Key("topics", "the item has all of these topics", "[first-law]", TEXTS),
    Key("level", "and this level", "core", one_of(*LEVELS)),
    Key("count", "how many", "7", {"type": "integer", "minimum": 1}, True),
)
_RULE = {"anyOf": [{"enum": ["now"]}, {"type": "object", "minProperties": 1}]}
FORM_KEYS = (
    Key("id", "name of the form, one of its kind in the site", "forces-pre", {
        "type": "string", "pattern": f"^{ID.pattern}$"}, True),
    Key("form", "which of a student's answers these are; one each on a page", "pre",
        one_of(*FORMS[1:]), True),
    Key("mode", "practice: feedback at once, the key is in the page. exam: neither", "exam",
        one_of(*MODES), True),
    Key("title", "shown above", "Before the lesson", PROSE),
    Key("intro", "shown before the first question, in Markdown", '"About 15 minutes, alone."',
        PROSE),
    Key("bank", "file in worksheets/banks/", "forces-and-motion.yml", TEXT, True),
    Key("use", "a form of that name in the bank", "test-15"),
    Key("items", "or: the ids of the items", "[pod, table]", TEXTS),
    Key("draw", "or: rules by which items are drawn, in the order of the bank",
        "[{topics: [first-law], count: 7}]", {"type": "array", "items": {"type": "object",
        "properties": {key.name: key.schema for key in DRAW_KEYS}, "required": ["count"],
        "additionalProperties": False}}),
    Key("minutes", "how long it takes", "15", {"type": "integer", "minimum": 1}),
    Key("sure", "ask after each item how sure the student is", "true", {"type": "boolean"}),
    Key("shuffle", "another order of the answers for each student", "true", {"type": "boolean"}),
    Key("open", "when it opens: now, or a rule", "{word: FALCON}", _RULE),
    Key("close", "when it closes: a rule with a date (the last day)", "{date: 2027-03-01}",
        {"type": "object"}),
    Key("review", "when a handed-in form may be looked at again: a rule; default: never",
        "{word: HARBOUR}", _RULE),
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Form:
    """A form with its items drawn. `items` are in the order shown."""

    id: str
    form: str
    mode: str
    title: str
    intro: str
    items: tuple[Question, ...]
    minutes: int | None
    shuffle: bool
    open: Rule
    close: Rule
    review: Rule | None

    @property
    def hash(self) -> str:
        """Twelve hexadecimal digits that change when an item, its answers or their order do."""
        text = "\n".join(f"{i.id} {i.hash} {i.asked().get('options')}" for i in self.items)
        return hashlib.sha256(text.encode("utf-8")).hexdigest()[:12]

    def facts(self) -> dict[str, Any]:
        """What the page knows of the form; the items tell their own."""
        return {
            "id": self.id, "form": self.form, "mode": self.mode, "hash": self.hash,
            "shuffle": self.shuffle, "items": [[i.id, radix(i)] for i in self.items],
            "open": self.open.facts(self.id), "close": self.close.facts(self.id),
            "review": None if self.review is None else self.review.facts(self.id),
        }  # fmt: skip


def radix(item: Question) -> int:
    """Of how many answers one is chosen; 0 for other kinds: a hand-in code cannot hold them."""
    return len(item.asked()["options"]) if item.KIND == "single" else 0


def bank_name(plain: object) -> str | None:
    """The bank that a quiz block names, so that its file can be read first."""
    name = plain.get("bank") if isinstance(plain, Mapping) else None
    return name if isinstance(name, str) else None


def read_form(plain: object, bank: Bank | None) -> Form:
    """The form that `plain` describes, drawn from `bank`; raises LessonError."""
    problems: list[Problem] = []
    table = mapping(plain, (), problems, "a quiz is a table of keys: id, form, mode, bank, …")
    if table is None:
        raise LessonError(problems)
    unknown_keys(table, keys.names(FORM_KEYS), (), problems)
    identity = keys.needed(table, "id", (), problems, "id: forces-pre")
    if identity and not ID.fullmatch(identity):
        message = f"“{identity[:40]}” cannot be an id"
        hint = "small letters, digits and hyphens: id: forces-pre"
        problems.append(Problem(("id",), "bad-name", message, hint))
    for name, words in (("form", FORMS[1:]), ("mode", MODES)):
        if name not in table:
            message = f"{name} is missing"
            problems.append(Problem((), "missing", message, f"{name}: {' or '.join(words)}"))
    keys.needed(table, "bank", (), problems, "bank: forces-and-motion.yml")
    sure = keys.flag(table, "sure", (), problems, default=False)
    form = Form(
        id=identity,
        form=keys.choice(table, "form", FORMS[1:], (), problems),
        mode=keys.choice(table, "mode", MODES, (), problems),
        title=keys.text(table, "title", (), problems) or "",
        intro=keys.text(table, "intro", (), problems) or "",
        items=tuple(_asks_sure(item) if sure else item for item in _drawn(table, bank, problems)),
        minutes=keys.whole(table, "minutes", (), problems, default=1)
        if "minutes" in table
        else None,
        shuffle=keys.flag(table, "shuffle", (), problems, default=False),
        open=read_rule(table, "open", RULES, problems),
        close=read_rule(table, "close", ("date",), problems),
        review=read_rule(table, "review", RULES, problems) if "review" in table else None,
    )
    check_order(form.open, form.close, problems)
    if problems:
        raise LessonError(problems)
    return form


def _asks_sure(item: Question) -> Question:
    return replace(item, common=replace(item.common, sure=True))


def _drawn(
    table: Mapping[str, Any], bank: Bank | None, problems: list[Problem]
) -> tuple[Question, ...]:
    ways = [name for name in ("use", "items", "draw") if name in table]
    if len(ways) != 1:
        message = "a quiz has exactly one of use, items and draw"
        problems.append(Problem((ways[1],) if ways else (), "not-a-choice", message, HINT_WAYS))
        return ()
    if bank is None:
        return ()
    if ways == ["use"]:
        name = str(table["use"])
        if name not in bank.forms:
            message = f"the bank has no form “{name[:40]}”"
            known = ", ".join(bank.forms) or "none"
            problems.append(Problem(("use",), "unknown-form", message, f"its forms: {known}"))
        return tuple(bank.items[i] for i in bank.forms.get(name, ()))
    if ways == ["items"]:
        ids = keys.texts(table, "items", (), problems, "items: [pod, table]")
        known_items(ids, bank.items, ("items",), problems)
        return tuple(bank.items[i] for i in ids if i in bank.items)
    return _by_rules(table["draw"], bank, problems)


HINT_WAYS = "use: test-15, or items: [pod, table], or draw: [{topics: [first-law], count: 7}]"


def _by_rules(rules: object, bank: Bank, problems: list[Problem]) -> tuple[Question, ...]:
    """Items in the order of the bank, each once; every rule takes the first that fit."""
    taken: dict[str, Question] = {}
    if not isinstance(rules, (list, tuple)):
        problems.append(Problem(("draw",), "not-a-list", "draw is a list of rules", HINT_WAYS))
        return ()
    for k, rule in enumerate(rules):
        path: Path = ("draw", k)
        row = mapping(rule, path, problems, HINT_WAYS)
        if row is None:
            continue
        unknown_keys(row, keys.names(DRAW_KEYS), path, problems)
        topics = keys.texts(row, "topics", path, problems, "topics: [first-law]")
        level = keys.choice(row, "level", LEVELS, path, problems) if "level" in row else ""
        count = keys.whole(row, "count", path, problems, default=1)
        fitting = [
            item
            for item in bank.items.values()
            if set(topics) <= set(item.common.topics)
            and level in ("", item.common.level)
            and item.id not in taken
        ]
        if len(fitting) < count:
            message = f"only {len(fitting)} items of the bank fit, {count} are wanted"
            problems.append(Problem(path, "too-few-items", message, "ask for fewer"))
        taken |= {item.id: item for item in fitting[:count]}
    return tuple(item for item in bank.items.values() if item.id in taken)
