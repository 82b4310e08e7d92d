"""`![words](film.mp4)` in the text of a lesson, in a question and in teacher mode."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from markdown import Markdown

from sim.pages.blocks.extension import CartsExtension, Page, set_page
from sim.pages.blocks.scene_block import Lesson
from sim.pages.question import PageItems
from sim.pages.question.inside import to_html
from sim.pages.teach.frame import Site, frame_of
from sim.pages.text.films import is_film

TEXT = "Look: ![a bump](bump.mp4){: width=320 } twice.\n\n![two carts](carts.png)\n"


def built(text: str, language: str = "en") -> str:
    page = Page(Lesson("lesson.md"))
    page.language = language
    set_page(page)
    try:
        return Markdown(extensions=[CartsExtension(), "attr_list"]).convert(text)
    finally:
        set_page(None)


def previewed(text: str) -> str:
    lines: Sequence[str] = text.split("\n")
    return frame_of(lines, (), PageItems(), Site(extensions=["attr_list"])) or ""


@pytest.mark.parametrize("make", [built, previewed])
def test_a_film_is_shown_with_its_words_and_a_picture_stays_one(make: object) -> None:
    made = make(TEXT)  # type: ignore[operator]
    assert "<video" in made
    assert 'src="bump.mp4"' in made
    assert 'width="320"' in made
    assert 'aria-label="a bump"' in made
    assert '<a href="bump.mp4">The film as a file</a>' in made
    assert '<img alt="two carts" src="carts.png"' in made
    assert made.count("<video") == 1


def test_its_link_speaks_the_language_of_the_page() -> None:
    assert "影片文件" in built(TEXT, "zh-Hans")


def test_a_question_may_show_a_film() -> None:
    made = to_html("Which cart was pushed harder? ![a bump](bump.webm)")
    assert 'src="bump.webm"' in made
    assert "<video" in made
    assert "<img" not in made


def test_what_a_film_is_told_by_the_end_of_its_name() -> None:
    assert is_film("a/Bump.MP4?x=1#t=2")
    assert not is_film("mp4.png")
    assert not is_film("bump.mp4.md")
