"""Hand-in codes that a teacher types from paper, beside files or without any."""

from __future__ import annotations

from sim.bridge.protocol import answer
from sim.classroom.files.codes import MOST_LINES, read_codes
from sim.classroom.files.reading import Reading, Source
from sim.classroom.report.report import Asked, class_report
from sim.classroom.show.report_page import report_html
from sim.lesson.handin import encode
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
    # What is lost stands with the numbers, not further down.
    first = report_html(report).partition("</p><")[2]
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


def test_more_typed_lines_than_are_read_are_told() -> None:
    lines = ["\n"] * MOST_LINES + [f"FOX-{k} 7K2M-Q9ZD-03HX\n" for k in range(MOST_LINES + 2)]
    read, refused = read_codes("".join(lines), [])
    assert not read
    assert len(refused) == MOST_LINES + 1
    assert f"FOX-{MOST_LINES}" in refused[-1].name
    assert "more than 2,000 lines" in refused[-1].reason
