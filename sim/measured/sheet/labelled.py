"""What a microcontroller prints for its plotter, a name before each number in every line.

    t:0.10,x1:0.30,x2:1.20          Distance 1: 30.1 cm  Distance 2: 119.8 cm
    10:33:21.125 -> 30.1,119.8      the monitor's own clock before what came
    {"t": 0.10, "x1": 0.30}         an object of JSON in each line

The names become one line of heads. What stands above them (“Ready”, a first line that was cut) is
left out, and so is a last line that was cut; a line of words among them stays, and is refused as a
reading with its line.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import takewhile

_ONE = re.compile(
    r"[\s,;|]*\"?(?P<name>[^\W\d][^:=,;|\t\"]{0,30}?)\"?\s*[:=]\s*"
    r"(?P<number>[-+]?[.\d](?:[.,\d]*[.\d])?(?:[eE][-+]?\d+)?|-?nan|ovf|)"
    r"(?:\s*(?P<unit>[µa-zA-Z]{1,4}(?:/s)?)(?![\w:=(]|\s*[:=\d(]))?(?=[\s,;|]|$)",
    re.I,
)
_TIME = r"\s*(\d+:\d\d:\d\d[.,]\d+)"
_CLOCK = re.compile(_TIME + r" -> *(?=[^,;\t]*([,;\t])|)")
_BEHIND_CLOCK = re.compile(_TIME + r"[,;\t ]")

Lines = Sequence[tuple[int, str]]


def without_labels(lines: Lines) -> list[tuple[int, str]]:
    """Numbered lines as a table with one row of heads, where most of them name their numbers."""
    lines = [(k, _CLOCK.sub(lambda m: m[1] + (m[2] or " "), line)) for k, line in lines]
    found = {k: _parts(line) for k, line in lines}
    heads = max(map(tuple, found.values()), key=len, default=())
    if len(heads) < 2 or 2 * sum(tuple(parts) == heads for parts in found.values()) < len(lines):
        return lines
    if tuple(found[lines[-1][0]]) != heads:  # the last line was cut
        lines.pop()
    above = sum(1 for _ in takewhile(lambda one: tuple(found[one[0]]) != heads, lines))
    rows = [
        (k, "\t".join(found[k].get(name, "") for name in heads) if found[k] else line)
        for k, line in lines[above:]
    ]
    return [(rows[0][0], "\t".join(heads)), *rows]


def _parts(line: str) -> dict[str, str]:
    """The number behind each name; none, where anything else stands in the line."""
    parts, at = {}, 0
    line = line.strip().removeprefix("{").removesuffix(",").removesuffix("}")
    if clock := _BEHIND_CLOCK.match(line):
        parts["time"], at = clock[1], clock.end()
    while match := _ONE.match(line, at):
        unit = f" ({match['unit']})" if match["unit"] else ""
        parts[match["name"] + unit], at = match["number"], match.end()
    return {} if line[at:].strip(" \t,;|") else parts
