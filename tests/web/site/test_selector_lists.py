"""A browser that does not know `:has` (Firefox below 121) leaves out the whole list around it.

Within `:is(…)` it leaves out that one selector only.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.registry import ROOT

SHEETS = sorted(p for p in (ROOT / "sim").rglob("*.css") if "node_modules" not in p.parts)


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda sheet: str(sheet.relative_to(ROOT)))
def test_no_rule_is_lost_where_has_is_unknown(sheet: Path) -> None:
    text = re.sub(r"/\*.*?\*/", "", sheet.read_text(encoding="utf-8"), flags=re.DOTALL)
    lost = [rule for rule in re.findall(r"([^{};]+)\{", text) if is_lost(rule)]
    assert not lost


def is_lost(rule: str) -> bool:
    """Whether one selector of a list asks `:has` and another, that would hold, does not."""
    asks = [":has(" in selector for selector in in_list(forgiven(rule))]
    return any(asks) and not all(asks)


def forgiven(rule: str) -> str:
    """Without what stands in `:is(…)` and `:where(…)`."""
    while opened := re.search(r":(?:is|where)\(", rule):
        end, deep = opened.end(), 1
        while deep:
            deep += {"(": 1, ")": -1}.get(rule[end], 0)
            end += 1
        rule = rule[: opened.start()] + rule[end:]
    return rule


def in_list(rule: str) -> list[str]:
    """The selectors of a list; a comma in brackets parts none."""
    parts, deep = [""], 0
    for letter in rule:
        deep += {"(": 1, ")": -1}.get(letter, 0)
        if letter == "," and not deep:
            parts.append("")
        else:
            parts[-1] += letter
    return parts


@pytest.mark.parametrize(
    ("rule", "lost"),
    [
        ("a, b:has(c)", True),
        ("a:not(:has(b), c), d", True),
        (":is(a, b:has(c))", False),
        ("a:has(b, c)", False),
        ("a:is(b, c:has(d)), e", False),
    ],
)
def test_such_a_list_is_known(rule: str, lost: bool) -> None:
    assert is_lost(rule) is lost
