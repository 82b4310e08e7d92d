"""The built site: exams without their key, answers out of the search, light pages of questions."""

from __future__ import annotations

import html
import json
import re
from pathlib import Path

import pytest

from sim.lesson.beliefs import BELIEFS
from sim.pages.question.quiz import read_bank_text
from sim.pages.text.fence_scan import scan
from sim.pages.text.front_matter import lesson_order
from sim.pages.text.yaml.source import load

pytestmark = pytest.mark.slow  # builds the site

ROOT = Path(__file__).parents[2]
TEST = Path("worksheets") / "test-forces-and-motion.html"


def test_no_key_of_the_exam_is_anywhere_in_the_site(site: Path) -> None:
    text = (ROOT / "worksheets" / "banks" / "forces-and-motion.yml").read_text(encoding="utf-8")
    bank = read_bank_text(text, "bank")[0]
    assert bank is not None
    secrets = [bank.note]
    for item in bank.items.values():
        secrets += [item.common.note, item.common.explain, *item.feedback().values()]
        secrets += getattr(item, "rubric", {}).values()
    snippets = {" ".join(secret.split())[:40] for secret in secrets if secret}
    assert len(snippets) > 15
    for path in site.rglob("*"):
        if path.suffix in (".html", ".json", ".js", ".txt") and "runtime" not in path.parts:
            words = " ".join(html.unescape(path.read_text(encoding="utf-8")).split())
            assert [s for s in snippets if s in words] == [], path.name
    page = (site / TEST).read_text(encoding="utf-8")
    quizzes = "".join(re.findall(r"<carts-quiz.*?</carts-quiz>", page, re.DOTALL))
    assert quizzes.count("<carts-question") == 38
    for word in ("correct", "belief", '"key"', "<template", *BELIEFS):
        assert word not in quizzes, word
    assert list(site.rglob("*.yml")) == []


def test_the_search_finds_no_question_of_a_form_and_no_feedback(site: Path) -> None:
    index = json.loads((site / "search" / "search_index.json").read_text(encoding="utf-8"))
    words = " ".join(entry["text"] for entry in index["docs"])
    assert "curling stone" not in words
    assert "Compare p of A before and after" not in words


def test_every_question_of_a_lesson_is_in_its_page_and_its_outline(site: Path) -> None:
    for lesson in (ROOT / "worksheets").glob("*.md"):
        page = (site / "worksheets" / f"{lesson.stem}.html").read_text(encoding="utf-8")
        found = re.search(r'<script type="application/json" id="carts-lesson">(.*?)</script>', page)
        assert found, lesson
        outline = json.loads(found[1])
        assert outline["lesson"] == lesson.stem
        known = {item["id"] for item in outline["items"]}
        for block in scan(lesson.read_text(encoding="utf-8").splitlines()):
            if block.name == "question":
                identity = load(block.body).plain["id"]
                assert f'<carts-question id="{identity}"' in page
                assert identity in known


def test_lessons_stand_in_their_order_and_the_rest_behind_them(tmp_path: Path) -> None:
    heads = {"b": "---\norder: 2\n---\n", "c": "---\ntitle: C\norder: 1\n---\n", "a": "order: 1\n"}
    for name, head in heads.items():
        (tmp_path / f"{name}.md").write_text(f"{head}# {name}\n", encoding="utf-8")
    ordered = sorted(tmp_path.glob("*.md"), key=lesson_order)
    assert [path.stem for path in ordered] == ["c", "b", "a"]


def test_a_page_of_questions_alone_loads_no_scene_and_no_python(site: Path) -> None:
    page = (site / TEST).read_text(encoding="utf-8")
    assert "answers.js" in page
    assert "carts/carts.js" not in page
    assert "carts/runtime" not in page
