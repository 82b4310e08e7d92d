"""Classes made up for tests: key files and answer files, with the real forms of a small bank."""

from __future__ import annotations

import io
import json
import random
import zipfile
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from sim.classroom.files.reading import Source
from sim.lesson.bank import Bank, read_bank
from sim.lesson.form import Form, read_form
from sim.lesson.key_file import key_file

TIME = "2026-09-{day:02}T08:{minute:02}:{second:02}.000Z"
BELIEFS = ("bigger-pushes-more", "mover-pushes-more", "winner-overcomes")


def bank(count: int = 10, words: int = 0, topics: tuple[str, ...] = ()) -> Bank:
    """`count` choices of four answers, the right one moving, and `words` questions to read."""
    items: list[dict[str, Any]] = []
    for k in range(count):
        options: list[dict[str, Any]] = [
            {"text": f"answer {n} of {k}", "belief": BELIEFS[n % 3]} for n in range(4)
        ]
        options[k % 4] = {"text": f"right of {k}", "correct": True}
        items.append({"id": f"item-{k}", "type": "single", "ask": f"Question {k}?", "options":
                      options, "sure": True})  # fmt: skip
        if topics:
            items[-1]["topics"] = [topics[k % len(topics)]]
    for k in range(words):
        rubric = {"0": "nothing", "1": "one force", "2": "both forces"}
        items.append({"id": f"why-{k}", "type": "long", "ask": f"Why {k}?", "rubric": rubric})
    return read_bank({"title": "Made up", "items": items})


def form(name: str, source: Bank) -> Form:
    """The form of all items."""
    plain = {"id": f"test-{name}", "form": name, "mode": "exam", "bank": "b.yml",
             "items": list(source.items)}  # fmt: skip
    return read_form(plain, source)


def keys(source: Bank, forms: Iterable[str] = ("pre", "post")) -> str:
    """A key file of these forms."""
    return json.dumps(key_file("tests", "carts", [], [form(name, source) for name in forms]))


def answers(
    source: Bank,
    student: str,
    form_name: str,
    values: Mapping[str, Any],
    *,
    day: int = 1,
    start: int = 0,
    **changes: Any,
) -> dict[str, Any]:
    """An answer file; `changes` take the place of its parts."""
    rows = []
    for k, (name, value) in enumerate(values.items()):
        item = source.items[name]
        time = TIME.format(day=day, minute=start % 20 + k, second=7 * k % 60)
        rows.append({"id": name, "hash": item.hash, "type": item.KIND, "value": value,
                     "first": time, "last": time, "tries": 0, "sure": "sure"})  # fmt: skip
    return {
        "format": 1, "kind": "newtons-carts-answers", "site": "tests", "lesson": "carts",
        "lessonHash": "0123456789ab", "student": student, "form": form_name,
        "created": TIME.format(day=day, minute=start % 20, second=0),
        "saved": TIME.format(day=day, minute=59, second=0), "page": "worksheets/carts",
        "items": rows, **changes,
    }  # fmt: skip


def random_class(
    source: Bank, count: int, *, seed: int = 1, gain: float = 0.2, prefix: str = "FOX"
) -> list[dict[str, Any]]:
    """Pre and post of `count` students, in order; `gain`: how much likelier a right answer gets."""
    dice, files = random.Random(seed), []
    for k in range(count):
        able = dice.uniform(0.2, 0.7)
        for name, chance, day in (("pre", able, 1), ("post", able + gain, 20)):
            values = {
                item: _choice(dice, source, item, chance)
                for item in source.items
                if dice.random() < 0.95
            }
            files.append(answers(source, f"{prefix}-{k}", name, values, day=day, start=k))
    return files


def _choice(dice: random.Random, source: Bank, item: str, chance: float) -> str:
    question = source.items[item]
    if question.KIND == "long":
        return f"Because of the force, says {dice.random():.6f}."
    right = question.key()["correct"][0]
    others = [o for o in question.asked()["options"] if o != right]
    return right if dice.random() < chance else dice.choice(others)


def sources(files: Iterable[dict[str, Any]], folder: str = "") -> list[Source]:
    """The files as they come from a disk."""
    return [
        Source(f"{folder}{f['lesson']}.{f['form']}.{f['student']}.carts.json",
               json.dumps(f).encode())
        for f in files
    ]  # fmt: skip


def zipped(files: Iterable[Source]) -> bytes:
    """A zip of them."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in files:
            archive.writestr(file.name, file.content)
    return packed.getvalue()


def packed(fill: Callable[[zipfile.ZipFile], None], way: int = zipfile.ZIP_DEFLATED) -> bytes:
    """A zip with what `fill` writes into it."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", way) as archive:
        fill(archive)
    return buffer.getvalue()
