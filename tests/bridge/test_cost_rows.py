"""Rows of what accuracy costs, as a page asks for them one by one."""

from __future__ import annotations

import pytest

from sim.bridge.protocol import answer
from sim.dynamics.cost import measure
from sim.scene.said import from_wire
from tests import registry


def test_a_method_that_cannot_follow_a_scene_leaves_the_other_rows_to_be_asked_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A step of 3 s / 19 carries Yoshida's magnets through each other."""
    monkeypatch.setattr(measure, "LADDER", (("yoshida", (19, 61)),))
    monkeypatch.setattr(measure, "BATCH", 1e-4)
    request = {"id": 1, "kind": "cost", "scene": registry.plain("magnets-repel")}
    refused, _ = answer(request | {"row": 1})
    assert refused["ok"]
    assert refused["rows"] == []
    assert refused["not_run"]["method"] == "yoshida"
    assert from_wire(refused["not_run"]["reason"]).endswith(
        "through each other, where magnets have no force"
    )
    follows, _ = answer(request | {"row": 2})
    assert follows["of"] == refused["of"]
    assert [row["method"] for row in follows["rows"]] == ["yoshida"]
    assert "not_run" not in follows
