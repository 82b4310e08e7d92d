"""A decimal comma between brackets, where YAML begins the next value or the next key with it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

import yaml

from sim.pages.text.yaml.numbers import WHOLE

_REST = re.compile(r"\d+\s*[^\W\d]|\d+ ?%")  # with a unit: [1,2] may be two numbers
Cut = tuple[yaml.Node, str, str]
"""Where the number begins, message and hint."""


def decimals_in(node: yaml.SequenceNode) -> Iterator[Cut]:
    """[0,5 N] is a list of 0 and of “5 N”: whoever wrote it means one number."""
    for one, two in pairwise(node.value) if node.flow_style else ():
        if _are_one(one, two):
            message = f"“{one.value},{two.value}”: a comma begins the next value here"
            yield one, message, f"write decimals with a point: {one.value}.{two.value}"


def decimals_of(key: yaml.Node, table: yaml.MappingNode) -> Cut | None:
    """{from: 0,5 kg, to: 2,5 kg} has the key “5 kg” twice: two decimals are meant. `key`: that
    which is there already."""
    for (name, one), (then, _) in pairwise(table.value):
        if then is key and _are_one(one, then):
            message = f"“{one.value},{then.value}”: a comma begins the next key here"
            hint = f"write a point for the decimals: {name.value}: {one.value}.{then.value}"
            return one, message, hint
    return None


def _are_one(one: yaml.Node, two: yaml.Node) -> bool:
    close = one.end_mark.index + 1 == two.start_mark.index
    return bool(close and WHOLE.fullmatch(str(one.value)) and _REST.match(str(two.value)))
