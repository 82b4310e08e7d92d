"""What the page "Class results" brings along: keys of what students can practise with, and words.

The keys stand in the lessons anyway. What is for the teacher alone (rubrics, notes) and every exam
stays out: a site goes to students as it is.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

from sim.lesson.key_file import key_file
from sim.pages.blocks.makers import Page
from sim.pages.language import LANGUAGES, words_of

FILE = "class-keys.js"
FOR_TEACHERS = ("rubric", "note")
OF_PAPERS = (
    *(f"sim/classroom/{folder}/" for folder in ("files", "handouts", "report", "show")),
    *("sim/classroom/refusal.py", "sim/lesson/"),
)
"""Where the sentences of slips and sheets stand, and the beliefs in them. They are made from answer
files: what is said of tables and summaries is in none."""
_STRING = re.compile(r'"(?:[^"\\]|\\.)*"')  # of JSON


def practice_key(site_id: str, lesson: str, page: Page) -> dict[str, Any] | None:
    """The key of a page without its exams, or None if it has nothing to mark."""
    items = page.items
    questions = [block.question for block in items.questions]
    forms = [quiz.form for quiz in items.quizzes if quiz.form.mode == "practice"]
    if not questions and not forms:
        return None
    key = key_file(site_id, lesson, questions, forms, title=page.title, optional=items.optional)
    key["forms"] = [
        {**form, "items": [_without(item) for item in form["items"]]} for form in key["forms"]
    ]
    return key


def _without(item: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in item.items() if name not in FOR_TEACHERS}


def keys_script(keys: Iterable[Mapping[str, Any]]) -> bytes:
    """The script that hands the keys to the page, each as the text of a key file, and the words.

    A translation's key is its lesson's but for the texts. So it is given as the place of that one
    and what its strings are instead, 0 where they are the same: a fifth less to load in four
    languages. `sim/web/src/class/brought-along.js` puts it together again.
    """
    own = list(keys)
    texts = [json.dumps(key, ensure_ascii=False, separators=(",", ":")) for key in own]
    original = {key["lesson"]: place for place, key in enumerate(own)}  # the last, as in reports
    given = [
        text if (like := original[key["lesson"]]) == place else _but_for_texts(text, like, texts)
        for place, (key, text) in enumerate(zip(own, texts, strict=True))
    ]
    papers = {
        language: {"name": name, "words": words_of(language, OF_PAPERS)}
        for language, name in LANGUAGES.items()
    }
    return _given("__cartsKeys", given) + _given("__cartsPapers", papers)


def _but_for_texts(text: str, like: int, texts: list[str]) -> str | list[int | str]:
    """`text` as what its strings are in the key at `like`; as it is if more than that differs."""
    if _STRING.sub("", text) != _STRING.sub("", texts[like]):
        return text
    pairs = zip(_STRING.findall(text), _STRING.findall(texts[like]), strict=True)
    return [like, *(0 if ours == theirs else json.loads(ours) for ours, theirs in pairs)]


def _given(name: str, value: object) -> bytes:
    """A value as a line of a script; no text in it looks like the end of the script."""
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"))
    return f"self.{name} = {text};\n".replace("<", "\\u003c").encode()
