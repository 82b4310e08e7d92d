"""What teacher mode says and shows is what `carts check` says and the build shows."""

from __future__ import annotations

import base64
import io
import re
import zipfile
from pathlib import Path
from typing import Any

import pytest

from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson
from sim.pages.teach import answer as wire
from sim.pages.teach.answer import lesson_of, teach_answer
from sim.pages.teach.frame import Site
from sim.pages.teach.preview import Desk

ROOT = Path(__file__).parents[2]
GOLDEN = ROOT / "tests" / "golden" / "author-errors"
CASES = sorted(path.stem for path in GOLDEN.glob("*.md"))
SCENE = "```scene\nid: one\ncarts: {{A: {{mass: {mass}, position: 0.2 m}}}}\n```\n"


@pytest.mark.parametrize("name", CASES)
def test_an_authors_mistake_reads_as_in_carts_check(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(GOLDEN)
    text = (GOLDEN / f"{name}.md").read_text(encoding="utf-8")
    lesson = Lesson(f"{name}.md", (Path("scenes"),), (Path("banks"),))
    expected = check_lesson(text, lesson, SiteIds())
    assert list(Desk().look(text, lesson, Site()).findings) == expected


FAULTY = """\
# Head

{program}
```scene
id: one
carts: {{A: {{mass: -1 kg, position: 0.2 m}}}}
```

!!! after two "Title"
    Told.

!!! afer "Title"
    Told.

![](one.png) and \\(x

| a | b |
|---|---|
| $|v|$ | \\(|v|\\) |

## Part {{: data-minutes=x }}

``scene
id: three
"""
PROGRAM = "```python\n# of a program: ![](two.png)\nx = 1\n```\n"


@pytest.mark.parametrize("program", ["", PROGRAM], ids=["bare", "with a program"])
@pytest.mark.parametrize("mark", ["", "\ufeff"], ids=["", "with a mark"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_mistakes_are_found_whatever_ends_the_lines(end: str, mark: str, program: str) -> None:
    """The build reads a file with \\n alone; teacher mode has the file as it was saved."""
    lesson = Lesson("a.md")
    for text in (FAULTY.format(program=program), program + FAULTY.format(program="")):
        expected = check_lesson(text, lesson, SiteIds())
        assert {found.code for found in expected} >= {
            *("no-such-scene", "missing-alt", "unbalanced-formula", "unknown-word"),
            *("few-backticks", "not-a-number"),
        }
        saved = mark + text.replace("\n", end)
        assert list(Desk().look(saved, lesson, Site()).findings) == expected


def look(text: str, **more: Any) -> dict[str, Any]:
    lesson = {"file": "worksheets/a.md", "scenes": ["worksheets"], **more.pop("lesson", {})}
    return teach_answer({"do": "look", "text": text, "lesson": lesson, **more})[0]


@pytest.fixture(autouse=True)
def at_a_new_desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(wire, "_desk", Desk())
    monkeypatch.setattr(wire, "_laid", {})


def test_a_block_is_the_very_element_of_the_build_without_its_drawing() -> None:
    """The page draws it by the same functions; test_teacher_page looks at what comes of it."""
    from markdown import Markdown

    from sim.pages.blocks.extension import CartsExtension, Page, set_page
    from sim.pages.blocks.scene_block import Lesson

    text = SCENE.format(mass="1 kg")
    (block,) = look(text)["blocks"]
    set_page(Page(Lesson("lesson", watch="first")))
    built = Markdown(extensions=[CartsExtension()]).convert(text)
    set_page(None)
    plain = built.replace("<carts-scene data-search-exclude", "<carts-scene")
    assert "carts-stage" in plain
    bare = re.sub(r"(<carts-scene[^>]*>\n).*(\n<script)", r"\1\2", plain, flags=re.DOTALL)
    assert block["html"] == bare


def test_only_what_has_changed_is_made_and_sent() -> None:
    two = SCENE.format(mass="1 kg") + "\n" + SCENE.format(mass="2 kg").replace("one", "two")
    keys = [block["key"] for block in look(two)["blocks"]]
    changed = look(two.replace("2 kg", "3 kg"), have=keys)["blocks"]
    assert changed[0]["html"] is None
    assert changed[0]["key"] == keys[0]
    assert changed[1]["html"]


def test_the_text_between_is_made_as_the_build_does_with_places_for_the_blocks() -> None:
    text = f"---\ntitle: x\n---\n# Head\n\nSee [this](b.md#c).\n\n{SCENE.format(mass='1 kg')}\nEnd"
    frame = look(text)["frame"]
    assert frame == (
        '<h1>Head</h1>\n<p>See <a href="b.html#c">this</a>.</p>\n'
        '<carts-place data-block="0"></carts-place>\n<p>End</p>'
    )


def test_an_extension_that_is_not_here_leaves_the_page_as_it_is() -> None:
    assert look("# Head", lesson={"extensions": ["no.such.extension"]})["frame"] is None


def test_an_id_of_another_lesson_is_taken() -> None:
    found = look(SCENE.format(mass="1 kg"), lesson={"ids": {"one": "worksheets/b.md:7"}})
    assert [(f["line"], f["code"]) for f in found["findings"]] == [(2, "id-taken")]
    assert "worksheets/b.md:7" in found["findings"][0]["message"]


def test_a_form_whose_bank_is_not_in_the_page_stays_as_it_was_built() -> None:
    quiz = "```quiz\nid: q\nform: pre\nmode: practice\nbank: b.yml\nuse: all\n```\n"
    made = look(quiz)
    assert [block["state"] for block in made["blocks"]] == ["kept"]
    assert made["findings"] == []


def test_a_scene_file_and_a_linked_page_are_found() -> None:
    text = "[next](b.md)\n\n```scene\nid: one\nfile: two.yml\n```\n"
    files = {"worksheets/two.yml": "carts: {A: {mass: 1 kg, position: 0.2 m}}\n"}
    assert look(text, files=files, lesson={"names": ["worksheets/b.md"]})["findings"] == []


def test_no_file_is_laid_outside_of_the_desk(tmp_path: Path) -> None:
    look("x", files={"../out.yml": "x", "/tmp/out.yml": "x", "in.yml": "y"})
    written = {path.name for path in tmp_path.rglob("*") if path.is_file()}
    assert written == {"in.yml"}
    assert lesson_of({"file": "a.md"}).scene_folders == ()


def test_a_long_lesson_is_made_in_slices(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(wire, "SLICE", 0)
    two = SCENE.format(mass="1 kg") + "\n" + SCENE.format(mass="2 kg").replace("one", "two")
    first = look(two)
    assert first["more"]
    assert {block["state"] for block in first["blocks"]} == {"later"}
    monkeypatch.setattr(wire, "SLICE", 60)
    assert not look(two)["more"]


def test_the_zip_holds_the_lesson_and_what_was_changed_in_it() -> None:
    request = {
        "do": "zip",
        "file": "worksheets/a.md",
        "text": "one\nTWO",
        "published": "one\ntwo\n",
    }
    data = teach_answer(request)[0]["base64"]
    assert data == teach_answer(request)[0]["base64"]
    with zipfile.ZipFile(io.BytesIO(base64.b64decode(data))) as archive:
        assert archive.read("a/worksheets/a.md") == b"one\nTWO"
        diff = archive.read("a/changes.diff").decode()
    assert "-two\n+TWO\n\\ No newline at end of file\n" in diff


def test_the_changes_are_those_that_programs_for_versions_read() -> None:
    """A line ends at \\n: signs of Word and PDF files stand in it."""
    request = {"do": "zip", "file": "worksheets/a.md"}
    texts = {"published": "a\u2028b\fc\rd\ntwo\r\n", "text": "a\u2028b\fc\rd\nTWO\r\n"}
    data = base64.b64decode(teach_answer({**request, **texts})[0]["base64"])
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        rows = archive.read("a/changes.diff").decode().split("\n")[2:]
    assert rows == ["@@ -1,2 +1,2 @@", " a\u2028b\fc\rd", "-two\r", "+TWO\r", ""]


def test_a_field_is_set_and_what_cannot_be_said_is_refused() -> None:
    text = SCENE.format(mass="1 kg")
    request = {"do": "set", "text": text, "block": 0, "path": ["carts", "A", "mass"]}
    made = teach_answer({**request, "value": "2 kg"})[0]
    assert made == {"text": SCENE.format(mass="2 kg")}
    gone = teach_answer({**request, "path": ["carts", "Z", "mass"], "value": "2"})[0]
    assert "no longer there" in gone["refused"]


SCALES = "```scene\nid: one\ncarts: {A: {mass: 0.5 kg, position: 0.4 m}}\nuntil: 2 s\n```\n"


@pytest.mark.parametrize(
    ("typed", "written"),
    [("750", ""), ("750,0", ""), ("750 g", "750 g"), ("750 kg", "750 kg"), ("0.75", "0.75")],
)
def test_a_mass_typed_in_grams_over_kilograms_is_asked_about(typed: str, written: str) -> None:
    """“750” over “0.5 kg” made a cart of 750 kg, and nothing was said."""
    path = ["carts", "A", "mass"]
    request = {"do": "set", "text": SCALES, "block": 0, "path": path, "value": typed}
    answer, _ = teach_answer(request)
    if written:
        assert answer["text"] == SCALES.replace("0.5 kg", written)
    else:
        assert answer["refused"].startswith(f"{typed} kg? Carts weigh 0.1 to 5 kg.")
        assert f"Type {typed} g for grams" in answer["refused"]
