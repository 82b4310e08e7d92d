"""What a request is refused with is a sentence that can be told in any language."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

SIM = Path(__file__).parents[3] / "sim"
ROOMS = ("bridge", "dynamics", "mine", "worlds")
FOR_READERS = {"UnsolvedError": slice(0, 2), "Problem": slice(2, 3)}
"""Which arguments of these are told: message and hint; hints to authors may be a line to type."""


def plain_texts(source: str) -> Iterator[str]:
    """Arguments for readers that stand there as plain English."""
    for call in ast.walk(ast.parse(source)):
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name):
            for told in call.args[FOR_READERS.get(call.func.id, slice(0))]:
                if isinstance(told, (ast.Constant, ast.JoinedStr)) and ast.unparse(told) != "''":
                    yield ast.unparse(told)


@pytest.mark.parametrize("room", ROOMS)
def test_every_refusal_is_said_so_that_a_language_can_turn_it(room: str) -> None:
    found = [
        f"{path.relative_to(SIM)}: {text}"
        for path in sorted((SIM / room).rglob("*.py"))
        for text in plain_texts(path.read_text())
    ]
    assert found == []


def test_a_plain_text_would_be_found() -> None:
    assert list(plain_texts('UnsolvedError("too large", said("smaller"), 0.0, ())'))
    assert list(plain_texts('Problem((), "range", f"1 to {most}", "parts: 3")'))
