"""The worked examples for developers do what their pages say."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from jinja2 import DictLoader

from sim.classroom.files.keyed import keyed_item
from sim.lesson import read as lesson_read
from sim.lesson.key_file import item_key
from sim.lesson.question import Common
from sim.pages.language import speaking
from sim.pages.question import render
from sim.pages.runtime.node import node_program
from sim.pages.templates import templates

ROOT = Path(__file__).parents[1]
DEVELOPERS = ROOT / "docs" / "developers"


def code(page: str, language: str) -> list[str]:
    text = (DEVELOPERS / page).read_text(encoding="utf-8")
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.M | re.S)


def module(name: str, text: str) -> Any:
    made = ModuleType(name)
    sys.modules[name] = made
    exec(compile(text, name, "exec"), vars(made))
    return made


def with_rule(ours: str, rule: str) -> str:
    """The rules of the page and the guide's; where the guide was followed it is there already."""
    assert "const RULES = {" in ours
    if "export function claim(" in ours:
        return ours
    return ours.replace("const RULES = {", "const RULES = {\n  claim,") + rule


def test_the_form_of_the_added_question_type_speaks_the_language_of_its_page(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The guide showed no form: one written beside the others was English in a Malay lesson."""
    (text,) = code("add-a-question-type.md", "python")
    monkeypatch.setitem(sys.modules, "kind_claim", ModuleType("kind_claim"))
    question = module("kind_claim", text).Claim(common=Common(id="c", ask="?"), holds=False)
    environment = templates("sim.pages.question")
    assert environment.loader
    ours = environment.loader.get_source(environment, "question.html.j2")[0]
    (branch,) = code("add-a-question-type.md", "jinja")
    before = '{% elif kind == "multiple" %}'
    if 'kind == "claim"' not in ours:  # it is, where the guide was followed
        ours = ours.replace(before, branch + before, 1)
    made = environment.overlay(loader=DictLoader({"question.html.j2": ours}))
    monkeypatch.setattr(render, "templates", lambda _: made)
    with speaking({"true": "benar", "false": "salah"}):
        page = render.render_question(question, number=1, key=True)
    assert re.findall(r'value="(\w+)"> <span class="carts-q-text">(\w+)', page) == [
        ("true", "benar"),
        ("false", "salah"),
    ]


def test_the_added_question_type_marks_alike_in_both_languages(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (text,) = code("add-a-question-type.md", "python")
    monkeypatch.setitem(sys.modules, "kind_claim", ModuleType("kind_claim"))
    claim = module("kind_claim", text).Claim
    monkeypatch.setitem(lesson_read.KINDS, "claim", claim)
    (vectors,) = map(json.loads, code("add-a-question-type.md", "json"))
    question = lesson_read.read_question(vectors["question"])
    keyed = keyed_item(json.loads(json.dumps(item_key(question)))).question  # as class results do
    assert keyed.key() == question.key()
    (rule,) = code("add-a-question-type.md", "js")
    facts = question.data(key=True)
    for case in vectors["cases"]:
        assert question.mark(case["value"]).as_row() == case["mark"]
        if case["value"]:  # mark.js answers for empty ones before it asks a rule
            given = f"{json.dumps(facts)}, {json.dumps(case['value'])}"
            call = f"console.log(JSON.stringify(claim({given})))"
            file = tmp_path / "rule.mjs"
            file.write_text(f"{rule}\n{call}\n", encoding="utf-8")
            done = subprocess.run(
                [str(node_program()), str(file)], capture_output=True, text=True, check=True
            )
            assert json.loads(done.stdout) == case["mark"]


def test_the_rule_of_the_added_question_type_passes_the_type_checker_among_ours(
    tmp_path: Path,
) -> None:
    """Copied as it stood, it had five errors of types: `make lint` refused it."""
    for folder in ("sim/web/src", "sim/view"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    file = tmp_path / "sim/web/src/question/marking/mark.js"
    (rule,) = code("add-a-question-type.md", "js")
    ours = file.read_text(encoding="utf-8")
    followed = with_rule(ours, rule)
    assert with_rule(followed, rule) == followed
    file.write_text(followed, "utf-8")
    settings = {"extends": str(ROOT / "sim/web/tsconfig.json"), "include": [str(file)]}
    (tmp_path / "tsconfig.json").write_text(json.dumps(settings), encoding="utf-8")
    checker = ROOT / "node_modules/typescript/bin/tsc"
    done = subprocess.run(
        [str(node_program()), str(checker), "-p", str(tmp_path)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout
