"""A `law` block: what stands in the page without a script, what it needs, an author's mistakes."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from sim.mine.arguments import ARGUMENTS
from sim.pages.blocks.bake import OWN_LAW, bake
from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson
from sim.pages.head.page_head import Needs, finish
from sim.pages.runtime import OWN_LAW as PACKED
from sim.pages.runtime.ours import read_ours, read_own_law
from sim.scene import read_fence
from tests.mine.laws import SPRING
from tests.web.figures.law_site import BODY, element
from tests.web.runtime.boot_site import ROOT

EDITOR = (ROOT / "sim" / "web" / "src" / "law" / "editor.js").read_text(encoding="utf-8")
START = "start: |\n  def force(overlap, rate):\n      return 100 * overlap\n"
OWN_PAIR = "contact: {pairs: {A-B: {law: bumper, stiffness: 100 N/m}}}\n"
SCENE = """\
id: with-a-file
carts:
  A: {mass: 2.0 kg, position: 0.40 m, velocity: 0.40 m/s}
  B: {mass: 0.5 kg, position: 1.20 m}
contact: {law: mine.py, stiffness: 150 N/m}
until: 3 s
"""


def findings(block: str, folder: Path | None = None, kind: str = "law") -> list[tuple[int, str]]:
    lesson = Lesson("page.md", (folder,) if folder else ())
    found = check_lesson(f"# A page\n\n```{kind}\n{block}```\n", lesson, SiteIds())
    return [(one.line, f"{one.message} {one.hint}") for one in found]


def test_the_law_stands_in_the_page_as_code_and_its_run_with_it() -> None:
    made, page = element()
    assert "<pre><code>def force(overlap, rate):\n    return 100 * overlap\n</code></pre>" in made
    found = re.search(r'carts-law-baked">(.*?)</script>', made, re.DOTALL)
    assert found is not None
    facts = json.loads(found[1])
    assert facts["baked"]["final"]["v"]["B"] == pytest.approx(0.64)
    assert facts["start"] in facts["baked"]["fence"]["scene"]["laws"].values()
    assert page.packages == {OWN_LAW}
    (item,) = page.items.outline("page")["items"]
    assert item == {"id": "my-law", "hash": facts["hash"], "type": "law", "form": "worksheet",
                    "level": "core"}  # fmt: skip


def test_a_page_without_a_law_has_no_byte_of_it() -> None:
    ours = {name for name, _ in read_ours(ROOT / "sim", "0").files}
    own = {name for name, _ in read_own_law(ROOT / "sim", "0").files}
    assert not ours & own
    assert not [name for name in ours if name.startswith("sim/mine/")]
    assert "sim/bridge/law_answer.py" in own
    pages = [
        finish("<head></head><body></body>", audience="offline", site_id="site", page_id="page",
               assets="assets/carts/", needs=needs, trusted=[])
        for needs in (Needs(scenes=True), Needs(law=True))
    ]  # fmt: skip
    assert ["law.js" in page for page in pages] == [False, True]
    assert PACKED == OWN_LAW


def test_the_page_names_the_arguments_that_a_law_may_have() -> None:
    listed = re.search(r"ARGUMENTS = \[(.*?)\]", EDITOR, re.DOTALL)
    assert listed is not None
    assert re.findall(r'"(\w+)"', listed[1]) == list(ARGUMENTS)


def test_a_law_in_a_file_beside_the_lesson_is_taken_by_both_kinds_of_blocks(tmp_path: Path) -> None:
    (tmp_path / "mine.py").write_text(SPRING.replace("overlap\n", "overlap  # in a file\n"))
    for kind in ("law", "scene"):
        assert findings(SCENE, tmp_path, kind) == []
        ((line, words),) = findings(SCENE, None, kind)
        assert line == 8
        assert "there is no text of the law mine.py" in words


def test_a_scene_with_such_a_law_carries_its_text_and_its_package() -> None:
    plain = {
        "id": "one",
        "carts": {
            "A": {"mass": 1, "position": 0.4, "velocity": 0.5},
            "B": {"mass": 1, "position": 1},
        },
        "contact": {"law": "mine.py", "stiffness": 200},
        "laws": {"mine.py": SPRING},
    }
    run = bake(read_fence(plain).plain)
    assert not isinstance(run, list)
    assert run.packages == {OWN_LAW}
    assert run.header["final"]["v"] == pytest.approx({"A": 0.0, "B": 0.5}, abs=1e-6)


@pytest.mark.parametrize(
    ("change", "line", "words"),
    [
        ((":\n      return", "\n      return"), 7, "line 1: this is not"),
        (("100 * overlap", "100 * x"), 8, "line 2: NameError"),
        ((START, ""), None, "begins with"),
        (("id: my-law\n", ""), None, "id is missing"),
        (("  B: {mass: 0.5 kg, position: 1.20 m}\n", ""), 6, "no two carts of this scene push"),
        (("until: 3 s", OWN_PAIR + "until: 3 s"), 6, "no two carts of this scene push"),
        (("ask: Let the heavier one push harder.", "ask: 7"), 5, "ask is a text"),
        (("until: 3 s", "unti: 3 s"), 12, "unti"),
    ],
)
def test_an_authors_mistake_is_told_with_its_line(
    change: tuple[str, str], line: int | None, words: str
) -> None:
    found = findings(BODY.replace(*change))
    assert any(words in text for _, text in found), found
    assert line is None or line in [place for place, _ in found], found
