"""What our Markdown prints as running text is a warning with its place; what it reads is none."""

from __future__ import annotations

import re
from itertools import accumulate
from pathlib import Path

import pytest
from markdown import Markdown

from sim.pages.checks.lessons import check_paths
from sim.pages.checks.markdown_slips import markdown_slips
from sim.pages.site.usual_settings import EXTENSIONS
from tests.processor_time import budget

BUSY = 2.0  # s of the processor; a text that long took a minute, and takes a hundredth of it
TABLE = "| m | v |\n|---|---|\n| 1 | 2 |\n"
SLIPS = [
    ("You need:\n- two carts\n- a track\n", "2:1", "an empty line above it"),
    ("You need\n1. two carts\n2. a track\n", "2:1", "an empty line above it"),
    ("You need:\n* a track\n", "2:1", "an empty line above it"),
    ("!!! note\n    You need:\n    - a track\n", "3:5", "an empty line above it"),
    ("- a\n\n    You need:\n    - b\n    - c\n", "4:5", "an empty line above it"),
    ("1. Push:\n   - gently\n   - twice\n2. Look\n", "2:4", "with 4 spaces"),
    ("1. Push\n        - gently\n", "2:9", "with 4 spaces"),
    ("- a\n    - b\n    1. c\n    2. d\n", "3:5", "with 8 spaces"),
    (f"The table:\n{TABLE}", "2:1", "an empty line above it"),
    ("So:\nm | v\n--|--\n1 | 2\n", "2:1", "an empty line above it"),
    (f"- so\n{TABLE}", "2:1", "an empty line above it"),
    ("| m | v |\n| 1 | 2 |\n", "1:1", "write |---|---|"),
    ("| m | v |\n|---|\n| 1 | 2 |\n", "1:1", "write |---|---|"),
    ("See ![a picture](bild.png\n\nand (so) on\n", "1:5", "![a picture](bild.png)"),
    ("![a picture] (bild.png)\n", "1:1", "![a picture](bild.png)"),
    ("So $$x = 3$$ holds.\n", "1:4", "write $ … $"),
    ("So:\n$$\nx = 3\n$$\n", "2:1", "an empty line above and below"),
    ("- so $$x = 3$$\n- b\n", "1:6", "write $ … $"),
    (TABLE + "| $$x$$ | 1 |\n", "4:3", "write $ … $"),
]
FLAT = [
    "- a\n  - b\n- c\n",
    "- a\n\n  - b\n",
    "1. a\n\n   - b\n   - c\n",
    "- a\n    - b\n      - c\n",
]
RIGHT = [
    "- two carts\n- a track\n",
    "## You need\n- two carts\n",
    "!!! note\n    - two carts\n    - a track\n",
    "- a\n    - b\n        - c\n- d\n\n- e\n",
    "1. a\n    - b\n2. c\n",
    "- a\n\t- b\n",
    "- that goes\n  on\n- b\n",
    "- counts 1 of\n  1. Or not\n- b\n",
    "the sum of 5 and\n- 3 is 2, as\n",
    "that was in\n1687. Then\n",
    "$$\na\n- b\n- c\n$$\n",
    f"## T\n{TABLE}",
    "!!! note\n" + "".join(f"    {line}\n" for line in TABLE.splitlines()),
    "- so\n\n    | m |\n    |---|\n    | 1 |\n",
    "- $$x = 3$$\n- b\n",
    "!!! note\n    $$x = 3$$\n",
    "![a picture](bild.png\n\"its title\")\n",
    "<!-- You need:\n- a\n- b -->\n",
    "```text\nYou need:\n- a\n- b\n```\n",
    "so\n\n    in code:\n    - a\n    - b\n",
    "```question\nid: a\nask: |\n  Which:\n  - a\n  - b\n```\n",
    "So \\[\na\n- b\n- c\n\\]\n",
    "so $a\n- b\n- c$ is\n",
    "T\n:   $$x = 3$$\n",
    "T\n:   | m |\n    |---|\n    | 1 |\n",
    "So[^1].\n\n[^1]:\n    - a\n    - b\n",
    "<pre>\nYou need:\n- a\n- b\n</pre>\n",
    "<div>\nYou need:\n- a\n- b\n</div>\n",
    "|| a | b |\n|--|---|---|\n| 1 | 2 | 3 |\n",
    "- a\n\n        - x\n",
    "Really![^1] (see fig.png) and ![1] (p. 3 of a.pdf)\n",
    "---\ntags:\n  - a\n  - b\n---\n\n# A\n",
]  # fmt: skip


def _page(text: str) -> str:
    return Markdown(
        extensions=[*EXTENSIONS], extension_configs={k: dict(v) for k, v in EXTENSIONS.items()}
    ).convert(text)


def _depth(page: str) -> int:
    """How many lists are inside one another."""
    steps = [-1 if one.startswith("</") else 1 for one in re.findall(r"</?[uo]l\b", page)]
    return max(accumulate(steps), default=0)


@pytest.mark.parametrize(("text", "place", "hint"), SLIPS)
def test_what_the_page_would_print_as_it_stands_is_a_warning(
    tmp_path: Path, text: str, place: str, hint: str
) -> None:
    (tmp_path / "a.md").write_text(text, encoding="utf-8")
    (found,) = check_paths([tmp_path / "a.md"], tmp_path)
    assert str(found).startswith(f"a.md:{place}: warning: ")
    assert hint in found.hint
    signs = text.splitlines()[found.line - 1][found.col - 1 :][:2].replace("$$", "$")
    assert signs in re.sub(r"<[^>]*>", "", _page(text))


@pytest.mark.parametrize("text", FLAT)
def test_a_list_that_would_not_be_inside_another_is_a_warning(text: str) -> None:
    (found,) = markdown_slips(text, "a.md")
    assert "beside the line above, not inside it" in found.message
    spaces = re.search(r"with (\d) spaces", found.hint)
    assert spaces
    lines = text.split("\n")
    for k in range(found.line - 1, len(lines)):
        if lines[k].startswith("  ") and lines[k].index("-") == found.col - 1:
            lines[k] = " " * int(spaces[1]) + lines[k].lstrip()
    mended = "\n".join(lines)
    assert markdown_slips(mended, "a.md") == []
    assert _depth(_page(mended)) > _depth(_page(text))


@pytest.mark.parametrize("text", RIGHT)
def test_what_the_page_shows_as_it_was_meant_is_no_slip(text: str) -> None:
    assert markdown_slips(text, "a.md") == []


HOSTILE = ["![a](b ", "![", "<!--", "|a", "| ", "- a\n1. b\n", "<div>", "$", "    so\n\n"]


@pytest.mark.parametrize("part", HOSTILE)
def test_no_text_keeps_the_check_busy(part: str) -> None:
    """Some regular expressions took the square or the cube of a line's length."""
    text = part * (20_000 // len(part))
    with budget(BUSY):
        markdown_slips(f"!!! note\n{text}x\n", "a.md")
