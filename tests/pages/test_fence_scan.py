"""Blocks are found where CommonMark sees them, with their lines; near misses are found too."""

from __future__ import annotations

import pytest

from sim.pages.text.fence_scan import Block, meant_kind, scan


def blocks(text: str) -> list[Block]:
    return list(scan(text.splitlines()))


def test_a_block_has_its_name_lines_and_body() -> None:
    (block,) = blocks("# Title\n\n```scene\nid: one\nuntil: 2 s\n```\nafter\n")
    assert (block.name, block.start, block.end) == ("scene", 2, 6)
    assert block.body == "id: one\nuntil: 2 s"
    assert block.closed


def test_front_matter_is_no_place_for_blocks() -> None:
    text = "---\ntitle: |\n  ```scene\n---\n\n```scene\nid: one\n```\n"
    assert [block.start for block in blocks(text)] == [5]


def test_a_line_of_dashes_later_is_only_a_line() -> None:
    assert len(blocks("Text\n\n---\n\n```scene\n```\n")) == 1


def test_an_example_inside_a_longer_fence_is_no_block() -> None:
    assert not blocks("````markdown\n```scene\nid: one\n```\n````\n")


def test_a_shorter_fence_does_not_close_a_longer_one() -> None:
    (block,) = blocks("````scene\n```\nid: one\n````\n")
    assert block.body == "```\nid: one"


def test_tildes_do_as_well_as_backticks() -> None:
    (block,) = blocks("~~~ scene\nid: one\n~~~\n")
    assert block.name == "scene"


def test_code_in_another_language_is_left_alone() -> None:
    assert not blocks("```python\nscene = 1\n```\n\n```yaml\nid: one\n```\n\n```\nscene\n```\n")


def test_a_block_in_a_list_loses_its_indentation() -> None:
    (block,) = blocks("- step\n\n    ```scene\n    carts:\n      A: {mass: 1}\n    ```\n")
    assert block.body == "carts:\n  A: {mass: 1}"
    assert block.body_indent == 4


def test_a_block_without_an_end_goes_to_the_end_of_the_file() -> None:
    (block,) = blocks("```scene\nid: one\n")
    assert not block.closed
    assert block.body == "id: one"


def test_text_behind_the_name_is_kept_for_the_message() -> None:
    (block,) = blocks("```scene id=one slow\n```\n")
    assert block.rest == "id=one slow"


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("> ```scene\n> id: one\n> ```\n", "in-quote"),
        ("\t```scene\n\tid: one\n\t```\n", "tab-indent"),
        ("- a\n\n    ```scene\n  id: one\n    ```\n", "less-indented"),
    ],
)
def test_a_block_that_markdown_would_mangle_has_a_fault(text: str, fault: str) -> None:
    (block,) = blocks(text)
    assert block.fault == fault


@pytest.mark.parametrize(
    "name", ["Scene", "scenes", "scence", "scne", "{scene}", ".scene", "sceen"]
)
def test_a_name_close_to_scene_was_meant_to_be_scene(name: str) -> None:
    assert meant_kind(name) == "scene"


@pytest.mark.parametrize("name", ["", "python", "scheme", "scss", "json", "text", "js", "csv"])
def test_a_language_is_not_taken_for_a_block(name: str) -> None:
    assert meant_kind(name) is None


def test_windows_line_ends_change_nothing() -> None:
    (block,) = scan("```scene\r\nid: one\r\n```\r\n".splitlines(keepends=True))
    assert block.body == "id: one"
