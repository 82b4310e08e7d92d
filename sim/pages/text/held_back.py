"""Text that waits, as a question does: `!!! after "Title"` opens when the run above was watched.

What an author writes below a prediction is read before it is locked; where the text tells what is
to be seen, it is held back by these words above it. Markdown reads the lines as one of its notes,
which may have a kind of its own: `!!! check after "Title"`. Another scene than the one above is
named: `!!! after two-carts "Title"`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from itertools import dropwhile, takewhile, zip_longest

from sim.pages.text.fence_scan import scan, with_swallowed
from sim.pages.text.plain_lines import lines_of
from sim.pages.text.sections import HEADING

MARK = "carts-waits-for-"  # with the id of a scene: a class of the note, until its HTML is made
_OPENS = re.compile(
    r"(?P<indent>\s*)!!! +(?P<kind>[\w-]+ +)?after(?: +(?P<scene>[\w-]+))?"
    r"(?: +\"(?P<title>[^\"]*)\")?[ \t]*"
)
_NOTE = re.compile(r"\s*!!! ?(?P<words>[\w-]+(?: +[\w-]+)*)(?: +\".*\")?[ \t]*")
_BOX = re.compile(
    r"(?P<indent>\s*)(?:!!!|\?\?\?\+?) ?(?P<kind>[\w-]+)(?: +[\w-]+)*(?P<title> +\"[^\"]+\")?[ \t]*"
)
_MEANT_BOX = re.compile(r"\s*(?P<marks>[!！]{2,4}) *(?P<kind>[\w-][^\"'“„«‘「]*)?(?P<title>.*)")
_QUOTES = " \"'“”„«»‘’「」"
WORD = "after"
INSIDE = 4  # spaces before what belongs to a note


@dataclass(frozen=True, slots=True)
class Held:
    """Text that waits. `line`: of these lines, from 0. `scene`: the id of what is watched first."""

    line: int
    indent: str
    kind: str
    title: str
    scene: str

    @property
    def opening(self) -> str:
        """The line as Markdown shall read it: a note of this class, without a title of its own."""
        return f'{self.indent}!!! {self.kind}after {MARK}{self.scene} "{self.title}"'


def held_back(lines: Sequence[str], asking: str, scenes: Sequence[str]) -> Iterator[Held]:
    """Text that waits among these lines between two blocks.

    `asking`: the scene with a prediction that the text above is about, up to the next heading;
    `scenes`: the ids of all above, of which the last one counts where nothing was asked. Where
    there is none, nothing is waited for.
    """
    for k, line in enumerate(lines):
        if HEADING.match(line):
            asking = ""
        elif found := _OPENS.fullmatch(line):
            above = asking or (scenes[-1] if scenes else "")
            scene = found["scene"] if found["scene"] in scenes else above
            kind, title = found["kind"] or "", found["title"] or ""
            if scene:
                yield Held(k, found["indent"], kind, title, scene)


def mark_held(
    lines: list[str], plain: Sequence[str], start: int, end: int, asking: str, scenes: Sequence[str]
) -> None:
    """Write the openings of what waits among these lines between two blocks as Markdown shall read
    them. `plain`: the lines without code; the rest as for `held_back`."""
    for held in held_back(plain[start:end], asking, scenes):
        lines[start + held.line] = held.opening


def without_scene(text: str) -> Iterator[tuple[int, str]]:
    """Where in the text, without its code, something waits for a run that no scene above it has:
    the place, and the scene that was named, if one was."""
    lines = lines_of(text, keepends=True)
    scenes = [
        (block.start, one.stated_id)
        for block in scan(lines)
        for one in with_swallowed(block)
        if one.name == "scene"
    ]
    at = 0
    for k, line in enumerate(lines):
        if found := _OPENS.fullmatch(line.rstrip("\n")):
            above = [identity for start, identity in scenes if start < k]
            named = found["scene"] or ""
            if not above or (named and named not in above):
                yield at + len(found["indent"]), named
        at += len(line)


def without_text(prose: str, text: str) -> Iterator[int]:
    """Where something waits whose text does not belong to it, or not all of a paragraph: that is
    there at once. `prose`: the text without its code, as long as that."""
    whole = lines_of(text)
    at = 0
    for k, line in enumerate(lines_of(prose, keepends=True)):
        found = _OPENS.fullmatch(line.rstrip("\n"))
        if found and any(_outside(found["indent"], whole[k + 1 :])):
            yield at + len(found["indent"])
        at += len(line)


def empty_boxes(prose: str, text: str) -> Iterator[tuple[int, str]]:
    """Where a box begins that nothing belongs to, and its kind: the text below stands too far left.
    One of a title alone, with an empty line below it, may be meant. As for `without_text`."""
    whole = lines_of(text)
    at = 0
    for k, line in enumerate(lines_of(prose, keepends=True)):
        end = line.rstrip("\n")
        if (box := _BOX.fullmatch(end)) and not _OPENS.fullmatch(end):
            meant = box["title"] and not "".join(whole[k + 1 : k + 2]).strip()
            if not meant and all(_outside(box["indent"], whole[k + 1 :])):
                yield at + len(box["indent"]), box["kind"]
        at += len(line)


def no_box(prose: str, text: str) -> Iterator[tuple[int, str]]:
    """Where a line was meant to open a box and Markdown prints it, with what is inside as code: the
    place, and the line as it should stand. As for `without_text`."""
    whole = lines_of(text)
    at = 0
    for k, line in enumerate(lines_of(prose, keepends=True)):
        end = line.rstrip("\n")
        if (box := _MEANT_BOX.fullmatch(end)) and not _NOTE.fullmatch(end):
            below = next(filter(str.strip, whole[k + 1 :]), "")
            if box["marks"] == "!!!" or _room_before(below) > _room_before(end):
                kind, title = box["kind"] or "note", box["title"]
                if not title:  # a kind is written small
                    first, _, title = kind.partition(" ")
                    kind, title = (first, title) if first.islower() else ("note", kind)
                title = title.strip(_QUOTES)
                should = f"!!! {kind.strip(' :：')}" + (f' "{title}"' if title else "")
                yield at + box.start("marks"), should
        at += len(line)


def _outside(indent: str, below: Sequence[str]) -> list[bool]:
    """Of each line of the paragraph below: does it stand too far left to belong to the note?"""
    first = takewhile(str.strip, dropwhile(lambda one: not one.strip(), below))
    inside = _room_before(indent + "!") + INSIDE
    return [_room_before(one) < inside for one in first] or [True]


def _room_before(line: str) -> int:
    """Columns before its first letter."""
    line = line.expandtabs(INSIDE)
    return len(line) - len(line.lstrip())


def misspelt(text: str) -> Iterator[tuple[int, str]]:
    """Where in the text, without its code, a note was meant to wait and does not, and the word."""
    at = 0
    for line in lines_of(text, keepends=True):
        end = line.rstrip("\n")
        if "!!!" in line and not _OPENS.fullmatch(end) and (note := _NOTE.fullmatch(end)):
            yield from ((at + line.index("!!!"), word) for word in note["words"].split()
                        if _meant(word.lower()))  # fmt: skip
        at += len(line)


def _meant(word: str) -> bool:
    """Whether this is `after`: with a letter more, less or changed, or in another order. “later”
    and “water” are words of their own."""
    changed = sum(a != b for a, b in zip_longest(word, WORD))
    return (
        changed <= 1
        or sorted(word) == sorted(WORD)
        or SequenceMatcher(None, word, WORD).ratio() > 0.85
    )


def first_told(lines: Iterable[str]) -> int | None:
    """Which of these lines below a prediction is the first that is read before the run: text that
    is neither held back nor under a heading of its own."""
    held = False
    for k, line in enumerate(lines):
        if HEADING.match(line):
            return None
        if _OPENS.fullmatch(line):
            held = True
        elif line.strip() and not (held and line.startswith((" ", "\t"))):
            return k
    return None
