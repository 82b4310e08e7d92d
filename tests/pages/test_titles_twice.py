"""Two lessons of one title are told: the menu shows the same entry twice. Copies that no page is
made of take nothing from those that have one."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.pages.checks.lessons import check_paths

SCENE = "```scene\nid: one\ncarts: {A: {mass: 1 kg, position: 0}}\n```\n"


def _checked(root: Path, **lessons: str) -> list[str]:
    for name, text in lessons.items():
        path = root / "worksheets" / f"{name.replace('__', '/')}.md"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return [str(one).splitlines()[0] for one in check_paths([root / "worksheets"], root)]


@pytest.mark.parametrize("quote", ["", '"', "'"])
@pytest.mark.parametrize(
    "first", ["---\norder: 1\ntitle: Who pushes?\n---\n# A\n", "# Who pushes?\n"]
)
def test_the_second_lesson_of_a_title_is_a_warning(tmp_path: Path, first: str, quote: str) -> None:
    second = f"---\ntitle: {quote}Who pushes?{quote}\n---\n\n# Another\n"
    line = 3 if "order" in first else 1
    assert _checked(tmp_path, a=first, b=second, c=second) == [
        f"worksheets/{name}.md:2:8: warning: the menu would show “Who pushes?” twice: "
        f"worksheets/a.md:{line} is called the same"
        for name in "bc"
    ]


@pytest.mark.parametrize("other", ["ms__a", "extra__a"])
def test_the_same_lesson_in_another_language_or_without_a_page_takes_no_title(
    tmp_path: Path, other: str
) -> None:
    text = "---\ntitle: Who pushes?\n---\n\n# A\n"
    assert not any("twice" in one for one in _checked(tmp_path, b=text, **{other: text}))


def test_a_lesson_and_a_comment_in_its_block_are_not_of_one_title(tmp_path: Path) -> None:
    text = "See:\n\n" + SCENE.replace("carts", "# so\ncarts")
    assert _checked(tmp_path, a="# so\n", b=text) == []


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("---\ntitle: >\n  One\n---\n\n# A\n", "---\ntitle: >\n  Two\n---\n\n# B\n"),
        ("# The file `a.yml`\n", "# The file `b.yml`\n"),
        ("# C\n", "# C#\n"),
    ],
)
def test_titles_that_differ_in_what_is_marked_are_two(tmp_path: Path, one: str, other: str) -> None:
    assert not any("twice" in told for told in _checked(tmp_path, a=one, b=other))


@pytest.mark.parametrize("second", ["# A #\n", "# A { #so }\n", '---\ntitle: "A"  \n---\n\n# B\n'])
def test_marks_behind_a_title_are_none_of_it(tmp_path: Path, second: str) -> None:
    assert any("twice" in told for told in _checked(tmp_path, a="# A\n", b=second))


def test_a_copy_that_is_not_built_is_never_the_first_user_of_an_id(tmp_path: Path) -> None:
    found = _checked(tmp_path, own=f"# A\n\n{SCENE}", extra__e=f"# A\n\n{SCENE}")
    assert [one.partition(": ")[0] for one in found] == ["worksheets/extra/e.md:1:1"]
    assert "no page is made of this lesson" in found[0]
