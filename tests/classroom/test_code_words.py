"""One code word however it is written: in a student's browser, by a teacher, in Python."""

from __future__ import annotations

import json

import pytest

from sim.classroom.files.archive import shown
from sim.classroom.files.marks_file import given_marks, pseudonym
from sim.classroom.files.reading import Reading, Source
from sim.classroom.report.marked import NO_CODE
from sim.classroom.report.report import Asked, class_report
from sim.lesson.kinds.words import MOST_MARKS
from sim.lesson.problems import LessonError
from sim.lesson.read import read_question
from tests.classroom.given.makers import answers, bank, keys
from tests.web.scene.given.widget_site import in_node

WORDS = {
    "BLUE-FOX-27": [
        "BLUE-FOX-27", "blue fox 27", "Blue–Fox–27", " blue_fox−27 ", "ｂｌｕｅ　ｆｏｘ　２７",
        "blue\u00a0fox\u202f27", "BLUE  FOX — 27\ufeff",
    ],
    "BLUE-FOX-27+RED-OWL-13": [
        "RED-OWL-13+BLUE-FOX-27", "blue fox 27 & red owl 13", "BLUE-FOX-27 + RED–OWL–13",
        "red owl 13+blue fox 27+RED-OWL-13",
    ],
    "ÄPFEL-STRASSE": ["äpfel straße", "A\u0308pfel-Strasse"],
    "\U00020000\U00020001+\ufa0e\ufa0f": ["\ufa0e\ufa0f+\U00020000\U00020001"],
    "": ["", "  \t"],
    "NO-CODE-WORD-(A-B.JSON)": ["no code word (a b.json)"],
}  # fmt: skip
TYPED = [(typed, word) for word, many in WORDS.items() for typed in many]


@pytest.mark.parametrize(("typed", "word"), TYPED)
def test_a_code_word_is_compared_by_what_it_says(typed: str, word: str) -> None:
    assert pseudonym(typed) == word
    assert pseudonym(word) == word


def test_the_class_page_and_a_students_browser_have_the_same_rules() -> None:
    compared, stored = in_node(
        """globalThis.document = { documentElement: { dataset: {}, lang: "en" },
          getElementById: () => null };
        const { codeWord } = await import(source + "/shared/code-word.js");
        const { readCode } = await import(source + "/answers/codes.js");
        give([data.map(codeWord), data.map((one) => readCode(one).code ?? null)]);""",
        [typed for typed, _ in TYPED],
    )
    assert compared == [word for _, word in TYPED]
    for (_, word), code in zip(TYPED, stored, strict=True):
        assert code == word or (code is None and word in ("", "NO-CODE-WORD-(A-B.JSON)"))


def test_a_code_word_that_a_teacher_typed_pairs_with_the_students_own() -> None:
    six = bank(6)
    chosen = {f"item-{k}": "a" for k in range(6)}
    files = [
        answers(six, "BLUE-FOX-27", "pre", chosen),
        answers(six, "blue fox 27", "post", chosen),
        answers(six, "Red Owl 13", "pre", chosen),
        answers(six, "Red–Owl–13", "post", chosen),
    ]
    sources = [Source(f"{k}.json", json.dumps(one).encode()) for k, one in enumerate(files)]
    reading = Reading.of([*sources, Source("key.json", keys(six).encode())])
    read = [(file, "7a") for file in reading.files]
    made = class_report(read, reading.keys, reading.refused, Asked(groups=("7a",)))
    assert made["lessons"][0]["gains"][0]["n"] == 2


def test_a_mark_counts_under_every_way_of_writing_the_code_word() -> None:
    row = {"lesson": "carts", "form": "pre", "item": "why-0", "marks": 1, "student": "blue fox 27"}
    assert given_marks([row]) == {("carts", "pre", "BLUE-FOX-27", "why-0"): 1}


def test_marks_of_an_answer_without_a_code_word_are_kept_however_deep_its_folders() -> None:
    """The page writes what it reads again: one row that it refuses would lose them all."""
    path = shown("/".join(["a folder with a long name"] * 40))
    student = f"{NO_CODE} ({path})"
    row = {"lesson": "carts", "form": "pre", "student": student, "item": "why-0"}
    for marks in (0, MOST_MARKS):
        assert given_marks([{**row, "marks": marks}]) == {
            ("carts", "pre", pseudonym(student), "why-0"): marks
        }


def test_a_rubric_gives_no_more_marks_than_one_key() -> None:
    question = {"id": "why", "type": "long", "ask": "Why?"}
    assert read_question({**question, "rubric": {str(k): "x" for k in range(MOST_MARKS + 1)}})
    with pytest.raises(LessonError, match="at most 9 marks"):
        read_question({**question, "rubric": {str(k): "x" for k in range(MOST_MARKS + 2)}})


def test_a_code_word_in_tamil_is_taken_whole() -> None:
    """Its vowels are signs that stand on a letter."""
    taken, name = in_node(
        """globalThis.document = { documentElement: { dataset: {}, lang: "ta" },
          getElementById: () => null };
        const { readCode } = await import(source + "/answers/codes.js");
        const { fileName } = await import(source + "/answers/file.js");
        const { code } = readCode(data);
        const content = { lesson: "third-law", form: "pre", student: code, created: "" };
        give([code, fileName(content, "json")]);""",
        "நீலம் நரி 27",
    )
    assert taken == "நீலம்-நரி-27"
    assert name == "third-law.pre.நீலம்-நரி-27.json"
    assert pseudonym("நீலம் நரி 27") == taken


NAMED = """globalThis.document = { documentElement: { dataset: {}, lang: "en" } };
const { Classroom } = await import(source + "/class/classroom.js");
const room = new Classroom();
const row = (file, student) => [file, "site", "carts", "", student, "pre"];
room.files = data.files.map((one) => ({ row: row(...one), group: 0, out: false }));
const mark = { lesson: "carts", form: "pre", student: data.marked, item: "why-0", marks: 2 };
room.give(mark);
for (const typed of data.typed) room.name(room.files[0], typed);
give([room.files[0].row[4], [...room.marks.values()].map((one) => [one.student, one.marks])]);
"""


@pytest.mark.parametrize("typed", [["blue fox"], ["blew fox", "blue fox"], ["owl", "blue fox"]])
def test_marks_go_along_with_a_file_that_is_given_a_code_word(typed: list[str]) -> None:
    """Also where the word is typed once more, to correct it."""
    files = [["a/b.json", ""], ["c.json", ""]]
    given = {"files": files, "marked": "no code word (a/b.json)", "typed": typed}
    assert in_node(NAMED, given) == ["BLUE-FOX", [["BLUE-FOX", 2]]]


def test_marks_of_somebody_else_stay_where_they_are() -> None:
    given = {"files": [["a.json", ""], ["o.json", "OWL"]], "marked": "OWL", "typed": ["owl", "fox"]}
    assert in_node(NAMED, given) == ["FOX", [["OWL", 2]]]


@pytest.mark.parametrize(
    ("typed", "good"),
    [("ABC", False), ("ABCD", True), ("小", False), ("小明", True), ("AB+CDEF", False)],
)
def test_a_code_word_has_four_letters_or_two_signs_of_a_name(typed: str, good: bool) -> None:
    script = 'give("code" in (await import(source + "/answers/codes.js")).readCode(data));'
    assert in_node(script, typed) is good
