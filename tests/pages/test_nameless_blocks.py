"""A block of ours whose fence has no name of ours is a mistake: it would be printed as code, with
what is right in it."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson, check_paths
from sim.pages.teach.preview import Desk, Site

QUESTION = """\
id: why
type: single
ask: Which is faster?
options:
  - {text: they are equal, correct: true}
  - {text: A, why: "No."}
"""
SCENE = "id: one\ncarts: {A: {mass: 1 kg, position: 0}}\n"


@pytest.mark.parametrize("name", ["", " ", "frage", "Quest", "{.frage}"])
@pytest.mark.parametrize(("body", "kind"), [(QUESTION, "question"), (SCENE, "scene")])
@pytest.mark.parametrize("before", ["", "    "])
def test_a_block_without_its_name_is_a_mistake(
    tmp_path: Path, before: str, body: str, kind: str, name: str
) -> None:
    block = f"```{name}\n{body}```\n".replace("\n", f"\n{before}").rstrip(" ")
    text = f"# A\n\n- Look:\n\n{before}{block}"
    (tmp_path / "a.md").write_text(text, encoding="utf-8")
    (found,) = check_paths([tmp_path], tmp_path)
    assert str(found).startswith(f"a.md:5:{len(before) + 1}: error: this block would be printed")
    assert found.hint == f"write ```{kind}"
    (previewed,) = Desk().look(text, Lesson("a.md"), Site()).findings
    assert (previewed.line, previewed.hint) == (found.line, found.hint)


@pytest.mark.parametrize(
    "text",
    [
        f"```yaml\n{QUESTION}```\n",
        f"````markdown\n```question\n{QUESTION}```\n````\n",
        f"````\n```question\n{QUESTION}```\n````\n",
        "```\nid: 7\nname: A\n```\n",
        "```\ncarts check\n```\n",
        f"```python\n{SCENE}```\n",
    ],
)
def test_what_is_to_be_printed_is_no_block(text: str) -> None:
    assert check_lesson(text, Lesson("a.md"), SiteIds()) == []


@pytest.mark.parametrize("name", ["{.yaml}", "{ .yaml .x }", "YAML", "js", "mermaid"])
def test_code_of_another_language_is_printed_as_it_stands(tmp_path: Path, name: str) -> None:
    (tmp_path / "a.md").write_text(f"# A\n\n```{name}\n{QUESTION}```\n", encoding="utf-8")
    assert check_paths([tmp_path], tmp_path) == []
