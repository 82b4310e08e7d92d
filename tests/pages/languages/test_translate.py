"""The texts of a lesson: which there are, and what is put in their places."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import markdown
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim.pages.text.fence_scan import scan
from sim.pages.text.yaml.source import load
from sim.pages.translate.put_in import bank_units, lesson_units, put_in
from sim.pages.translate.unit import Unit, changed_marks, is_prose

ROOT = Path(__file__).parents[3]
LESSONS = sorted(ROOT.glob("worksheets/*.md"))
PAGES = sorted([*LESSONS, *ROOT.glob("docs/**/*.md"), *ROOT.glob("sim/effects/*/page.md")])
BANKS = sorted([*ROOT.glob("worksheets/banks/*.yml"), *ROOT.glob("tests/web/question/banks/*.yml")])
# As in mkdocs.yml, but for what only draws.
EXTENSIONS = ["admonition", "attr_list", "def_list", "footnotes", "md_in_html", "tables",
              "pymdownx.arithmatex", "pymdownx.details", "sane_lists", "toc"]  # fmt: skip


def units_of(path: Path) -> tuple[Unit, ...]:
    text = path.read_text(encoding="utf-8")
    return bank_units(text) if path.suffix == ".yml" else lesson_units(text)


def texts_of(text: str) -> list[str]:
    return [unit.text for unit in lesson_units(text)]


@pytest.mark.parametrize("path", [*PAGES, *BANKS], ids=lambda path: path.stem)
def test_without_a_translation_a_lesson_stays_byte_for_byte(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    made = put_in(text, units_of(path), {})
    assert made.text == text
    assert made.open == made.units


@settings(max_examples=12)
@given(st.data())
@pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)
def test_what_is_not_translated_keeps_its_bytes_and_its_order(path: Path, data: Any) -> None:
    text, units = path.read_text(encoding="utf-8"), units_of(path)
    chosen = data.draw(st.sets(st.sampled_from(sorted({unit.text for unit in units}))))
    made = put_in(text, units, {one: f"Ω{k}Ω" for k, one in enumerate(sorted(chosen))})
    rest = re.split(r'"?Ω\d+Ω"?', made.text)
    at = 0
    for part in rest:  # every piece of the original is there, in its order
        at = text.index(part, at) + len(part)
    assert len(rest) == 1 + sum(unit.text in chosen for unit in units)
    assert {unit.text for unit in made.open} == {unit.text for unit in units} - chosen


def squeezed(value: Any) -> Any:
    if isinstance(value, dict):
        return {str(key).strip(): squeezed(part) for key, part in value.items()}
    return [*map(squeezed, value)] if isinstance(value, list) else str(value).strip()


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_a_translation_into_the_same_words_means_the_same(path: Path) -> None:
    """Markdown and YAML themselves say so: the same page around the blocks, the same values."""
    text, units = path.read_text(encoding="utf-8"), units_of(path)
    made = put_in(text, units, {unit.text: unit.text for unit in units}).text
    assert texts_of(made) == [unit.text for unit in units]
    shown, values = [], []
    for one in (text, made):
        lines = one.splitlines()
        blocks = list(scan(lines))
        for block in reversed(blocks):
            lines[block.start : block.end] = [""]
        head = re.sub(r"\A---\n.*?\n---\n", "", "\n".join(lines), flags=re.DOTALL)
        shown.append(" ".join(markdown.markdown(head, extensions=EXTENSIONS).split()))
        kinds = ("question", "scene", "quiz", "challenge", "measured")
        values.append([squeezed(load(b.body).plain) for b in blocks if b.name in kinds])
    assert shown[0] == shown[1]
    assert values[0] == values[1]


@pytest.mark.parametrize("path", BANKS, ids=lambda path: path.stem)
def test_a_bank_in_the_same_words_means_the_same(path: Path) -> None:
    text, units = path.read_text(encoding="utf-8"), units_of(path)
    made = put_in(text, units, {unit.text: unit.text for unit in units}).text
    assert squeezed(load(made).plain) == squeezed(load(text).plain)
    assert {unit.item for unit in units} - {""} <= {i["id"] for i in load(text).plain["items"]}  # type: ignore[index, call-overload, union-attr]


@pytest.mark.parametrize(
    ("text", "units"),
    [
        ("# One *word*\n\nTwo\nlines.\n", ["One *word*", "Two lines."]),
        ("## Head {: #x data-minutes=3 }\n", ["Head"]),
        ("- first\n  goes on\n- second\n", ["first goes on", "second"]),
        ('!!! note "A title"\n    Inside\n    it.\n\n    More.\n',
         ["A title", "Inside it.", "More."]),
        ("| a head | b |\n|---|---|\n| a cell | 3.0 |\n", ["a head", "a cell"]),
        ("Two lines  \nof a poem.\n", ["Two lines  \nof a poem."]),
        ("Text.\n\n    code, no text\n\n```python\nno_text = 1\n```\n", ["Text."]),
        ("\\[ F = m a \\]\n\n$$x$$\n\n<div>\nno text\n</div>\n\n[a]: https://a.example\n", []),
        ("> Quoted\n> text.\n", ["Quoted text."]),
        ("---\ntitle: A title\norder: 3\ndescription: Words.\n---\n\nText.\n",
         ["A title", "Words.", "Text."]),
        ("Term\n:   what it means\n", ["Term", "what it means"]),
        ("A note[^1].\n\n[^1]: At the foot.\n", ["A note[^1].", "At the foot."]),
    ],
)  # fmt: skip
def test_a_unit_is_what_stands_together(text: str, units: list[str]) -> None:
    assert texts_of(text) == units


def test_of_a_block_only_what_readers_read_is_a_unit() -> None:
    text = """\
```question
id: one-thing
type: table
ask: >-
  Fill
  in.
columns: [push, speed after it]
rows:
  - [0.1 N, {answer: 0.4 m/s, tolerance: 0.02 m/s}]
  - [a strong one, {answer: 0.8 m/s, tolerance: 0.02 m/s}]
plot: [push, speed after it]
topics: [no-text]
```

```scene
id: two-things
title: Two carts
carts: {A: {mass: 1 kg, position: 0.4 m, skin: van}}
effects:
  - push: {cart: A, force: 1 N, by: hand}
predict: {ask: "What?", choice: [This., That.]}
presets:
  soft spring: {A.mass: 2 kg}
```
"""
    assert texts_of(text) == [
        "Fill in.", "push", "speed after it", "a strong one", "push", "speed after it",
        "Two carts", "What?", "This.", "That.", "soft spring",
    ]  # fmt: skip
    made = put_in(
        text, lesson_units(text), {"soft spring": 'spring "lembut"', "Fill in.": "Isi\\!"}
    )
    question, scene = (load(block.body).plain for block in scan(made.text.splitlines()))
    assert question["ask"] == "Isi\\!"
    assert scene["presets"] == {'spring "lembut"': {"A.mass": "2 kg"}}


@pytest.mark.parametrize("text", ["3.6 m/s", "A", "\\(F = m\\,a\\)", "`code`", "100 %", "0.30"])
def test_numbers_letters_formulas_and_code_are_no_text(text: str) -> None:
    assert not is_prose(text)


@pytest.mark.parametrize("text", ["nothing", "0.25 m/s, because half is left", "力", "Two carts"])
def test_words_are_text(text: str) -> None:
    assert is_prose(text) == (len(text) > 1)


@pytest.mark.parametrize(
    ("text", "said", "lost", "new"),
    [
        (r"Force \(F = ma\) here", r"Daya \(F = ma\) di sini", [], []),
        (r"Force \(F = ma\) here", r"Daya \(F = mv\) di sini", [r"\(F = ma\)"], [r"\(F = mv\)"]),
        ("see [it](a.md#b)", "lihat [ini](a.md#b)", [], []),
        ("see [it](a.md)", "lihat ini", ["](a.md"], []),
        ("wide{: .x }", "lebar", ["{: .x }"], []),
        ("run `carts`", "jalankan `kereta`", ["`carts`"], ["`kereta`"]),
        ("{count} runs", "larian", ["{count}"], []),
        ("$x$ and $y$", "$y$ dan $x$", [], []),
    ],
)
def test_a_translation_keeps_the_marks_of_its_text(
    text: str, said: str, lost: list[str], new: list[str]
) -> None:
    assert changed_marks(text, said) == (lost, new)
