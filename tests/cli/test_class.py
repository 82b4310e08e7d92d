"""`carts class`: exit codes, groups, keys, and what stands in the files it writes."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

from sim.classroom.files.marks_file import marks_file
from sim.lesson.handin import encode
from tests.classroom.given.makers import bank, form, keys, random_class, sources, zipped
from tests.cli.called import as_json
from tests.cli.called import carts_class as carts

BANK = bank(6, words=1)


@pytest.fixture
def school(tmp_path: Path) -> Path:
    for folder, seed, gain in (("7a", 1, 0.3), ("7b", 2, 0.1)):
        (tmp_path / folder).mkdir()
        for source in sources(random_class(BANK, 12, seed=seed, gain=gain, prefix=folder)):
            (tmp_path / folder / source.name).write_bytes(source.content)
    (tmp_path / "carts.key.json").write_text(keys(BANK), encoding="utf-8")
    return tmp_path


def test_a_folder_is_analysed_and_marked_with_the_key(school: Path) -> None:
    report = as_json(school / "7a", "--key", school / "carts.key.json")
    assert report["files"]["counted"] == 24
    assert [form["of"] for form in report["lessons"][0]["forms"]] == [6, 6]
    assert report["lessons"][0]["gains"][0]["n"] == 12


def test_without_a_key_answers_are_counted_and_nothing_is_marked(school: Path) -> None:
    (pre, post) = as_json(school / "7a")["lessons"][0]["forms"]
    assert pre["has_key"] is post["has_key"] is False
    assert pre["of"] == 0
    assert sum(choice["count"] for choice in pre["items"][0]["choices"]) > 5
    told = carts(school / "7a").stdout
    assert "no key for it, so nothing is marked" in told
    assert "It is called carts.key.json." in told
    assert "The keys that are here" not in told


def test_where_the_key_of_another_lesson_was_given_both_are_named(
    school: Path, tmp_path: Path
) -> None:
    given = json.loads(keys(bank(2), ["pre"]))
    other = tmp_path / "other.key.json"
    other.write_text(json.dumps(given | {"lesson": "other"}), encoding="utf-8")
    told = carts(school / "7a", "--key", other).stdout
    assert "It is called carts.key.json. The keys that are here are for other pre" in told


def test_tables_for_a_spreadsheet_with_decimal_commas_hold_the_same(school: Path) -> None:
    cells: dict[str, list[list[str]]] = {}
    for separator in (",", ";"):
        paths = [school / "students.csv", school / "items.csv"]
        call = (school / "7a", "--key", school / "carts.key.json", "--separator", separator)
        assert carts(*call, "--csv", paths[0], "--items", paths[1]).exit_code == 0
        texts = [path.read_text(encoding="utf-8-sig") for path in paths]
        lines = [line for text in texts for line in text.splitlines()]
        cells[separator] = [*csv.reader(lines, delimiter=separator)]
    assert any("0." in cell for row in cells[","] for cell in row)
    assert [[cell.replace(",", ".") for cell in row] for row in cells[";"]] == [
        [cell.replace(",", ".") for cell in row] for row in cells[","]
    ]


def test_a_file_of_answers_is_no_key(school: Path) -> None:
    """Before, it was one more file of a student, and nothing said why no answer was marked."""
    answers = next((school / "7b").iterdir())
    result = carts(school / "7a", "--key", answers)
    assert (result.exit_code, result.stdout) == (2, "")
    assert "this is a file of answers; carts key writes keys" in result.stderr


@pytest.mark.parametrize("also", [(), ("--key", "KEY")])
def test_a_class_with_nothing_but_typed_codes_is_read(
    also: tuple[str, ...], tmp_path: Path
) -> None:
    of = bank(6)
    code = encode([4] * 6, [1, 2, 3, 4, 0, 1], f"post:{form('post', of).hash}")
    codes, key = tmp_path / "codes.txt", tmp_path / "carts.key.json"
    codes.write_text(f"BLUE-FOX-27 post {code}\n", encoding="utf-8")
    key.write_text(keys(of), encoding="utf-8")
    result = carts("--codes", codes, *[key if word == "KEY" else word for word in also], "--json")
    assert result.exit_code == (0 if also else 1)
    assert json.loads(result.stdout)["files"]["counted"] == len(also) // 2
    assert ("there is no key for it" in result.stderr) is not bool(also)


def test_a_zip_gives_the_same_report_as_its_folder(school: Path) -> None:
    files = sources(random_class(BANK, 12, seed=1, gain=0.3, prefix="7a"))
    (school / "class.zip").write_bytes(zipped(files))
    key = ("--key", school / "carts.key.json")
    folder, packed = as_json(school / "7a", *key), as_json(school / "class.zip", *key)
    assert folder["lessons"][0]["gains"] == packed["lessons"][0]["gains"]


def test_groups_are_globs_and_the_same_name_again_is_another_class(school: Path) -> None:
    one = as_json(school, "--group", "new=7a/*", "--group", "usual=7b")
    assert one["groups"] == ["new", "usual"]
    comparison = one["lessons"][0]["comparison"]
    assert comparison["n"] == [12, 12]
    assert comparison["p_shown"] is False
    both = as_json(school, "--group", "all=7a/*", "--group", "all=7b/*")
    assert both["lessons"][0]["gains"][0]["n"] == 24


def test_quotes_that_a_windows_shell_hands_on_belong_to_no_group(school: Path) -> None:
    plain = as_json(school, "--group", "new=7a/*", "--group", "usual=7b/*")
    quoted = as_json(school, "--group", "new='7a/*'", "--group", "'usual=7b/*'")
    assert quoted["groups"] == plain["groups"] == ["new", "usual"]
    assert quoted["files"] == plain["files"]


def test_a_file_in_no_group_is_named(school: Path) -> None:
    result = carts(school, "--group", "new=7a/*", "--json")
    assert result.exit_code == 1
    assert "in none of the groups" in result.stderr
    assert json.loads(result.stdout)["files"]["counted"] == 24


def test_a_bad_file_is_named_with_the_reason_and_the_others_are_analysed(school: Path) -> None:
    (school / "7a" / "bad.json").write_text("{", encoding="utf-8")
    result = carts(school / "7a", "--json")
    assert result.exit_code == 1
    assert "bad.json: this file is damaged" in result.stderr
    assert json.loads(result.stdout)["files"]["counted"] == 24


def test_a_huge_file_is_not_read_to_its_end(school: Path) -> None:
    with (school / "7a" / "huge.json").open("wb") as file:
        file.truncate(2_000_000_000)  # takes no room on the disk
    result = carts(school / "7a", "--json")
    assert result.exit_code == 1
    assert "huge.json: this file is too large" in result.stderr
    assert json.loads(result.stdout)["files"]["counted"] == 24


def test_marks_of_the_page_count(school: Path) -> None:
    key = ("--key", school / "carts.key.json")
    table = as_json(school / "7a", *key)["lessons"][0]["forms"][0]
    given = {("carts", "pre", row["student"], "why-0"): 1 for row in table["students"]}
    (school / "marks.json").write_text(json.dumps(marks_file(given)), encoding="utf-8")
    after = as_json(school / "7a", *key, "--marks", school / "marks.json")
    assert after["lessons"][0]["forms"][0]["of"] == table["of"] + 2


def test_the_html_report_has_no_script_and_no_address(school: Path) -> None:
    target = school / "report.html"
    as_json(school, "--html", target)
    page = target.read_text(encoding="utf-8")
    assert "default-src 'none'" in page
    assert "<script" not in page
    assert "http://" not in page.replace("http://www.w3.org/2000/svg", "")
    assert "https://" not in page


def test_tables_are_written_for_spreadsheets(school: Path) -> None:
    marks, items = school / "marks.csv", school / "items.csv"
    as_json(school, "--csv", marks, "--items", items)
    lines = marks.read_text(encoding="utf-8-sig").splitlines()
    assert len(lines) == 49
    rows = list(csv.DictReader(lines))
    asked = [name for name in rows[0] if name.startswith("question ")]
    assert asked == [f"question {k}" for k in range(1, len(BANK.items) + 1)]
    for row in rows:
        assert sum(int(row[name] or 0) for name in asked) == int(row["marks"])
    assert items.read_bytes().startswith(b"\xef\xbb\xbflesson,form,item")


def test_hostile_names_are_escaped_in_the_report(school: Path) -> None:
    (school / "x").mkdir()
    hostile = random_class(BANK, 6, prefix="<script>alert(1)</script>\"'&")
    for file in hostile:
        file["lesson"] = "<b>lesson</b>"
    for k, source in enumerate(sources(hostile)):
        (school / "x" / f"{k}.json").write_bytes(source.content)
    carts(school / "x", "--html", school / "r.html")
    page = (school / "r.html").read_text(encoding="utf-8")
    assert "<script>" not in page
    assert "<b>" not in page
    assert "&lt;script&gt;alert(1)" in page


@pytest.mark.parametrize("words", [(), ("no-such-file",), (".", "--group", "a")])
def test_a_wrong_call_exits_with_2(words: tuple[str, ...]) -> None:
    assert carts(*words).exit_code == 2


def test_slips_and_the_page_of_the_class_are_written_in_a_language(school: Path) -> None:
    slips, sheet = school / "slips.html", school / "sheet.html"
    papers = ("--slips", slips, "--sheet", sheet, "--language", "ta")
    assert carts(school / "7a", school / "carts.key.json", *papers).exit_code == 0
    assert slips.read_text(encoding="utf-8").count('class="carts-slip"') == 12
    assert 'lang="ta"' in sheet.read_text(encoding="utf-8")


def test_slips_are_made_from_answer_files_only(school: Path) -> None:
    table = school / "marks.csv"
    table.write_text("student,pre,post\nA,1,2\n", encoding="utf-8")
    result = carts("--table", table, "--slips", school / "x.html")
    assert result.exit_code == 2
    assert "--slips and --sheet are made from answer files" in result.output
