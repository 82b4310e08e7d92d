"""The words of the interface as a test can see them, and the sentences that runs send."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sim.bridge.protocol import answer
from sim.pages.language.extract import sentences
from sim.scene.said import Said
from tests import registry

# Each sentence told in a language that a test can see: [its English text].
BRACKETS = {sentence: f"[{sentence}]" for sentence in sentences()}
SCRIPTS = {"zh-Hans": r"[\u4e00-\u9fff]", "ta": r"[\u0b80-\u0bff]", "ms": r"[a-z]"}


def rebuilt(sent: Any) -> str:
    """What came over the wire as the inner layers had it."""
    if isinstance(sent, str):
        return sent
    values = {name: rebuilt(value) for name, value in sent["values"].items()}
    return Said(sent["code"], values, sent.get("one", ""))


def sent_of_runs() -> Iterator[Any]:
    for name in registry.NAMES:
        header, _ = answer({"id": 1, "kind": "run", "scene": registry.plain(name), "samples": 1})
        yield from (phase["why"] for phase in header["plan"])
        yield from (warning["message"] for warning in header["warnings"])
