"""The still picture: what the generator writes, without any browser."""

from __future__ import annotations

import json
import re
from html.parser import HTMLParser
from typing import Any

import pytest

from sim.pages.widget import render
from tests.web.scene.given.widget_site import COASTING, FENCES, MEETING, QUESTIONS, STRUCK, baked

MOST_HTML = 60_000  # bytes per scene, promised in issue 2


def page_data(text: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" class="carts-baked">(.*?)</script>', text)
    assert found
    data: dict[str, Any] = json.loads(found[1])
    return data


class _Tags(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.attributes: list[tuple[str, str, str]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.attributes += [(tag, name, value or "") for name, value in attrs]


def tags(text: str) -> list[tuple[str, str, str]]:
    parser = _Tags()
    parser.feed(text)
    return parser.attributes


@pytest.mark.parametrize("name", FENCES)
def test_a_scene_needs_no_inline_style_or_handler_and_stays_small(name: str) -> None:
    text = render(*baked(FENCES[name]))
    for _, attribute, _ in tags(text):
        assert attribute != "style"
        assert not attribute.startswith("on")
    assert "<style" not in text
    assert len(text.encode()) <= MOST_HTML


@pytest.mark.parametrize("name", FENCES)
def test_every_id_is_there_once_and_every_reference_leads_to_one(name: str) -> None:
    found = tags(render(*baked(FENCES[name])))
    ids = [value for _, attribute, value in found if attribute == "id"]
    assert len(ids) == len(set(ids))
    for _, attribute, value in found:
        if attribute in {"for", "aria-labelledby", "aria-describedby"}:
            assert set(value.split()) <= set(ids)
        elif match := re.fullmatch(r"url\(#(.*)\)", value):
            assert match[1] in ids


def test_the_baked_numbers_are_those_of_the_run() -> None:
    _, header, numbers = baked(MEETING)
    data = page_data(render(*baked(MEETING)))
    rows = header["rows"]
    given = data["numbers"]["x"]["A"]
    assert given == pytest.approx(numbers[rows : 2 * rows].tolist(), rel=1e-10, abs=1e-12)
    assert data["events"] == header["events"]
    assert data["fence"]["scene"]["carts"] == MEETING["carts"]


@pytest.mark.parametrize("name", QUESTIONS)
def test_a_scene_that_asks_first_tells_nothing_of_its_run(name: str) -> None:
    _, header, _numbers = baked(QUESTIONS[name])
    text = render(*baked(QUESTIONS[name]))
    data = page_data(text)
    assert data["events"] == []
    assert data["plan"] == []
    assert data["rows"] == 1
    assert all(len(c) == 1 for part in "xv" for c in data["numbers"][part].values())
    assert [data["numbers"][part] for part in ("a", "F", "dF")] == [{}, {}, {}]
    for quantity in "Fa":
        shown = re.findall(rf'class="carts-value" data-quantity="{quantity}">(.*?)<', text)
        assert shown == ["–", "–"]
    for key in ("final", "energy", "momentum", "work", "outcome", "evaluations"):
        assert key not in data
    assert "<td>" not in text
    assert 'class="carts-curve carts-b0" d="M46' not in text
    assert not re.search(r"carts-(event-|contact-band)", text)
    assert 'class="carts-jump"' not in text
    # No number of the run beyond its start that is long enough not to be a coordinate by chance.
    told = [event["t"] for event in header["events"][:-1]]
    told += [event["force"] for event in header["events"] if event["kind"] == "peak"]
    told += list(header["final"]["x"].values()) + list(header["final"]["v"].values())
    for value in told:
        for shown in (f"{abs(value):.4g}", f"{abs(value):.3f}"):
            if len(shown.replace(".", "").strip("0")) >= 3:
                assert not re.search(rf"(?<![\d.]){re.escape(shown)}(?!\d)", text), shown


def test_a_prediction_changes_with_nothing_that_only_the_run_knows() -> None:
    """Two scenes that start alike and differ in what happens bake the same picture."""
    fence, header, numbers = baked(QUESTIONS["arrows"])
    other = dict(header, events=[], plan=[], outcome={"kind": "refused", "sentence": "secret"})
    other["rows"] = 1
    start = numbers[:0]
    for k in range(len(header["columns"])):
        start.append(numbers[k * header["rows"]])
    assert render(fence, header, numbers) == render(fence, other, start)


def test_texts_of_authors_cannot_become_markup() -> None:
    nasty = '</script><script>alert(1)</script> & "quotes" \u2028'
    question = {"ask": nasty, "choice": [nasty, "b"]}
    text = render(*baked({**MEETING, "id": "nasty", "title": nasty, "predict": question}))
    assert text.count("<script") == 1
    assert "alert(1)</script>" not in text
    assert page_data(text)["title"] == nasty


@pytest.mark.parametrize("forces", ["hidden", "none"])
def test_hidden_forces_appear_nowhere(forces: str) -> None:
    text = render(*baked({**MEETING, "id": "secret", "forces": forces}))
    picture = text.split('<script type="application/json"')[0]
    assert ("carts-find" in picture) == (forces == "hidden"), "who shows none, asks for none"
    assert ("carts-shown" in text) == (forces == "hidden"), "nor are they kept for later"
    assert 'class="carts-push' not in picture
    assert 'data-quantity="F"' not in picture
    assert 'data-quantity="a"' not in picture
    assert " N on each" not in picture
    assert "Impulse" not in picture


def test_a_moving_camera_shows_velocities_as_it_sees_them() -> None:
    text = render(*baked(COASTING))
    assert "0.200 m/s" in text  # 0.50 on the track
    assert "camera that moves at 0.30\u00a0m/s to the right" in text


def test_forces_without_duration_say_so() -> None:
    text = render(*baked(STRUCK))
    assert "too large and too short to draw" in text
    assert "2.50\u00a0N\u00a0s" in text
    assert "where v jumps, the acceleration is too large and too short to draw" in text
    assert "A and B hit each other and part at once." in text
    assert "B leaves the picture on the right, still 1.50\u00a0m/s." in text


def story(fence: dict[str, Any]) -> list[str]:
    return re.findall(
        r"<button[^>]*carts-jump.*?</button> <span>(.*?)</span>", render(*baked(fence))
    )


def model(fence: dict[str, Any]) -> list[str]:
    """What is in this model, sentence by sentence."""
    (box,) = re.findall(r'carts-model".*?<ul>(.*?)</ul>', render(*baked(fence)), re.DOTALL)
    return re.findall(r"<li>(.*?)</li>", box)


def test_what_is_in_the_model_is_said_in_the_words_of_a_lesson() -> None:
    """No solver, no law by its key, and no number that a lesson may ask for."""
    told = model(MEETING)
    assert told[1] == "Bumpers push like springs, the harder the more they are squeezed."
    assert model(STRUCK)[1] == "A hit takes no time."
    assert model({**STICKY, "contact": {"law": "velcro"}})[1] == "Whoever touches stays together."
    for fence in (MEETING, STRUCK, STICKY):
        text = " ".join(model(fence))
        assert "keeps its velocity" in text
        assert not re.search(r"law:|exact|series|formula|\d", text)


STICKY: dict[str, Any] = {
    **STRUCK,
    "id": "sticky",
    "carts": {"A": {"mass": 1, "position": "0.4", "velocity": "0.6"},
              "B": {"mass": 2, "position": 1}},
    "until": 2,
}  # fmt: skip


def test_carts_with_velcro_stay_together_in_words() -> None:
    told = story({**STICKY, "contact": {"law": "velcro"}})
    hit = "A and B hit and stay together. Impulse on each: 0.400\u00a0N\u00a0s."
    assert told[0].startswith(hit)
    wall = {**STICKY, "track": {"length": 2, "right": "wall"}, "until": 8}
    told = story({**wall, "contact": {"law": "velcro"}})
    assert told[1].startswith("B and the wall hit and stay together.")
    told = story({**STICKY, "contact": {"law": "instant", "restitution": 0}})
    assert told[0].startswith("A and B hit and go on together at 0.200\u00a0m/s to the right.")


@pytest.mark.parametrize("forces", ["shown", "hidden", "none"])
def test_carts_that_go_on_with_one_velocity_do_not_separate_in_words(forces: str) -> None:
    soft = {**STICKY, "contact": {"law": "bumper", "restitution": 0}, "forces": forces}
    soft |= {"show": ["x", "v"]}
    ended = (
        "The push between A and B has ended; they go on together at 0.200\u00a0m/s to the right."
    )
    assert any(sentence.startswith(ended) for sentence in story(soft))
    moving = story({**soft, "view": "moving 0.2 m/s", "show": ["v"]})
    assert any("has ended; they stay together, at rest." in sentence for sentence in moving)
    assert not any("separate" in sentence for sentence in (*story(soft), *moving))


def test_a_warning_is_there_before_anybody_plays() -> None:
    fast = {
        "id": "fast",
        "carts": {
            "A": {"mass": 4, "position": 0.5, "velocity": 3},
            "B": {"mass": 4, "position": 1.5},
        },
        "track": {"length": 2},
        "until": 1,
    }
    text = render(*baked(fast))
    assert '<div class="carts-warnings"><p>' in text
    assert "squeezed" in text
