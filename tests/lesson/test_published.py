"""The reference page and the schemas are what the models say; schemas know good from bad."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.lesson import schema
from sim.lesson.bank import BANK_KEYS
from sim.lesson.beliefs import BELIEFS
from sim.lesson.form import DRAW_KEYS, FORM_KEYS
from sim.lesson.key_file import KIND
from sim.lesson.keys import Key
from sim.lesson.kinds.arrange import PAIR_KEYS
from sim.lesson.kinds.links import INVENTED_KEYS, MISSING_KEYS
from sim.lesson.kinds.number import WRONG_KEYS
from sim.lesson.kinds.options import OPTION_KEYS
from sim.lesson.opening import RULES
from sim.lesson.question import COMMON_KEYS
from sim.lesson.read import KINDS, read_question
from sim.pages.question.published import REFERENCE, published
from sim.pages.text.fence_scan import scan
from sim.pages.text.yaml.source import load
from tests.lesson.good_answers import GOOD
from tests.lesson.json_schema import faults
from tests.lesson.marking_vectors import SETS

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / REFERENCE).read_text(encoding="utf-8")


@pytest.mark.parametrize("name", published())
def test_the_committed_file_is_what_the_models_say(name: str) -> None:
    assert (ROOT / name).read_text(encoding="utf-8") == published()[name], (
        "run: python -m sim.pages.question.published"
    )


def test_the_reference_names_every_key_kind_and_belief() -> None:
    keys = [*COMMON_KEYS, *FORM_KEYS, *DRAW_KEYS, *BANK_KEYS]
    keys += [key for kind in KINDS.values() for key in kind.KEYS]
    for name in [*(key.name for key in keys), *KINDS, *BELIEFS, *RULES]:
        assert re.search(rf"`{name}`|\{{{name}:|, {name}:", PAGE), name


def test_the_schemas_accept_what_the_validator_accepts() -> None:
    for path in [
        *ROOT.glob("worksheets/banks/*.yml"),
        *ROOT.glob("tests/web/question/banks/*.yml"),
    ]:
        plain = load(path.read_text(encoding="utf-8")).plain
        assert list(faults(plain, schema.bank_schema())) == [], path.name
    for name, vectors in SETS.items():
        assert list(faults(vectors["question"], schema.question_schema())) == [], name
    for path in ROOT.glob("worksheets/*.md"):
        for block in scan(path.read_text(encoding="utf-8").splitlines()):
            rules = {"question": schema.question_schema(), "quiz": schema.form_schema()}
            if block.name in rules:
                found = list(faults(load(block.body).plain, rules[block.name]))
                assert found == [], (path.name, block.start, found)
    assert list(faults(GOOD, schema.answers_schema())) == []


def test_the_schemas_refuse_what_is_wrong() -> None:
    good = SETS["single"]["question"]
    for change in (
        {"type": "singel"},
        {"level": "hard"},
        {"hint": "x"},
        {"id": "A b"},
        {"options": ["a"]},
    ):
        assert list(faults({**good, **change}, schema.question_schema())), change
    assert list(faults({**GOOD, "format": 2}, schema.answers_schema()))
    assert list(faults({**GOOD, "items": [{"id": "x"}]}, schema.answers_schema()))


def test_carts_key_writes_the_key_for_the_teacher(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    result = CliRunner().invoke(
        main, ["key", "worksheets/test-forces-and-motion.md", "--out", str(tmp_path)]
    )
    assert result.exit_code == 0, result.output
    key = json.loads((tmp_path / "test-forces-and-motion.key.json").read_text(encoding="utf-8"))
    assert list(faults(key, schema.key_schema())) == []
    assert (key["kind"], key["site"]) == (KIND, "newtons-carts")
    assert [part["form"] for part in key["forms"]] == ["pre", "post", "delayed"]
    page = (tmp_path / "test-forces-and-motion.key.html").read_text(encoding="utf-8")
    assert "✓ Weight and the pull by the cord act" in page
    assert "push each other equally hard" in page  # a sample of the rubric
    assert "<script" not in page


TABLES = [COMMON_KEYS, FORM_KEYS, DRAW_KEYS, BANK_KEYS, OPTION_KEYS, WRONG_KEYS, PAIR_KEYS,
          MISSING_KEYS, INVENTED_KEYS, *(kind.KEYS for kind in KINDS.values())]  # fmt: skip


@pytest.mark.parametrize(
    "line", sorted({f"{{{key.name}: {key.example}}}" for table in TABLES for key in table})
)
def test_an_example_of_the_reference_can_be_copied_into_a_row(line: str) -> None:
    assert len(load(line).plain) == 1


@pytest.mark.parametrize("name", KINDS)
def test_a_question_made_of_the_examples_of_its_kind_is_accepted(name: str) -> None:
    lines = [f"{key.name}: {key.example}" for key in KINDS[name].KEYS]
    text = "\n".join(["id: q", f"type: {name}", "ask: Which?", *lines])
    assert isinstance(read_question(load(text).plain), KINDS[name])


@pytest.mark.parametrize("key", [key for key in COMMON_KEYS if key.name != "type"])
def test_an_example_of_a_key_of_every_question_is_accepted(key: Key) -> None:
    long = {"id": "q", "type": "long", "ask": "Which?", "rubric": {1: "both", 0: "none"}}
    given = load(f"{key.name}: {key.example}").plain
    assert read_question({**long, **given}).KIND == "long"
