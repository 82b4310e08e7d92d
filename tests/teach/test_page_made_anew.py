"""The page in teacher mode: what no text makes stays, and the published lesson comes back whole.

Python's looks are the real ones; the page is a document of linkedom in Node.js.
"""

from __future__ import annotations

from typing import Any

import markdown
import pytest

from sim.pages.blocks.extension import CartsExtension, Page, set_page
from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson
from sim.pages.teach import answer as wire
from sim.pages.teach.answer import teach_answer
from sim.pages.teach.preview import Desk
from tests.conftest import ROOT
from tests.web.scene.given.widget_site import in_node

LESSON = Lesson("docs/a.md", (ROOT / "tests" / "scenes",))
SCENE = """\
```scene
id: one
carts: {A: {mass: 1 kg, position: 0.4 m, velocity: 0.5 m/s}}
controls: [{set: A.mass, from: 1 kg, to: 2 kg, step: 1 kg}]
until: 2 s
predict: {text: What}
```
"""
CHALLENGE = "```challenge\nscene: one\nask: Make it {}.\ngoal: v.A = 0\n```\n"
PICTURE = "```picture\nfile: light-meets-heavy.yml\n```\n"
TEXT = (
    f"# Title\n\nFirst.\n\n{SCENE}\n!!! after\n    Told.\n\n"
    f"{CHALLENGE.format('stop')}\n{PICTURE}\nLast.\n"
)
PAGE = """<!doctype html><html><body><article class="md-content__inner">\
<a class="md-content__button" href="e">edit</a>{lesson}\
<p class="carts-teach-door"><a href="#teacher">Change</a></p>\
<div class="carts-hosted">home</div></article></body></html>"""
SCRIPT = """
const { parseHTML } = await import("linkedom");
const window = parseHTML(data.page);
globalThis.document = window.document;
globalThis.customElements = { get: () => true };
const { LessonPage } = await import(`${source}/teach/page.js`);
const article = document.querySelector("article");
const page = new LessonPage(article, "file:///a/", () => {});
const clean = () => {
  const copy = article.cloneNode(true);
  for (const row of copy.querySelectorAll(".carts-teach-change")) row.remove();
  return copy.innerHTML.replace(/\\n+/g, "\\n");
};
const built = clean();
const scene = document.getElementById("one");
page.adopt(data.looks[0]);
const seen = [];
for (const look of data.looks.slice(1)) {
  await page.show(look);
  const rows = [...article.querySelectorAll(".carts-teach-change")].map((row) => row.textContent);
  seen.push({ html: clean(), rows, same: document.getElementById("one") === scene });
}
give({ built, seen });
"""


@pytest.fixture(autouse=True)
def at_a_new_desk(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(wire, "_desk", Desk())
    monkeypatch.setattr(wire, "_lay_out", lambda *_: None)


def built(text: str) -> str:
    page = Page(LESSON)
    set_page(page)
    made = markdown.markdown(text, extensions=["admonition", CartsExtension()])
    set_page(None)
    lines = '</h1>\n<p class="carts-languages">Deutsch</p>\n<p class="carts-draft">a draft</p>\n'
    return PAGE.format(lesson=made.replace("</h1>", lines, 1))


def look(text: str, have: list[str], *, right: bool = True) -> dict[str, Any]:
    told = {"file": "docs/a.md", "scenes": [str(LESSON.scene_folders[0])],
            "extensions": ["admonition"]}  # fmt: skip
    answer = teach_answer({"do": "look", "text": text, "lesson": told, "have": have})[0]
    assert (not answer["findings"] and not answer["more"]) or not right
    return answer


def shown(*texts: str, wrong: tuple[str, ...] = (), slow: str = "") -> dict[str, Any]:
    """What stands in the page after each of these texts; its own is that of TEXT. Those in `wrong`
    have mistakes; `slow` is looked at once more before, when the time was over at once."""
    assert check_lesson(TEXT, LESSON, SiteIds()) == []
    first = look(TEXT, [])
    have = [block["key"] for block in first["blocks"] if "key" in block]
    looks = [first]
    for text in texts:
        if text == slow:
            with pytest.MonkeyPatch.context() as patch:
                patch.setattr(wire, "SLICE", 0)
                looks.append(look(text, have, right=False))
            assert looks[-1]["more"]
        looks.append(look(text, have, right=text not in wrong))
        assert bool(looks[-1]["findings"]) == (text in wrong)
    return dict(in_node(SCRIPT, {"page": built(TEXT), "looks": looks}))


def test_what_no_text_makes_stays_in_its_place() -> None:
    (one,) = shown(TEXT.replace("First", "*First*"))["seen"]
    html = one["html"]
    order = ["md-content__button", "<h1", "carts-languages", "carts-draft", "<em>First",
             "<carts-scene", "<carts-after", "<carts-challenge", "carts-picture", "Last.",
             "teach-door", "carts-hosted"]  # fmt: skip
    places = [html.find(mark) for mark in order]
    assert -1 not in places, dict(zip(order, places, strict=True))
    assert places == sorted(places)
    assert "Seen after the build" not in html
    assert one["same"]  # with its run and its settings


def test_the_published_text_brings_the_built_page_back() -> None:
    other = TEXT.replace("First", "*First*").replace("mass: 1 kg, pos", "mass: 2 kg, pos")
    made = shown(other, other.replace("Last", "*Last*"), TEXT, other, TEXT)
    first, _, again, _, last = made["seen"]
    assert first["html"] != made["built"]
    assert again["html"] == last["html"] == made["built"]
    assert again["same"] and last["same"]


def test_a_changed_challenge_is_shown_and_a_picture_stays() -> None:
    changed = TEXT.replace("Make it stop", "Make it *rest*")
    one, two = shown(changed, changed.replace(SCENE, f"{SCENE}\nMore text.\n"))["seen"]
    for seen in (one, two):
        assert "<em>rest</em>" in seen["html"] and "Make it stop" not in seen["html"]
        assert "carts-picture" in seen["html"]
        assert len(seen["rows"]) == 3
        assert "Change this challenge" in seen["rows"]


def test_a_block_that_is_new_takes_no_place_of_another() -> None:
    new = TEXT.replace("First.\n", f"First.\n\n{PICTURE}\n")
    (one,) = shown(new)["seen"]
    assert one["html"].count("carts-picture") == 1
    assert one["html"].count("Seen after the build") == 1
    assert one["same"]


NEW = SCENE.replace("id: one", "id: two").replace("predict: {text: What}\n", "")
MORE = TEXT.replace("First.\n", f"First.\n\n{NEW}\n")
AT_END = f"{TEXT}\n{NEW}"


@pytest.mark.parametrize("text", [MORE, AT_END], ids=["in the middle", "at the end"])
def test_a_new_block_is_seen_when_its_mistake_is_mended(text: str) -> None:
    typed = text.replace(NEW, NEW.replace("mass: 1 kg", "mass: -1 kg"))
    seen = shown(typed, typed, text, TEXT, wrong=(typed,))["seen"]
    for wrong in seen[:2]:
        assert wrong["html"].count("Seen when its mistake is mended") == 1
        assert 'id="two"' not in wrong["html"]
        assert "carts-teach-old" not in wrong["html"]
        assert len(wrong["rows"]) == 3  # there is nothing yet to change in the page
    assert 'id="two"' in seen[2]["html"] and "Seen when" not in seen[2]["html"]
    assert len(seen[2]["rows"]) == 4
    assert all(one["same"] for one in seen)


def test_a_new_block_is_seen_when_it_came_later() -> None:
    later, ready = shown(MORE, slow=MORE)["seen"]
    assert 'id="two"' not in later["html"] and "It comes in a moment" in later["html"]
    assert 'id="two"' in ready["html"] and "in a moment" not in ready["html"]


def test_the_built_page_comes_back_when_a_cut_block_was_wrong_in_between() -> None:
    challenge = CHALLENGE.format("stop")
    cut, wrong = TEXT.replace(challenge, ""), TEXT.replace("goal: v.A", "goal: v.Z")
    made = shown(cut, wrong, TEXT, cut, wrong, cut, TEXT, wrong=(wrong,))
    html = [one["html"] for one in made["seen"]]
    assert "carts-challenge" not in html[1] and "Seen when its mistake is mended" in html[1]
    assert html[2] == html[6] == made["built"]


def test_blocks_that_change_their_places_are_both_there() -> None:
    two = TEXT.replace("!!! after\n    Told.\n", NEW).replace(SCENE, f"{SCENE}\nBetween.\n")
    swapped = two.replace(SCENE, "*").replace(NEW, SCENE).replace("*", NEW)
    html = shown(two, swapped, two)["seen"]
    places = [[one["html"].find(f' id="{name}"') for name in ("one", "two")]
              for one in html]  # fmt: skip
    assert all(-1 not in pair for pair in places)
    assert [first < second for first, second in places] == [True, False, True]
