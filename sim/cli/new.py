"""`carts new`: a lesson to begin with, which already builds."""

from __future__ import annotations

import re
from pathlib import Path

import click

LESSON = """\
---
title: {title}
order: {order}
---

# {title}

Say in two or three sentences what the problem is. Nobody needs to know the answer yet.

## 1 · Predict, then look {{: data-minutes=10 }}

```scene
id: {id}-first
title: A meets B
carts:
  A: {{mass: 0.5 kg, position: 0.40 m, velocity: 0.60 m/s}}
  B: {{mass: 1.0 kg, position: 1.20 m}}
track: {{length: 2.4 m}}
contact: {{restitution: 0.8, stiffness: 200 N/m}}
until: 3 s
predict:
  ask: Which cart is faster afterwards?
  choice:
    - A
    - B
    - Both are equally fast.
controls:
  - {{set: A.velocity, from: 0.2 m/s, to: 1 m/s, step: 0.1 m/s}}
  - {{set: B.mass, from: 0.5 kg, to: 4 kg, step: 0.5 kg}}
```

```question
id: {id}-why
type: long
ask: What did you see, and why is it so? Name each force with its two objects.
rubric:
  2: What was seen, and a reason with forces that name two objects.
  1: One of the two.
  0: Neither.
minutes: 3
```

## Before you go {{: data-minutes=2 }}

```question
id: {id}-sure
type: confidence
ask: How sure are you of your answer?
```
"""


@click.command("new")
@click.argument("name")
@click.option("--title", help="The title of the lesson (default: made from NAME).")
def command(name: str, title: str | None) -> None:
    """Write a lesson to begin with into worksheets/NAME.md: a prediction, a scene, questions.

    \b
    carts new braking
    carts new two-trains --title "Two trains meet"
    """
    if not re.fullmatch(r"[a-z][a-z0-9-]{1,40}", name):
        raise click.UsageError("NAME has small letters, digits and hyphens: carts new two-trains")
    folder = Path.cwd() / "worksheets"
    if not folder.is_dir():
        raise click.UsageError("There is no folder worksheets here. Go to the folder of your site.")
    path = folder / f"{name}.md"
    if path.exists():
        raise click.ClickException(f"worksheets/{name}.md is there already. Nothing was changed.")
    order = 1 + max((_order(lesson) for lesson in folder.glob("*.md")), default=0)
    title = title or name.replace("-", " ").capitalize()
    quoted = f'"{title}"' if re.search(r"[:#'\[\]{}&*!|>%@`]", title) else title
    text = LESSON.format(id=name, title=title, order=order)
    path.write_text(text.replace(f"title: {title}", f"title: {quoted}", 1), encoding="utf-8")
    click.echo(f"worksheets/{name}.md is written. Edit it, then: carts check, carts build")


def _order(lesson: Path) -> int:
    found = re.search(r"^order: *(\d+)", lesson.read_text(encoding="utf-8"), re.MULTILINE)
    return int(found[1]) if found else 0
