"""Keys of what students can practise with: the page "Class results" brings them along.

They stand in the lessons anyway. What is for the teacher alone (rubrics, notes) and every exam
stays out: a site goes to students as it is.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any

from sim.lesson.key_file import key_file
from sim.pages.question.on_page import PageItems

FILE = "class-keys.js"
FOR_TEACHERS = ("rubric", "note")


def practice_key(site_id: str, lesson: str, items: PageItems) -> dict[str, Any] | None:
    """The key of a page without its exams, or None if it has nothing to mark."""
    questions = [block.question for block in items.questions]
    forms = [quiz.form for quiz in items.quizzes if quiz.form.mode == "practice"]
    if not questions and not forms:
        return None
    key = key_file(site_id, lesson, questions, forms)
    key["forms"] = [
        {**form, "items": [_without(item) for item in form["items"]]} for form in key["forms"]
    ]
    return key


def _without(item: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in item.items() if name not in FOR_TEACHERS}


def keys_script(keys: Iterable[Mapping[str, Any]]) -> bytes:
    """The script that hands the keys to the page, each as the text of a key file."""
    texts = [json.dumps(key, ensure_ascii=False, separators=(",", ":")) for key in keys]
    listed = json.dumps(texts, ensure_ascii=False).replace("<", "\\u003c")
    return f"self.__cartsKeys = {listed};\n".encode()
