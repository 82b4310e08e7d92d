"""What an author holds back below a prediction is told nowhere else, and opens at nothing else."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import markdown
import pytest

from sim.pages.blocks.extension import CartsExtension, Page, set_page
from sim.pages.blocks.scene_block import Lesson
from sim.pages.findings import Finding
from sim.pages.teach.frame import Site
from sim.pages.teach.preview import Desk

ROOT = Path(__file__).parents[2]

SCENE = """\
```scene
id: one
carts: {A: {mass: 1 kg, position: 0.4 m, velocity: 0.5 m/s}}
until: 2 s
predict: {text: What}
```
"""
QUESTION = "```question\nid: why\ntype: long\nask: Why?\nrubric: {1: a, 0: b}\n```\n"
PLACE = '<carts-place data-block="1"></carts-place>'
EXTENSIONS = ["admonition", "attr_list", "toc"]


@pytest.fixture
def found() -> Iterator[list[Finding]]:
    findings: list[Finding] = []
    set_page(Page(Lesson("lesson.md"), report=findings.append))
    yield findings
    set_page(None)


def waiting(page: str) -> str:
    return page[page.index("<carts-after") : page.index("</carts-after>")]


@pytest.mark.parametrize("level", range(1, 7))
def test_contents_list_no_heading_that_waits(found: list[Finding], level: int) -> None:
    signs = "#" * level
    other = f"{signs} Named {{: #own data-toc-label=Told }}"
    inside = f"    {signs} The forces are equal\n\n    {other}"
    text = f"[TOC]\n\n{SCENE}\n!!! after\n{inside}\n\n{signs} The forces are equal\n"
    made = markdown.Markdown(extensions=[*EXTENSIONS, CartsExtension()])
    page = made.convert(text)
    assert [one["name"] for one in made.toc_tokens] == ["The forces are equal"]  # type: ignore[attr-defined]
    assert page[: page.index("<carts-scene")].count("forces are equal") == 1
    held = waiting(page)
    assert f'<h{level} id="the-forces-are-equal">The forces are equal</h{level}>' in held
    assert f'<h{level} id="own">Named</h{level}>' in held
    assert page.count('id="the-forces-are-equal"') == 1  # links lead on
    assert not found


@pytest.mark.parametrize(
    ("heading", "name"),
    [
        ("Same", "same"),
        ("Kraft&nbsp;1", "kraft-1"),
        ("A<br>B", "ab"),
        ("Note[^1]", "note"),
        ("Two *of* `these`", "two-of-these"),
        (r"So \* so", "so-so"),
        ("&lt;b&gt; &amp; <!-- c -->d", "b-d"),
    ],
)
def test_no_heading_gets_another_id_for_one_that_waits(
    found: list[Finding], heading: str, name: str
) -> None:
    note = f"!!! after\n    ## {heading}\n"
    second = SCENE.replace("id: one", "id: two")
    text = f"# {heading}\n\n{SCENE}\n## {heading}\n\n{second}\n{note}\n## {heading}\n\n[^1]: F"
    others = [*EXTENSIONS, "footnotes"]
    made = markdown.markdown(text, extensions=[*others, CartsExtension()])
    plain = markdown.markdown(text.replace("!!! after", "!!! note"), extensions=others)
    ids = [re.findall(r'<h[12][^>]* id="([^"]+)"', page) for page in (made, plain)]
    assert ids[0] == ids[1] == [name, f"{name}_1", f"{name}_2", f"{name}_3"]


@pytest.mark.parametrize("depth", [2, 3])
def test_a_heading_in_a_note_within_a_note_stays_a_heading(
    found: list[Finding], depth: int
) -> None:
    notes = "".join(f"{'    ' * k}!!! after\n" for k in range(depth))
    inner = "    " * depth
    text = f"[TOC]\n\n{SCENE}\n{notes}{inner}## Told\n\n{inner}Both.\n\n## Seen\n"
    made = markdown.Markdown(extensions=[*EXTENSIONS, CartsExtension()])
    page = made.convert(text)
    assert page.count("<carts-after") == depth
    assert '<h2 id="told">Told</h2>' in page and "<carts-hidden-" not in page
    assert [one["name"] for one in made.toc_tokens] == ["Seen"]  # type: ignore[attr-defined]


@pytest.mark.parametrize("fence", ["```", "~~~~"])
def test_a_comment_in_a_program_opens_no_question(found: list[Finding], fence: str) -> None:
    program = f"{fence}python\n# a comment {{: .more }}\nx = 1\n{fence}\n"
    made = markdown.markdown(
        f"{SCENE}\n{program}\n{QUESTION}", extensions=["pymdownx.superfences", CartsExtension()]
    )
    assert 'data-after="one"' in made
    assert not found


def test_teacher_mode_holds_back_what_the_build_does(found: list[Finding]) -> None:
    note = "    ## What you saw\n\n    Both were equal.\n"
    text = f"{SCENE}\n!!! after\n{note}\n## Next {{: data-minutes=8 }}\n\n!!! after\n    Again.\n"
    site = Site(extensions=EXTENSIONS)
    frame = Desk().look(text, Lesson("lesson.md"), site).frame or ""
    built = markdown.markdown(text, extensions=[*EXTENSIONS, CartsExtension()])
    assert waiting(frame) == waiting(built)
    assert frame.count('<carts-after class="admonition after" data-after="one"') == 2
    assert 'data-length="8 min"' in frame
    assert frame.split("</carts-place>")[1] == built.split("</carts-scene>")[1]


def test_teacher_mode_holds_back_a_scene_with_its_text(found: list[Finding]) -> None:
    inner = SCENE.replace("id: one", "id: two").replace("\n", "\n    ")
    frame = Desk().look(f"{SCENE}\n!!! after one\n    {inner}", Lesson("a.md"),
                        Site(extensions=EXTENSIONS)).frame or ""  # fmt: skip
    assert 'class="admonition after carts-wide"' in frame
    assert '<carts-place data-block="1">' in waiting(frame)


@pytest.mark.parametrize("week", [1, 3, 8])
def test_a_return_asks_its_questions_when_its_run_was_watched(
    found: list[Finding], week: int
) -> None:
    """They answer at once, and two of them with what the run shows."""
    file = ROOT / "worksheets" / f"return-week-{week}.md"
    text = file.read_text(encoding="utf-8").partition("\n---\n")[2]
    lesson = Lesson(file.name, bank_folders=(file.parent / "banks",))
    set_page(Page(lesson, report=found.append))
    built = markdown.markdown(text, extensions=[*EXTENSIONS, CartsExtension()])
    frame = Desk().look(text, lesson, Site(extensions=EXTENSIONS)).frame or ""
    assert f'data-after="return-{week}-run"' in built
    assert waiting(built).count("<carts-question") == built.count("<carts-question") == 3
    assert waiting(frame) == waiting(built).partition("<carts-quiz")[0] + PLACE
    assert not found
