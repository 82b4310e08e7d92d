"""What is wrong with a description: where, what, and how it should look."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from sim.scene.said import said

Path = tuple[str | int, ...]
_KEY_END = re.compile(r":|\s*=")


@dataclass(frozen=True, slots=True)
class Problem:
    """One mistake of an author.

    `path` leads to the value: ``("carts", "A", "mass")``; numbers index lists. `code` is a stable
    word for programs, `message` says what is wrong, `hint` how it should look.
    """

    path: Path
    code: str
    message: str
    hint: str = ""

    @property
    def where(self) -> str:
        """The path as an author would write it: ``carts.A.mass``."""
        return ".".join(str(part) for part in self.path) or "scene"

    def __str__(self) -> str:
        hint = f"\n  hint: {self.hint}" if self.hint else ""
        return f"{self.where}: {self.message}{hint}"


class DescriptionError(ValueError):
    """A description that cannot be used. Carries every problem found, never none."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = first_causes(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))


class SceneError(DescriptionError):
    """Of a scene, or of a block of a page that is read as one."""


def first_causes(problems: Iterable[Problem]) -> tuple[Problem, ...]:
    """The problems without those that follow from another: a misspelt key is not missing too, nor
    is one with no space behind its colon, and an answer that is said to be right in another place,
    or in a way that cannot be read, is none that is missing."""
    found = tuple(problems)
    hints = {(p.path[:-1], p.hint) for p in found if p.code == "unknown-key"}
    glued = {(p.path[:-1], _KEY_END.split(str(p.path[-1]), maxsplit=1)[0]) for p in found if p.path}
    marks = {p.path[:-2] for p in found
             if p.path[-1:] == ("correct",) or p.hint == meant("correct")}  # fmt: skip

    def follows(p: Problem) -> bool:
        inside = p.path[:-1]
        if p.code != "unknown-key" and any(h == p.hint and at[: len(inside)] == inside
                                           for at, h in hints):  # fmt: skip
            return True
        if p.code == "no-correct-option":
            return p.path in marks
        name, _, _ = p.message.partition(" is missing")
        return p.code == "missing" and ((p.path, meant(name)) in hints or (p.path, name) in glued)

    return tuple(p for p in found if not follows(p))


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known word that `word` was most likely meant to be, or None."""
    from difflib import get_close_matches  # only for a mistake: keeps the import of sim.scene light

    listed = list(known)
    found = get_close_matches(str(word), listed, n=1, cutoff=0.6)
    if found:
        return found[0]
    small = {one.casefold(): one for one in listed}  # X for x is no spelling of its own
    found = get_close_matches(str(word).casefold(), small, n=1, cutoff=0.6)
    return small[found[0]] if found else None


def did_you_mean(word: object, known: Iterable[str], otherwise: str) -> str:
    """A hint: the nearest known word, or what stands there `otherwise`."""
    close = nearest(str(word), known)
    return meant(close) if close else otherwise


def meant(word: str) -> str:
    """The hint that names one known word, in the language of who reads it."""
    return said("did you mean {name}?", name=f"“{word}”")
