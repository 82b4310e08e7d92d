"""What a reader may write as a prediction is never too long for the file of answers."""

from __future__ import annotations

import re

from sim.pages.widget import render
from tests.web.question.node_page import on_page
from tests.web.scene.given.widget_site import WORDS, baked

SCRIPT = """
const { makeFiles, readFile } = await load("answers/file.js");
const now = "2026-09-01T08:00:00.000Z";
const entry = { id: "words", type: "text", hash: "", first: now, last: now, locked: now, tries: 1 };
const [value, why] = data.map((many) => "x".repeat(many));
const who = { site: "s", student: "" };
const [{ content }] = makeFiles([["p#words", { ...entry, value, why }]], who, now);
const { problem, entries } = readFile(JSON.stringify(content), "s");
give(problem ?? [entries[0][1].value.length, entries[0][1].why.length]);
"""


def test_a_prediction_as_long_as_its_boxes_take_comes_back_whole_from_its_file() -> None:
    boxes = re.findall(r"<textarea[^>]*>", render(*baked(WORDS)))
    longest = [int(re.findall(r'maxlength="(\d+)"', box)[0]) for box in boxes]
    assert len(longest) == 2
    assert on_page(SCRIPT, longest) == longest
    assert "damaged" in on_page(SCRIPT, [longest[0] + 1, 0])
