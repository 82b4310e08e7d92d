"""Laws that somebody wrote: `law: mine.py` in a contact, the file's text under `laws`.

    contact: {law: mine.py}
    laws:
      mine.py: |
        def force(overlap, rate, stiffness):
            return stiffness * overlap

Whoever reads a scene from a file puts the text of a file beside it there. What is in a text is
looked at where it is run (`sim.mine`): here it is a text.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from sim.scene.laws import is_written
from sim.scene.model import Contact
from sim.scene.problem import Path, Problem
from sim.scene.said import said
from sim.scene.tables import mapping

HINT = "laws: {mine.py: ...}"
EXAMPLE = "def force(overlap, rate):"
NO_FORCE = said("there is no function called force here")


def read_written(
    value: object, contact: object, contacts: tuple[Contact | None, ...], problems: list[Problem]
) -> dict[str, str]:
    """The texts that contacts of the scene ask for; one that is missing is a problem."""
    table = mapping(value, ("laws",), problems, HINT)
    if table is None:
        return {}
    texts: dict[str, str] = {}
    for name, text in table.items():
        path: Path = ("laws", name)
        if not is_written(name):
            message = said("{name} is no name of a law in Python", name=f"“{str(name)[:40]}”")
            problems.append(Problem(path, "bad-name", message, "law: mine.py"))
        elif not isinstance(text, str):
            message = said("the law {name} is a text", name=name)
            problems.append(Problem(path, "not-text", message, EXAMPLE))
        elif not text.strip():  # an empty box of a page
            hint = said("begin with {example}", example=EXAMPLE)
            problems.append(Problem(path, "no-force", NO_FORCE, hint))
        else:
            texts[name] = text
    asked = {one.law for one in contacts if one is not None and one.written}
    for path, name in named_laws(contact):
        if name in asked and name not in table:
            message = said("there is no text of the law {name}", name=name)
            hint = said("put the file {name} beside this one", name=name)
            problems.append(Problem(path, "no-such-law", message, hint))
    return {name: text for name, text in texts.items() if name in asked}


def named_laws(contact: object) -> Iterator[tuple[Path, str]]:
    """Where a scene's contact names a law in a file, and which."""
    if not isinstance(contact, Mapping):
        return
    pairs = contact.get("pairs")
    rows: list[tuple[Path, Any]] = [(("contact",), contact)]
    if isinstance(pairs, Mapping):
        rows += [(("contact", "pairs", str(name)), own) for name, own in pairs.items()]
    for path, own in rows:
        name = own.get("law") if isinstance(own, Mapping) else None
        if isinstance(name, str) and is_written(name):
            yield (*path, "law"), name
