"""A key file marks as the lesson itself does: the vectors in tests/marking hold both."""

from __future__ import annotations

import json
import re

import pytest

from sim.classroom.files.keyed import KeyFileError, keyed_item, read_key_file
from sim.lesson import read_question
from sim.lesson.key_file import item_key, key_file
from sim.lesson.read import KINDS
from tests.lesson.marking_vectors import SETS


@pytest.mark.parametrize("name", SETS)
def test_an_item_of_a_key_file_marks_as_its_question(name: str) -> None:
    row = json.loads(json.dumps(item_key(read_question(SETS[name]["question"]))))
    item = keyed_item(row)
    for case in SETS[name]["cases"]:
        made = item.question.mark(case["value"], case.get("own")).as_row()
        for part in ("verdict", "marks", "of", "beliefs"):
            assert made[part] == case["mark"][part], case


def test_every_kind_comes_back_from_its_key() -> None:
    assert {keyed_item(item_key(read_question(v["question"]))).question.KIND
            for v in SETS.values()} == set(KINDS)  # fmt: skip


def test_a_key_file_is_read_form_by_form() -> None:
    items = [read_question(vectors["question"]) for vectors in SETS.values()]
    one_each = {item.id: item for item in items}
    text = json.dumps(key_file("tests", "kinds", one_each.values(), []))
    (form,) = read_key_file("\ufeff" + text)
    assert (form.site, form.lesson, form.form) == ("tests", "kinds", "worksheet")
    assert list(form.items) == list(one_each)
    assert [item.hash for item in form.items.values()] == [i.hash for i in one_each.values()]


def test_damaged_key_files_are_refused_in_words() -> None:
    text = json.dumps(key_file("tests", "kinds", [read_question(SETS["single"]["question"])], []))
    cases = [text[:at] for at in range(0, len(text), 11)]
    cases += ["[]", '{"kind": "newtons-carts-answers"}', "[" * 100_000, "NaN"]
    cases += [text.replace('"marks"', '"mark"'), text.replace('"single"', '"other"', 1)]
    cases += [text.replace('"format": 1', '"format": 2', 1)]
    cases += [re.sub('"marks": [0-9]', f'"marks": {much}', text) for much in ("Infinity", "1e400")]
    assert len(set(cases)) == len(cases)  # each replaced something
    for case in cases:
        with pytest.raises(KeyFileError, match="file"):
            read_key_file(case)
