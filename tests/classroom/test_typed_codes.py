"""Hand-in codes that a teacher types from paper, beside files or without any."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from itertools import count

import pytest

from sim.bridge.protocol import answer
from sim.classroom.files.codes import MOST_LINES, read_codes
from sim.classroom.files.keyed import KeyedForm, read_key_file
from sim.classroom.files.reading import Reading, Source
from sim.classroom.report.report import Asked, class_report
from sim.classroom.show.report_page import report_html
from sim.lesson.handin import HandInError, decode, encode
from tests.classroom.given.makers import bank, form, keys

BANK = bank(10)


def test_typed_codes_stand_beside_files() -> None:
    reading = Reading.of([Source("key.json", keys(BANK, ["pre"]).encode())])
    pre = form("pre", BANK)
    code = encode([4] * 10, [1, 2, 3, 4, 1, 2, 3, 4, 0, 2], f"pre:{pre.hash}")
    text = f"BLUE-FOX {code}\n\nRED-OWL pre {code.lower().replace('-', ' ')}\nBEE {code[:-1]}Z\nx"
    read, refused = read_codes(text, reading.keys)
    assert [r.answers.student for r in read] == ["BLUE-FOX", "RED-OWL"]
    report = class_report([(r, "class") for r in read], reading.keys, refused, Asked())
    rows = report["lessons"][0]["forms"][0]["students"]
    assert [row["total"] for row in rows] == [9, 9]
    assert [row["open"] for row in rows] == [["item-8"], ["item-8"]]
    assert len(refused) == 2
    # What is lost stands with the numbers; why, behind them.
    html = report_html(report)
    assert html.index("carts-class-refused") > html.rindex("</section>")
    first = html.partition("</p><")[2]
    assert first.startswith('p class="carts-class-lost">2 files could not be read: ')


def test_two_codes_under_one_code_word_are_asked_about_and_not_counted() -> None:
    """They have no times: nobody knows which was first, or whether it is one student."""
    reading = Reading.of([Source("key.json", keys(BANK, ["pre"]).encode())])
    pre = form("pre", BANK)
    lines = [encode([4] * 10, [k] * 10, f"pre:{pre.hash}") for k in (1, 2)]
    read, _ = read_codes("\n".join(f"BLUE-FOX {code}" for code in lines), reading.keys)
    report = class_report([(r, "class") for r in read], reading.keys, [], Asked())
    assert [flag["code"] for flag in report["flags"]] == ["doubled-id"]
    assert report["files"]["counted"] == 0


def test_codes_are_of_the_group_in_whose_box_they_were_typed() -> None:
    code = encode([4] * 10, [1] * 10, f"pre:{form('pre', BANK).hash}")
    asked = {
        "kind": "class", "do": "save", "what": "csv", "groups": ["new", "old"], "records": [],
        "keys": [keys(BANK, ["pre"])], "codes": [f"FOX {code}", f"OWL {code}\nBEE {code}"],
    }  # fmt: skip
    lines = answer(asked)[0]["text"].replace('"', "").splitlines()
    rows = [line.split(",")[2:4] for line in lines[1:]]
    assert rows == [["new", "FOX"], ["old", "BEE"], ["old", "OWL"]]


def test_a_code_tells_which_form_it_is_of() -> None:
    reading = Reading.of([Source("key.json", keys(BANK).encode())])
    code = encode([4] * 10, [1] * 10, f"post:{form('post', BANK).hash}")
    assert read_codes(f"FOX {code}", reading.keys)[0][0].answers.form == "post"
    read, refused = read_codes(f"FOX pre {code}", reading.keys)
    assert not read
    assert "another form" in refused[0].reason


def test_a_form_whose_key_is_there_twice_is_one_form() -> None:
    """As of the page's own keys and a key file beside them, or of two copies of a site."""
    once = read_key_file(keys(BANK, ["pre"]))
    copied = [replace(key, site="copy") for key in once]
    code = encode([4] * 10, [1] * 10, f"pre:{form('pre', BANK).hash}")
    for line in (f"FOX {code}", f"FOX pre {code}"):
        for forms in ([*once, *once], [*copied, *once]):
            (read,), refused = read_codes(line, forms)
            assert not refused
            assert (read.answers.student, read.answers.site) == ("FOX", "tests")


def test_of_two_lessons_with_the_same_questions_one_can_be_named() -> None:
    (once,) = read_key_file(keys(BANK, ["pre"]))
    forms = [once, replace(once, lesson="carts-again")]
    code = encode([4] * 10, [1] * 10, f"pre:{form('pre', BANK).hash}")
    read, (refused,) = read_codes(f"FOX pre {code}", forms)
    assert not read
    assert refused.reason == (
        "this code fits several forms: write carts pre or carts-again pre in front of it"
    )
    for named in ("carts", "carts-again"):
        for line in (f"BLUE FOX {named} pre {code}", f"BLUE FOX {named} {code}"):
            (found,), none = read_codes(line, forms)
            assert not none
            assert (found.answers.student, found.answers.lesson) == ("BLUE FOX", named)


@pytest.mark.parametrize(
    "line", ["FOX, carts, pre, ", "FOX carts pre ", "FOX; Carts; ", "FOX, pre "]
)
def test_the_lesson_may_always_be_named_and_is_no_part_of_the_code_word(line: str) -> None:
    code = encode([4] * 10, [1] * 10, f"pre:{form('pre', BANK).hash}")
    (found,), refused = read_codes(line + code, read_key_file(keys(BANK, ["pre"])))
    assert not refused
    assert (found.answers.student, found.answers.lesson) == ("FOX", "carts")


@pytest.mark.parametrize(
    ("line", "named"),
    [
        ("FOX, newtons-third-law, pre, ", "newtons-third-law"),
        ("BLUE FOX crats-again pre ", "crats-again"),
    ],
)
def test_a_lesson_that_no_key_has_is_refused_and_no_part_of_the_code_word(
    line: str, named: str
) -> None:
    (once,) = read_key_file(keys(BANK, ["pre"]))
    code = encode([4] * 10, [1] * 10, f"pre:{form('pre', BANK).hash}")
    read, (refused,) = read_codes(line + code, [once, replace(once, lesson="carts-again")])
    assert not read
    assert (
        refused.reason == f"there is no key for a lesson “{named}”, only for carts or carts-again; "
        "a comma ends the code word"
    )


@pytest.mark.parametrize("line", ["carts pre ", "carts, pre, ", "Carts "])
def test_a_lesson_alone_is_no_student(line: str) -> None:
    code = encode([4] * 10, [1] * 10, f"pre:{form('pre', BANK).hash}")
    read, (refused,) = read_codes(line + code, read_key_file(keys(BANK, ["pre"])))
    assert not read
    assert "code word is missing" in refused.reason


def test_two_lines_of_one_student_can_be_told_apart() -> None:
    code = encode([4] * 10, [1] * 10, f"pre:{form('pre', BANK).hash}")
    read, _ = read_codes(f"FOX {code}\nFOX {code}", read_key_file(keys(BANK, ["pre"])))
    assert [one.name for one in read] == ["typed, line 1: FOX pre", "typed, line 2: FOX pre"]


def test_a_code_that_two_texts_of_a_form_have_by_chance_says_which_key_to_choose() -> None:
    first, second = (read_key_file(keys(bank(n), ["pre"]))[0] for n in (3, 4))
    code = encode([n for _, n in first.options], [1] * 3, f"pre:{first.hash}")
    read, (refused,) = read_codes(f"FOX {code}", [first, also_of(code, second)])
    assert not read
    assert "choose only the key of the text that was answered" in refused.reason


def also_of(code: str, form: KeyedForm) -> KeyedForm:
    """The form with a hash that the code is right for too."""
    for k in count():
        changed = replace(form, hash=f"{k:012x}")
        with suppress(HandInError):
            decode([n for _, n in form.options], code, f"pre:{changed.hash}")
            break
    return changed


def test_more_typed_lines_than_are_read_are_told() -> None:
    lines = ["\n"] * MOST_LINES + [f"FOX-{k} 7K2M-Q9ZD-03HX\n" for k in range(MOST_LINES + 2)]
    read, refused = read_codes("".join(lines), [])
    assert not read
    assert len(refused) == MOST_LINES + 1
    assert f"FOX-{MOST_LINES}" in refused[-1].name
    assert "more than 2,000 lines" in refused[-1].reason
