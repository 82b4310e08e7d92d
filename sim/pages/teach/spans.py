"""Where each value of a block stands in the lesson's text, character by character.

A value is changed by putting other characters in its place, so that a teacher's comments, order and
layout stay as they are; no YAML is ever written anew.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import yaml

from sim.pages.teach.pieces import Lines
from sim.pages.text.fence_scan import Block
from sim.pages.text.yaml.loader import RefusedError, composed
from sim.pages.text.yaml.source import KeyPath, Place


@dataclass(frozen=True, slots=True)
class Value:
    """A single value (no table, no list): characters `start` to `end` of the text.

    `style` is YAML's: "" plain, ' or " quoted, | or > a text of several lines. `indent`: the
    columns in front of the lines of such a text. `place`: line and column, counted as findings do.
    """

    path: KeyPath
    start: int
    end: int
    style: str
    indent: int
    value: str
    place: Place


def values(text: str, block: Block) -> tuple[Value, ...]:
    """The values of a block that can be read, in their order; of any other, none."""
    root = _root(block)
    return tuple(_below(root, (), _Places(Lines.of(text), block))) if root else ()


def names(text: str, block: Block) -> tuple[Value, ...]:
    """The same for its keys: each with its own path, and its name as the value."""
    root = _root(block)
    return tuple(_keys_below(root, (), _Places(Lines.of(text), block))) if root else ()


def _root(block: Block) -> yaml.Node | None:
    try:
        return composed(block.body)
    except (yaml.YAMLError, RefusedError, RecursionError):
        return None


@dataclass(frozen=True, slots=True)
class _Places:
    """From a mark in a block's body to a place in the lesson."""

    lines: Lines
    block: Block

    def __call__(self, mark: yaml.Mark) -> int:
        line = self.block.start + 1 + mark.line
        return self.lines.offset(line, mark.column + self.block.body_indent)

    def end(self, node: yaml.ScalarNode) -> int:
        """A text of several lines ends before the line end that follows it."""
        if node.style not in ("|", ">"):
            return self(node.end_mark)
        # The mark stands at the beginning of the next line that is not empty: go back over those.
        last = self.block.start + 1 + node.end_mark.line - (node.end_mark.column == 0)
        last = min(last, self.block.end - 1 - self.block.closed)
        while last > self.block.start + 1 + node.start_mark.line:
            if self.lines.lines[last].strip():
                break
            last -= 1
        return self.lines.starts[last] + len(self.lines.lines[last])


def _below(node: yaml.Node, path: KeyPath, places: _Places) -> Iterator[Value]:
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            if isinstance(key, yaml.ScalarNode):
                yield from _below(value, (*path, str(key.value)), places)
    elif isinstance(node, yaml.SequenceNode):
        for k, item in enumerate(node.value):
            yield from _below(item, (*path, k), places)
    elif isinstance(node, yaml.ScalarNode):
        yield _single(node, path, places)


def _keys_below(node: yaml.Node, path: KeyPath, places: _Places) -> Iterator[Value]:
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            if isinstance(key, yaml.ScalarNode):
                here = (*path, str(key.value))
                yield _single(key, here, places)
                yield from _keys_below(value, here, places)
    elif isinstance(node, yaml.SequenceNode):
        for k, item in enumerate(node.value):
            yield from _keys_below(item, (*path, k), places)


def _single(node: yaml.ScalarNode, path: KeyPath, places: _Places) -> Value:
    start, end = places(node.start_mark), places.end(node)
    mark = node.start_mark
    place = places.block.start + 2 + mark.line, places.block.body_indent + 1 + mark.column
    style = node.style or ""
    return Value(path, start, end, style, _indent(node, places), str(node.value), place)


def _indent(node: yaml.ScalarNode, places: _Places) -> int:
    """Columns in front of the first line of a text of several lines."""
    if node.style not in ("|", ">"):
        return 0
    first = places.block.start + 2 + node.start_mark.line
    lines = places.lines.lines
    while first < places.block.end - 1 and not lines[first].strip():
        first += 1
    line = lines[first] if first < len(lines) else ""
    return len(line) - len(line.lstrip(" "))
