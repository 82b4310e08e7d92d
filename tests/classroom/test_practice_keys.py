"""What the page knows without a key file: practice, no exam, nothing that is for the teacher."""

from __future__ import annotations

from pathlib import Path

from markdown import Markdown

from sim.classroom.files.keyed import read_key_file
from sim.lesson.beliefs import BELIEFS
from sim.pages.blocks.extension import CartsExtension, Page, set_page
from sim.pages.blocks.scene_block import Lesson
from sim.pages.classroom.practice_keys import keys_script, practice_key
from sim.pages.language import LANGUAGES
from tests.classroom.given.site_keys import brought, keys_of

BANKS = Path(__file__).parents[2] / "worksheets" / "banks"
QUESTION = """
```question
id: mine
type: single
ask: Which?
note: a secret note
options: [first, {text: "</script>", correct: true}]
```

```question
id: why
type: long
ask: Why?
rubric: {0: nothing, 1: a secret rubric}
```
"""
QUIZ = """
```quiz
id: %s-form
form: %s
mode: %s
bank: forces-and-motion.yml
use: test-15
```
"""


def made(text: str) -> str:
    page = Page(Lesson("lesson.md", (), (BANKS,)))
    set_page(page)
    try:
        Markdown(extensions=[CartsExtension()]).convert(text)
    finally:
        set_page(None)
    key = practice_key("tests", "lesson", page)
    return keys_script([key] if key else []).decode()


def test_worksheet_and_practice_are_marked_and_nothing_is_told_to_students() -> None:
    script = made(QUESTION + QUIZ % ("easy", "pre", "practice"))
    assert "secret" not in script
    assert "</script" not in script
    (text,) = brought(script)["__cartsKeys"]
    forms = read_key_file(text)
    assert [form.form for form in forms] == ["worksheet", "pre"]
    assert forms[0].items["mine"].mark("b").verdict == "right"
    assert forms[0].items["why"].worth == 1


def test_an_exam_stays_out() -> None:
    assert brought(made(QUIZ % ("hard", "pre", "exam")))["__cartsKeys"] == []


def test_a_page_without_questions_has_no_key() -> None:
    assert brought(made("Only words."))["__cartsKeys"] == []


def test_the_page_has_the_words_of_papers_in_every_language_and_no_others() -> None:
    papers = brought(made("Only words."))["__cartsPapers"]
    assert list(papers) == list(LANGUAGES)
    malay = papers["ms"]["words"]
    assert malay["Feedback slips"] == "Slip maklum balas"
    assert malay[BELIEFS["bigger-pushes-more"]].startswith("Yang lebih berat")
    assert set(malay) == set(papers["ta"]["words"]) and len(malay) < 350  # of 1,700
    assert "this summary is damaged" not in malay


def test_the_key_of_a_lesson_comes_after_those_of_its_translations(site: Path) -> None:
    """A report takes its texts from the last."""
    own = [key for key in keys_of(site) if key["lesson"] == "newtons-third-law"]
    asks = [key["forms"][0]["items"][0]["ask"] for key in own]
    assert len(asks) == len(set(asks)) == 4
    assert asks[-1].startswith("Before you try anything.")
    ids = [[item["id"] for item in key["forms"][0]["items"]] for key in own]
    assert ids == [ids[-1]] * 4
