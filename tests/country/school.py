"""A school with everything that can happen to a file, drawn from a seed."""

from __future__ import annotations

import random
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sim.classroom.files.reading import Source
from sim.lesson.bank import Bank, read_bank
from tests.classroom.given.makers import BELIEFS, answers, keys, sources

SURE = ("sure", "unsure", "guessed")


def bank() -> Bank:
    """Every kind that is counted in a way of its own, and one nobody marks."""
    right: dict[str, Any] = {"text": "right", "correct": True}
    items: list[dict[str, Any]] = [
        {"id": f"one-{k}", "type": "single", "ask": f"Which, {k}?", "marks": 1 + k % 2,
         "sure": True, "topics": ["third-law" if k < 4 else "second-law"],
         "options": [right, *({"text": f"wrong {n}", "belief": BELIEFS[n]} for n in range(3))]}
        for k in range(7)
    ]  # fmt: skip
    items += [
        {"id": "both", "type": "multiple", "ask": "Which two?", "marks": 2,
         "options": [right, {"text": "right too", "correct": True}, "wrong", "wrong too"]},
        {"id": "speed", "type": "number", "ask": "How fast?", "answer": "-0.25 m/s",
         "tolerance": "0.01 m/s", "sure": True,
         "wrong": [{"value": "0.25 m/s"}, {"value": "-0.5 m/s", "belief": BELIEFS[0]}]},
        {"id": "word", "type": "short", "ask": "How large?", "accept": ["zero", "nothing"]},
        {"id": "idea", "type": "idea", "ask": "What do you think?", "options": ["a", "b"]},
        {"id": "why", "type": "long", "ask": "Why?",
         "rubric": {"0": "no", "1": "half", "2": "yes"}},
    ]  # fmt: skip
    return read_bank({"title": "Made up", "items": items})


BANK = bank()


def values(dice: random.Random, able: float) -> dict[str, Any]:
    """Answers of one student; some are left out."""
    found: dict[str, Any] = {}
    for name, question in BANK.items.items():
        if dice.random() < 0.08:
            continue
        kind, key, well = question.KIND, question.key(), dice.random() < able
        if kind == "single":
            found[name] = dice.choice(key["correct"] if well else question.asked()["options"])
        elif kind == "multiple":
            some = dice.sample(question.asked()["options"], dice.randint(0, 3))
            found[name] = key["correct"] if well else sorted(some)
        elif kind == "number":
            found[name] = -0.25 if well else dice.choice([0.25, -0.5, 7, "=1+1", "fast"])
        elif kind == "short":
            found[name] = "zero" if well else dice.choice(["=HYPERLINK(1)", "much", " "])
        elif kind == "idea":
            found[name] = dice.choice(question.asked()["options"])
        else:
            found[name] = dice.choice(["@force", "Both forces.", ""])
    return found


def prediction(dice: random.Random) -> dict[str, Any]:
    """What a scene asked first: it has no key."""
    arrow = dice.choice(["longer", "equal", "shorter"])
    seen = {"again": "2026-09-01T08:00:00.000Z"} if dice.random() < 0.2 else {}
    return {"id": "scene-1", "hash": "", "type": "choice", "value": arrow, "first": None,
            "last": None, "tries": 0, "said": arrow, "why": "+because", "sure": "sure",
            **seen}  # fmt: skip


def files_of(seed: int, count: int, *, prefix: str = "FOX", gain: float = 0.2) -> list[Any]:
    """Files before and after, later and of a worksheet, with doubles, foreign and empty ones."""
    dice, files = random.Random(seed), []
    for k in range(count):
        able = dice.uniform(0.1, 0.8)
        student = "" if dice.random() < 0.05 else f"{prefix}-{k}"
        for form, day, more in (("pre", 1, 0.0), ("post", 20, gain), ("delayed", 25, gain)):
            if dice.random() < 0.1:
                continue
            file = answers(BANK, student, form, values(dice, able + more), day=day, start=k)
            for item in file["items"]:
                item["sure"] = dice.choice(SURE)
            file["items"].append(prediction(dice))
            files += _mishaps(dice, file)
    dice.shuffle(files)
    return files


def _mishaps(dice: random.Random, file: dict[str, Any]) -> list[dict[str, Any]]:
    """The file, or what became of it."""
    luck = dice.random()
    if luck < 0.04:
        return [file, {**file, "saved": "2026-09-28T00:00:00.000Z"}]  # the same answers
    if luck < 0.08:
        later = {**file, "saved": "2026-09-29T00:00:00.000Z", "items": file["items"][2:]}
        return [later, file]  # saved again, with other answers
    if luck < 0.11:
        other = {**file, "created": "2026-08-01T08:00:00.000Z", "items": file["items"][3:]}
        return [file, other]  # two students with one code word
    if luck < 0.15:
        changed = [{**item, "hash": "f" * 12} for item in file["items"][:2]]
        return [{**file, "items": [*changed, *file["items"][2:]]}]  # another wording
    return [{**file, "items": []}] if luck < 0.18 else [file]


def school_files(seed: int, count: int, folder: str = "", **more: Any) -> list[Source]:
    """The same as sources with names that are there once."""
    made = sources(files_of(seed, count, **more))
    return [Source(f"{folder}{k:04}.{one.name}", one.content) for k, one in enumerate(made)]


FORMS = ("pre", "post", "delayed")
KEY = Source("key.json", keys(BANK, FORMS).encode())


def lay(folder: Path, sources: Sequence[Source]) -> Path:
    """Write them into a new folder."""
    folder.mkdir(parents=True)
    for source in sources:
        (folder / source.name).write_bytes(source.content)
    return folder
