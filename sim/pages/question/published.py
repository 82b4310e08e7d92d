"""What is written from the models: the reference page of questions, and JSON Schemas for editors.

`python -m sim.pages.question.published` writes them anew; a test holds the committed files to it.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path

from sim.lesson import schema
from sim.lesson.bank import BANK_KEYS
from sim.lesson.beliefs import FIRST_LAW, MOMENTUM, SECOND_LAW, THIRD_LAW
from sim.lesson.form import DRAW_KEYS, FORM_KEYS
from sim.lesson.keys import Key
from sim.lesson.kinds.arrange import PAIR_KEYS
from sim.lesson.kinds.links import INVENTED_KEYS
from sim.lesson.kinds.number import WRONG_KEYS
from sim.lesson.kinds.options import OPTION_KEYS
from sim.lesson.question import COMMON_KEYS
from sim.lesson.read import KINDS
from sim.scene.schema import scene_schema

REFERENCE = "docs/reference/questions.md"
_TEXT = Path(__file__).parent / "templates" / "reference.md"


def published() -> dict[str, str]:
    """The text of every generated file, by its path in the repository."""
    schemas = {
        "bank": schema.bank_schema(),
        "form": schema.form_schema(),
        "answers": schema.answers_schema(),
        "key": schema.key_schema(),
        "scene": scene_schema(),
    }
    files = {
        f"docs/reference/schemas/{name}.schema.json": json.dumps(made, ensure_ascii=False, indent=1)
        for name, made in schemas.items()
    }
    return {name: f"{text}\n" for name, text in files.items()} | {REFERENCE: reference()}


def reference() -> str:
    """The page “Every key of a question”."""
    kinds = "\n\n".join(
        f"### `{name}`: {kind.SAYS}\n\n{_keys(kind.KEYS) or '*No keys of its own.*'}"
        for name, kind in KINDS.items()
    )
    parts = {
        "@@COMMON@@": _keys(COMMON_KEYS),
        "@@KINDS@@": kinds,
        "@@OPTION@@": _keys(OPTION_KEYS),
        "@@WRONG@@": _keys(WRONG_KEYS),
        "@@INVENTED@@": _keys(INVENTED_KEYS),
        "@@PAIR@@": _keys(PAIR_KEYS),
        "@@FORM@@": _keys(FORM_KEYS),
        "@@DRAW@@": _keys(DRAW_KEYS),
        "@@BANK@@": _keys(BANK_KEYS),
        "@@BELIEFS@@": "\n\n".join(
            f"**{title}**\n\n{_beliefs(tags)}"
            for title, tags in (
                ("First law", FIRST_LAW), ("Third law", THIRD_LAW), ("Second law", SECOND_LAW),
                ("Momentum and energy", MOMENTUM),
            )
        ),
    }  # fmt: skip
    text = _TEXT.read_text(encoding="utf-8")
    for place, made in parts.items():
        text = text.replace(place, made)
    return text


def _keys(keys: Iterable[Key]) -> str:
    rows = [
        f"| `{key.name}` | {'required' if key.required else ''} | {key.says} | `{key.example}` |"
        for key in keys
    ]
    return "\n".join(["| key | | meaning | example |", "|---|---|---|---|", *rows]) if rows else ""


def _beliefs(tags: Mapping[str, str]) -> str:
    rows = [f"| `{tag}` | {says} |" for tag, says in tags.items()]
    return "\n".join(["| tag | what students who choose it often think |", "|---|---|", *rows])


if __name__ == "__main__":
    for name, text in published().items():
        path = Path(name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        print(name)
