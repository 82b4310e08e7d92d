"""Tables dropped on the page are read as the command line reads them."""

from __future__ import annotations

import json
from base64 import b64encode
from pathlib import Path
from typing import Any

from click.testing import CliRunner

from sim.bridge.protocol import answer
from sim.classroom.files.reading import Reading
from sim.classroom.files.records import as_record
from sim.classroom.tables.distinct import distinct
from sim.classroom.tables.dropped import dropped_report
from sim.cli import main
from tests.classroom.given.makers import bank, keys, random_class, sources
from tests.web.scene.given.widget_site import in_node

TOTALS = "student;group;pre;post\n" + "".join(
    f"S{k};{'new' if k % 2 else 'old'};{8 + k % 5};{12 + k % 7}\n" for k in range(16)
)
BANK = bank(4)
ITEMS = "student,q1,q2,q3\nA,1,0,1\nB,0,0,1\nC,1,1,1\n"


def table(text: str, name: str = "marks.csv", form: str = "", group: str = "") -> dict[str, str]:
    coded = b64encode(text.encode()).decode()
    return {"name": name, "base64": coded, "form": form, "group": group}


def report(*tables: dict[str, str], most: str = "") -> dict[str, Any]:
    return dropped_report(tables, most, inference=True)


def test_the_page_reports_as_the_command_does(tmp_path: Path) -> None:
    file = tmp_path / "marks.csv"
    file.write_text(TOTALS, encoding="utf-8")
    told = CliRunner().invoke(main, ["class", "--table", str(file), "--max", "30", "--json"])
    command, page = json.loads(told.stdout), report(table(TOTALS), most="30")
    assert page["lessons"] == command["lessons"]


def test_two_tables_are_before_and_after_as_the_teacher_says() -> None:
    found = report(
        table(ITEMS, "a.csv", "pre"), table(ITEMS.replace("A,1,0", "A,1,1"), "b.csv", "post")
    )
    (lesson,) = found["lessons"]
    assert [form["form"] for form in lesson["forms"]] == ["pre", "post"]
    assert lesson["lesson"] == "a"


def test_what_is_no_table_is_named_and_the_others_count() -> None:
    found = report(table("", "empty.csv"), table(ITEMS))
    assert [row["name"] for row in found["files"]["refused"]] == ["empty.csv"]
    assert found["files"]["counted"] == 3
    assert report(table("", "empty.csv"))["files"]["counted"] == 0


def test_the_most_marks_are_those_of_totals() -> None:
    assert any("a row MAX" in note for note in report(table(ITEMS), most="3")["notes"])
    assert any("write the most" in note for note in report(table(TOTALS), most="many")["notes"])


def test_the_wire_gives_html_and_saves_what_was_dropped() -> None:
    asked = {"kind": "class", "tables": [table(TOTALS)], "most": "30", "inference": True}
    header, _ = answer(asked | {"do": "report"})
    assert "marks" in header["html"]
    saved, _ = answer(asked | {"do": "save", "what": "csv"})
    assert saved["text"].count("\n") > 16


def class_of(step: int) -> str:
    rows = "".join(f"{name},{k % 5},{k * step % 9}\n" for k, name in enumerate(FIRST_NAMES))
    return f"name,pre (9),post (9)\n{rows}"


FIRST_NAMES = ("Anna", "Ben", "Cara", "Dora", "Emil", "Fay")


def test_tables_dropped_on_two_fields_are_two_groups_with_students_of_their_own() -> None:
    found = report(table(class_of(2), "a.csv", group="new"), table(class_of(4), group="old"))
    assert found["groups"] == ["new", "old"]
    assert found["lessons"][0]["comparison"]["groups"] == ["new", "old"]
    assert [gain["n"] for gain in found["lessons"][0]["gains"]] == [6, 6]
    assert not found["flags"]
    assert not found["files"]["refused"]


def test_a_save_holds_the_answers_and_the_tables() -> None:
    reading = Reading.of(sources(random_class(BANK, 6)))
    both = {
        "kind": "class", "do": "save", "groups": ["class"], "tables": [table(TOTALS)],
        "records": [[as_record(read), "class"] for read in reading.files], "keys": [keys(BANK)],
    }  # fmt: skip
    of_tables, of_answers = ({k: v for k, v in both.items() if k != gone}
                             for gone in ("records", "tables"))  # fmt: skip
    for what in ("csv", "items", "html"):
        whole, marks, files = (answer(asked | {"what": what})[0]["text"]
                               for asked in (both, of_tables, of_answers))  # fmt: skip
        rows = [text.count("\n") for text in (whole, marks, files)]
        if what == "html":
            assert "S15" not in files
            assert all(whole.count(f"<h2>{title}</h2>") == 1 for title in ("Carts", "Marks"))
        else:
            assert rows[0] == rows[1] + rows[2] - 1


def test_two_tables_of_one_name_are_two_tables() -> None:
    assert distinct(["quiz.csv", "quiz.csv", "b.csv"]) == ["quiz.csv", "quiz.csv (2)", "b.csv"]
    assert distinct(["7a/quiz.csv", "7b/quiz.csv"]) == ["7a/quiz.csv", "7b/quiz.csv"]


def test_a_page_tells_the_tables_of_the_first_field_first_each_with_its_group() -> None:
    told = in_node(
        """globalThis.document = { documentElement: { dataset: {}, lang: "en" },
          getElementById: () => null };
        const { Classroom } = await import(source + "/class/classroom.js");
        const classroom = new Classroom();
        classroom.tables = data.map((group) => ({ name: "a", form: "", group }));
        classroom.names = ["new", "old"];
        const one = classroom.toldOfTables().tables.map((table) => table.group);
        classroom.divide(true);
        classroom.codes = ["a", "b"];
        const two = classroom.toldOfTables().tables.map((table) => table.group);
        classroom.divide(false);
        give([one, two, classroom.codes, Object.keys(classroom.toldOfAll())]);""",
        [1, 0, 1],
    )
    assert told[:3] == [["class"] * 3, ["new", "old", "old"], ["a\nb", ""]]
    assert {"records", "tables"} <= {*told[3]}


def test_a_table_that_cannot_be_read_is_not_called_too_large() -> None:
    script = """
      globalThis.document = { documentElement: { lang: "en" } };
      globalThis.FileReader = class {
        readAsDataURL() {
          this.onerror();
        }
      };
      const { asTable } = await import(`${source}/class/intake.js`);
      give([await asTable({ name: "gone.csv", size: 9 }, 0), await asTable({ size: 2e7 }, 0)]);
    """
    assert in_node(script, None) == [
        "this file cannot be read",
        "this table is too large for a page",
    ]
