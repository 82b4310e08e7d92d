"""YAML with a place for every value, and a clear error for every trap.

Teachers write scenes by hand, so a mistake must be answered with a line, a column and the right
form. YAML has old rules that turn what people mean into something else (`1:30` is 90, `No` is
"false", `010` is 8, a tab is no space); all of them are refused here.

Numbers keep their exact text: only plain whole numbers become `int`, everything else that looks
like a number ("0.10", "1e9") is handed on as `str`, so that nothing is rounded before the
validator has computed with it.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import yaml

from sim.pages.text.yaml.commas import decimals_in, decimals_of
from sim.pages.text.yaml.cut import cut_off
from sim.pages.text.yaml.errors import (
    EXPLAINED,
    FOUND_TOO_LATE,
    NOT_HELD,
    YamlError,
    of_first_sign,
    of_neighbours,
    unclosed,
)
from sim.pages.text.yaml.loader import RefusedError, composed
from sim.pages.text.yaml.lost import lost
from sim.pages.text.yaml.numbers import WHOLE, misread
from sim.pages.text.yaml.typos import typos

__all__ = ["MAX_CHARACTERS", "KeyPath", "Place", "Plain", "Source", "YamlError", "load"]

MAX_CHARACTERS = 500_000  # a scene has about 500; 10 000 carts still fit, a movie does not
MAX_DIGITS = 400  # longer than any double written out in full

KeyPath = tuple[str | int, ...]
Plain = dict[str, "Plain"] | list["Plain"] | str | int | bool | None
Place = tuple[int, int]  # line and column, both counted from 1

_HINT_TRUTH = "write true or false, or put the word in quotes"


@dataclass(frozen=True, slots=True)
class Source:
    """Plain values and where they stand: `place` points at a value, `key_place` at its name."""

    plain: dict[str, Plain]
    values: dict[KeyPath, Place]
    keys: dict[KeyPath, Place]

    def place(self, path: KeyPath) -> Place:
        """Line and column of the value at `path`, or of the nearest thing above it that exists."""
        return self._nearest(self.values, path)

    def key_place(self, path: KeyPath) -> Place:
        """Line and column of the key at `path`, or of the nearest thing above it that exists."""
        return self.keys[path] if path in self.keys else self._nearest(self.values, path)

    def _nearest(self, places: dict[KeyPath, Place], path: KeyPath) -> Place:
        # A missing key has no place of its own: its parent's name is where it should be added.
        if path in places:
            return places[path]
        for length in range(len(path) - 1, 0, -1):
            parent = path[:length]
            if parent in self.keys or parent in self.values:
                return self.keys.get(parent) or self.values[parent]
        return self.values[()]


def load(text: str, *, first_line: int = 1, first_col: int = 1) -> Source:
    """Read one YAML mapping; raise `YamlError` for anything that could be misunderstood.

    `first_line` and `first_col` say where the text begins in its file, for a fence in a lesson.
    """
    reader = _Reader(first_line, first_col)
    return reader.read(text)


@dataclass(slots=True)
class _Reader:
    """One reading: `first_line` and `first_col` are those of the text in its file."""

    first_line: int
    first_col: int
    found: list[YamlError] = field(default_factory=list)  # mistakes beside which one can read on
    values: dict[KeyPath, Place] = field(default_factory=dict)
    keys: dict[KeyPath, Place] = field(default_factory=dict)

    def read(self, text: str) -> Source:
        if len(text) > MAX_CHARACTERS:
            raise self.error(
                0,
                0,
                f"this text has {len(text)} characters; at most {MAX_CHARACTERS} are read",
                "a scene is short: is this the right file?",
            )
        self.found += [self.error(*typo) for typo in typos(text)]
        self._tell()
        self.values[()] = (self.first_line, self.first_col)
        root = self._compose(text)
        self.found += [self.error(*one) for one in lost(root, text)]
        if root is None:
            return Source({}, self.values, self.keys)
        if not isinstance(root, yaml.MappingNode):
            raise self._at(root, "expected lines of “key: value”", "for example: mass: 0.5 kg")
        plain = self._mapping(root, ())
        self._tell()
        return Source(plain, self.values, self.keys)

    def _tell(self) -> None:
        """Raise what was found, the first of it with the others."""
        if self.found:
            first, *others = self.found
            raise YamlError(first.line, first.col, first.message, first.hint, others)

    def _compose(self, text: str) -> yaml.Node | None:
        try:
            return composed(text)
        except yaml.reader.ReaderError as error:
            before = text[: error.position]
            line, col = before.count("\n"), len(before) - before.rfind("\n") - 1
            raise self.error(
                line, col, "this character cannot be read", "delete it and type the text anew"
            ) from None
        except RefusedError as error:
            hint = "write the value out; if it is text, put it in quotes"
            raise self.error(error.line, error.col, error.message, hint) from None
        except yaml.MarkedYAMLError as error:
            raise self._explained(error, text) from None
        except RecursionError:
            raise self.error(0, 0, "the brackets are nested too deeply", "write it flat") from None

    def _explained(self, error: yaml.MarkedYAMLError, text: str) -> YamlError:
        mark = error.problem_mark or error.context_mark
        began = error.context_mark
        late = began and mark and began.line < mark.line
        problem = error.problem or "this cannot be read"
        if late and problem.startswith(FOUND_TOO_LATE):
            mark = began  # the line that lacks something, not the one after it
        line, col = (mark.line, mark.column) if mark else (0, 0)
        lines = text.split("\n")
        here = lines[line] if line < len(lines) else ""
        if "\t" in here[col : col + 1]:
            return self.error(line, col, "a tab character", "use spaces")
        last = error.problem_mark.line if error.problem_mark else 0
        if told := unclosed(lines, last) or cut_off(text) or of_neighbours(lines, line, problem):
            return self.error(*told)
        if found := of_first_sign(here, problem):
            col, message, hint = found
            return self.error(line, col, message, hint)
        for part, message, hint in EXPLAINED:
            if part in problem or part in (error.context or ""):
                by = f" before line {self.first_line + last}" if late and part in NOT_HELD else ""
                return self.error(line, col, f"{message}{by}", hint)
        return self.error(line, col, problem, "look at this line and the one above it")

    def _mapping(self, node: yaml.MappingNode, path: KeyPath) -> dict[str, Plain]:
        plain: dict[str, Plain] = {}
        for key_node, value_node in node.value:
            key = self._key(key_node)
            here = (*path, key)
            if key in plain:
                message = f"“{key}” is written twice (first in line {self.keys[here][0]})"
                cut = decimals_of(key_node, node) or (key_node, message, "keep one of them")
                self.found.append(self._at(*cut))
                continue
            self.keys[here] = self._place(key_node)
            plain[key] = self._value(value_node, here)
        return plain

    def _key(self, node: yaml.Node) -> str:
        if not isinstance(node, yaml.ScalarNode):
            raise self._at(node, "a name cannot be a list or a table", "write name: value")
        if node.tag.endswith(":bool"):
            raise self._at(
                node,
                f"YAML reads the name “{node.value}” as true or false",
                f'choose another name, or put it in quotes: "{node.value}"',
            )
        if node.tag.endswith(":merge"):
            raise self._at(node, "merging with << is not used here", "write the keys out")
        if node.tag.endswith(":null") and not node.value:
            raise self._at(node, "a name is missing before the colon", "write name: value")
        return str(node.value)

    def _value(self, node: yaml.Node, path: KeyPath) -> Plain:
        # A table is spoken of by its name, a single value by itself.
        named = path in self.keys and not isinstance(node, yaml.ScalarNode)
        self.values[path] = self.keys[path] if named else self._place(node)
        if isinstance(node, yaml.MappingNode):
            return self._mapping(node, path)
        if isinstance(node, yaml.SequenceNode):
            self.found += [self._at(*cut) for cut in decimals_in(node)]
            return [self._value(item, (*path, i)) for i, item in enumerate(node.value)]
        return self._scalar(node, str(node.value))

    def _scalar(self, node: yaml.Node, text: str) -> Plain:
        kind = node.tag.rpartition(":")[2]
        if kind == "null":
            return None
        if kind == "bool":
            if text.lower() not in ("true", "false"):
                message = f"YAML reads “{text}” as true or false"
                self.found.append(self._at(node, message, _HINT_TRUTH))
            return text.lower() == "true"
        if kind in ("int", "float"):
            return self._number(node, text)
        return text

    def _number(self, node: yaml.Node, text: str) -> str | int:
        if len(text) > MAX_DIGITS:
            raise self._at(node, f"a number of {len(text)} characters", "shorten it")
        if told := misread(text):
            self.found.append(self._at(node, *told))
            return text
        return int(text) if WHOLE.fullmatch(text) else text

    def _place(self, node: yaml.Node) -> Place:
        return self.first_line + node.start_mark.line, self.first_col + node.start_mark.column

    def _at(self, node: yaml.Node, message: str, hint: str) -> YamlError:
        return YamlError(*self._place(node), message, hint)

    def error(self, line: int, col: int, message: str, hint: str) -> YamlError:
        """An error at a line and column of the text, both counted from 0."""
        return YamlError(self.first_line + line, self.first_col + col, message, hint)
