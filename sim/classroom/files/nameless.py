"""Files without a code word are known by their names: two that are called alike are told apart.

They come from two folders, or from two groups on the page. One that was begun at the same moment is
the same file again, or was saved again, and keeps the name.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field


@dataclass(slots=True)
class Names:
    """The names that were given so far, by what a file was called and when it was begun."""

    given: dict[tuple[str, str], str] = field(default_factory=dict)
    taken: set[str] = field(default_factory=set)
    often: Counter[str] = field(default_factory=Counter)

    def of(self, name: str, begun: str) -> str:
        """The name, with a number before its ending where another file has it."""
        if (name, begun) not in self.given:
            self.often[name] += 1
            while (found := numbered(name, self.often[name])) in self.taken:
                self.often[name] += 1
            self.taken.add(found)
            self.given[name, begun] = found
        return self.given[name, begun]


def numbered(name: str, number: int) -> str:
    """`a.json` as `a (2).json`; the first has no number."""
    stem, dot, ending = name.rpartition(".")
    if number < 2:
        return name
    return f"{stem} ({number}){dot}{ending}" if stem else f"{name} ({number})"
