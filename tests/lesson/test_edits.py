"""A lesson changes while students work on it: 200 random edits, and every answer is still there.

The page's own modules run in Node; which answers must be in the file is kept here, by hand.
"""

from __future__ import annotations

import random
from typing import Any

from sim.lesson import read_question
from tests.web.scene.given.widget_site import in_node

TIME = "2026-11-21T08:{:02d}:{:02d}.000Z"
SHOP = ["the force on A", "the force on B", "neither", "both", "it depends"]


def question(dice: random.Random, name: str) -> dict[str, Any]:
    """A question as an author writes it."""
    ask = dice.choice(["Which is larger?", "Which one counts?", "What do you see?"])
    plain: dict[str, Any] = {"id": name, "type": "single", "ask": ask}
    plain["options"] = [{"text": text} for text in dice.sample(SHOP, 3)]
    plain["options"][dice.randrange(3)]["correct"] = True
    if dice.random() < 0.4:
        kind = dice.choice(["long", "confidence"])
        plain = {"id": name, "type": kind, "ask": ask}
        if kind == "long":
            plain["rubric"] = {"0": "no", "1": "yes"}
    return plain


def edit(dice: random.Random, lesson: list[dict[str, Any]]) -> None:
    """Remove, add, move, retype, reword a question, or change or move its options."""
    what = dice.choice(["remove", "add", "move", "new", "reword", "options", "bring back"])
    if what in ("add", "bring back") or len(lesson) < 2:
        names = {plain["id"] for plain in lesson}
        free = [f"q-{k}" for k in range(99) if f"q-{k}" not in names]
        lesson.insert(dice.randrange(len(lesson) + 1), question(dice, dice.choice(free)))
        return
    at = dice.randrange(len(lesson))
    if what == "remove":
        lesson.pop(at)
    elif what == "move":
        lesson.insert(dice.randrange(len(lesson)), lesson.pop(at))
    elif what == "new":
        lesson[at] = question(dice, lesson[at]["id"])
    elif what == "reword":
        lesson[at] = {**lesson[at], "ask": lesson[at]["ask"] + " Really?"}
    elif "options" in lesson[at]:
        options = [dict(option) for option in lesson[at]["options"]]
        dice.shuffle(options)
        lesson[at] = {**lesson[at], "options": options}


def test_no_answer_is_lost_over_200_edits_of_a_lesson() -> None:
    dice = random.Random(11)
    lesson = [question(dice, f"q-{k}") for k in range(6)]
    answers: list[dict[str, Any]] = []
    last: dict[tuple[str, str], str] = {}
    for step in range(200):
        edit(dice, lesson)
        for plain in dice.sample(lesson, min(2, len(lesson))):
            read = read_question(plain)
            value = f"answer {step} to {read.hash}"
            time = TIME.format(step // 60, step % 60)
            answers.append(
                {"id": read.id, "hash": read.hash, "type": read.KIND, "value": value,
                 "said": value, "first": time, "last": time, "tries": 0, "form": "worksheet"}
            )  # fmt: skip
            last[read.id, read.hash] = value
    exported = in_node(
        """const { keepEarlier } = await import(source + "/answers/entry.js");
        const { makeFiles, readFile } = await import(source + "/answers/file.js");
        const kept = new Map();
        for (const answer of data) {
          const key = "lesson#" + answer.id;
          kept.set(key, keepEarlier(kept.get(key), answer));
        }
        const who = { site: "tests", student: "BLUE-FOX-27" };
        const [file] = makeFiles([...kept], who, "2026-11-21T09:00:00.000Z");
        const back = readFile(JSON.stringify(file.content), "tests");
        const [again] = makeFiles(back.entries, who, "2026-11-21T09:00:00.000Z");
        give([file.content.items, again.content.items]);""",
        answers,
    )
    for items in exported:  # from the store, and once through a file
        found = {(item["id"], item["hash"]): item["value"] for item in items}
        assert found == last


def test_changes_that_mean_nothing_leave_an_answer_current() -> None:
    plain = {
        "id": "q", "type": "single", "ask": "Which is larger?",
        "options": [{"text": "A", "correct": True}, {"text": "B"}],
    }  # fmt: skip
    same = read_question(plain).hash
    for change in (
        {"ask": "Which\nis   larger?"},
        {"level": "stretch", "minutes": 3, "hints": "Look.", "explain": "So.", "marks": 2},
        {"options": [{"text": "A", "feedback": "no"}, {"text": "B", "correct": True}]},
    ):
        assert read_question({**plain, **change}).hash == same
    for change in (
        {"ask": "Which is smaller?"},
        {"type": "multiple"},
        {"options": [{"text": "B"}, {"text": "A", "correct": True}]},
        {"options": [{"text": "A", "correct": True}, {"text": "B"}, {"text": "C"}]},
    ):
        assert read_question({**plain, **change}).hash != same
    named = {
        **plain,
        "options": [{"text": "A", "id": "x", "correct": True}, {"text": "B", "id": "y"}],
    }
    turned = {
        **plain,
        "options": [{"text": "B", "id": "y"}, {"text": "A", "id": "x", "correct": True}],
    }
    assert read_question(named).hash == read_question(turned).hash


def test_two_versions_of_an_answer_come_together_without_losing_either() -> None:
    dice = random.Random(5)

    def version() -> dict[str, Any] | None:
        if dice.random() < 0.1:
            return None
        time = TIME.format(dice.randrange(60), dice.randrange(60))
        value = dice.choice(["", "a", "b", "c", ["a", "b"], None])
        entry = {"id": "q", "hash": dice.choice(["x", "y"]), "type": "t", "value": value,
                 "first": time, "last": time, "tries": 1}  # fmt: skip
        if dice.random() < 0.3:
            entry["earlier"] = [{**entry, "value": "old", "last": TIME.format(0, 0)}]
        return entry

    pairs = [[version(), version()] for _ in range(500)]
    made = in_node(
        """const { merged } = await import(source + "/answers/entry.js");
        give(data.map(([a, b]) => { const m = merged(a, b);
          return [m, merged(b, a), merged(m, b), merged(m, a)]; }));""",
        pairs,
    )

    def values(*entries: Any) -> set[str]:
        found = set()
        for entry in entries:
            for one in [*((entry or {}).get("earlier") or []), *([entry] if entry else [])]:
                if one["value"]:
                    found.add(f"{one['hash']} {one['value']}")
        return found

    for (a, b), (both, turned, again, once_more) in zip(pairs, made, strict=True):
        assert values(both) == values(turned) == values(a, b), (a, b, both)
        assert values(again) == values(once_more) == values(a, b)


def test_what_was_locked_stays_on_top_of_what_a_tab_types_that_has_not_heard_of_it() -> None:
    kept = in_node(
        """const { keepEarlier } = await import(source + "/answers/entry.js");
        give(keepEarlier(...data));""",
        [
            {"id": "q", "value": "heavy", "locked": "2026-11-21T09:00:00.000Z"},
            {"id": "q", "value": "equal", "locked": None},
        ],
    )
    assert (kept["value"], kept["locked"]) == ("heavy", "2026-11-21T09:00:00.000Z")
    assert [one["value"] for one in kept["earlier"]] == ["equal"]
