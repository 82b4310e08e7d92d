"""Blocks become scenes or red boxes; nothing that goes wrong is swallowed."""

from __future__ import annotations

import sys
import textwrap
from collections.abc import Iterator
from pathlib import Path

import markdown
import pytest

from sim.pages.blocks import extension, makers
from sim.pages.blocks.extension import CartsExtension, Page, set_page
from sim.pages.blocks.scene_block import Lesson
from sim.pages.findings import AuthorError, Finding
from sim.pages.text.blocked import blocked

SCENE = """\
```scene
id: one
carts: {A: {mass: 1 kg, position: 0.4 m, velocity: 0.5 m/s}}
until: 2 s
```
"""
BAD = SCENE.replace("mass: 1 kg", "mass: -1 kg")


@pytest.fixture
def found() -> Iterator[list[Finding]]:
    """What is reported while a page is made."""
    findings: list[Finding] = []
    set_page(Page(Lesson("lesson.md"), first_line=4, report=findings.append))
    yield findings
    set_page(None)


def html(text: str) -> str:
    return markdown.markdown(
        text, extensions=["pymdownx.superfences", "admonition", "md_in_html", CartsExtension()]
    )


def test_a_block_becomes_a_scene(found: list[Finding]) -> None:
    made = html(f"Before\n\n{SCENE}\nAfter\n")
    assert "<carts-scene" in made
    assert "<p><div" not in made
    assert "cartsblock" not in made
    assert made.index("Before") < made.index("<carts-scene") < made.index("After")
    assert not found


def test_a_block_needs_no_blank_lines_around_it(found: list[Finding]) -> None:
    made = html(f"Before\n{SCENE}After\n")
    assert "<p>Before</p>" in made
    assert "<p>After</p>" in made


def test_a_scene_may_stand_in_a_list_and_in_a_note(found: list[Finding]) -> None:
    inside = "".join(f"    {line}\n" for line in SCENE.splitlines())
    made = html(f"1. Step\n\n{inside}\n!!! note\n\n{inside.replace('id: one', 'id: two')}")
    assert made.count("<carts-scene") == 2
    assert made.index("<li>") < made.index("<carts-scene") < made.index("</li>")
    assert not found


def test_a_mistake_becomes_a_red_box_and_is_reported(found: list[Finding]) -> None:
    made = html(f"Before\n\n{BAD}\nAfter <b>\n")
    assert "carts-author-error" in made
    assert "mass must be greater than 0" in made
    assert "After" in made
    (finding,) = found
    assert (finding.file, finding.line, finding.col) == ("lesson.md", 8, 19)


def test_the_red_box_cannot_carry_html(found: list[Finding]) -> None:
    made = html(SCENE.replace("mass: 1 kg", 'mass: "<img src=x onerror=alert(1)>"'))
    assert "<img" not in made
    assert "&lt;img" in made


def test_without_a_generator_the_first_mistake_is_an_exception() -> None:
    with pytest.raises(AuthorError, match="mass must be greater"):
        html(BAD)


def test_a_crash_of_ours_is_not_swallowed(
    found: list[Finding], monkeypatch: pytest.MonkeyPatch
) -> None:
    def crash(*_: object) -> None:
        raise ZeroDivisionError("our own mistake")

    monkeypatch.setattr(makers, "bake", crash)
    with pytest.raises(ZeroDivisionError):
        html(SCENE)


AFTER = "!!! {}after{}\n    Both were equal.\n"


@pytest.mark.parametrize("kind", ["", "check "])
@pytest.mark.parametrize("title", ["", ' "What was it?"'])
def test_text_held_back_waits_for_the_scene_above(
    found: list[Finding], kind: str, title: str
) -> None:
    made = html(f"{SCENE}\n{AFTER.format(kind, title)}\nOpen text\n")
    waiting = made[made.index("<carts-after") : made.index("</carts-after>")]
    assert 'data-after="one"' in waiting
    assert '<a href="#one">the run above</a>' in waiting
    assert "Both were equal." in waiting
    assert ("What was it?" in waiting) == bool(title)
    assert ("admonition-title" in waiting) == bool(title)
    assert (kind.strip() or "after") in waiting
    assert "Open text" not in waiting
    assert "carts-waits-for" not in made
    assert not found


def test_text_held_back_waits_for_the_prediction_of_its_section(found: list[Finding]) -> None:
    asking = SCENE.replace("until: 2 s", "until: 2 s\npredict: {text: What}")
    other = SCENE.replace("id: one", "id: two")
    made = html(f"{asking}\n{other}\n{AFTER.format('', '')}\n## New\n\n{AFTER.format('', '')}")
    assert made.count('data-after="one"') == 1
    assert made.count('data-after="two"') == 1
    assert made.index('data-after="one"') < made.index("New") < made.index('data-after="two"')


def test_text_held_back_may_name_its_scene(found: list[Finding]) -> None:
    other = SCENE.replace("id: one", "id: two")
    after = [AFTER.format("", " one"), AFTER.format("", ' two "T"')]
    made = html("\n".join([SCENE, other, *after]))
    assert made.count('data-after="one"') == made.count('data-after="two"') == 1
    assert made.count("admonition-title") == 1


def test_a_scene_may_be_held_back_with_the_text_around_it(found: list[Finding]) -> None:
    inner = textwrap.indent(SCENE.replace("id: one", "id: two"), "    ")
    made = html(f"{SCENE}\n{AFTER.format('', ' one')}\n{inner}\nOpen text\n")
    waiting = made[made.index("<carts-after") : made.index("</carts-after>")]
    assert 'data-after="one"' in waiting
    assert waiting.count("<carts-scene") == 1
    assert made.count("<carts-scene") == 2
    assert not found


def test_an_example_of_text_held_back_stays_an_example(found: list[Finding]) -> None:
    made = html(f"{SCENE}\n```markdown\n{AFTER.format('', '')}```\n")
    assert "<carts-after" not in made
    assert "!!! after" in made


def test_an_example_of_a_block_stays_an_example(found: list[Finding]) -> None:
    made = html(f"````markdown\n{BAD}````\n")
    assert "<carts-scene" not in made
    assert not found


def test_two_pages_do_not_mix(found: list[Finding]) -> None:
    renderer = markdown.Markdown(extensions=[CartsExtension()])
    first = renderer.convert(SCENE)
    second = renderer.convert("cartsblock and no scene")
    assert "<carts-scene" in first
    assert "<carts-scene" not in second


def test_a_page_counts_its_scenes_and_packages() -> None:
    page = Page(Lesson("lesson.md"), report=lambda _: None)
    set_page(page)
    try:
        html(SCENE.replace("until: 2 s", "until: 2 s\npackages: [numpy]"))
    finally:
        set_page(None)
    assert page.scenes == 1
    assert page.packages == {"numpy"}


def test_a_scene_file_gives_the_scene(tmp_path: Path) -> None:
    (tmp_path / "two.yml").write_text("carts: {A: {mass: 1, position: 0}}\n", encoding="utf-8")
    page = Page(Lesson("lesson.md", (tmp_path,)))
    set_page(page)
    try:
        assert "<carts-scene" in html("```scene\nid: one\nfile: two.yml\n```\n")
    finally:
        set_page(None)


@pytest.mark.parametrize(
    "payload",
    [
        "<img src=x onerror=alert(1)>",
        "</script><script>alert(1)</script>",
        "' onmouseover='alert(1)",
        "-->]]><svg onload=alert(1)>",
        "<a href=javascript:alert(1)>x</a>",
        "&lt;img src=x onerror=alert(1)&gt;",
        "{{ 7 * 7 }}{% raw %}",
    ],
)
@pytest.mark.parametrize(
    "where",
    [
        "title: {}",
        "predict: {{ask: {0}, choice: [{0}, other]}}",
        "predict: {{text: {}}}",
    ],
)
def test_no_text_of_an_author_becomes_html(payload: str, where: str, found: list[Finding]) -> None:
    quoted = "'" + payload.replace("'", "''") + "'"
    made = html(SCENE.replace("until:", where.format(quoted) + "\nuntil:"))
    assert "<carts-scene" in made, found
    assert blocked(made) == []
    assert "<img" not in made
    assert made.count("<script") == made.count('<script type="application/json"')


def test_what_comes_late_makes_the_same_page() -> None:
    question = "```question\nid: why\ntype: long\nask: Why?\nrubric: {1: a reason, 0: none}\n```"
    text = f"Before\n\n{SCENE}\n- in a list\n\n    {question.replace(chr(10), chr(10) + '    ')}\n"
    made = []
    for late in (None, {}):
        page = Page(Lesson("lesson.md"), late=late)
        set_page(page)
        made.append((html(text), page.late))
        set_page(None)
    (at_once, _), (stubs, late) = made
    assert "<carts-" in at_once and "<carts-" not in stubs
    assert extension.with_late(stubs, late) == at_once


def test_without_v8_a_build_says_one_sentence(
    found: list[Finding], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A machine that mini-racer has no wheel for."""
    from sim.pages import drawing

    monkeypatch.setitem(sys.modules, "py_mini_racer", None)
    monkeypatch.setattr(drawing, "_started", [])
    monkeypatch.setattr(drawing, "_read", {})
    drawing._drawn.cache_clear()  # other tests drew this scene
    text = html(SCENE)
    (finding,) = found
    assert finding.code == "not-drawn"
    assert "mini-racer" in finding.message
    assert "carts-author-error" in text
