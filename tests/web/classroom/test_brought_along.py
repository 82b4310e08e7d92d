"""The keys that a site brings along for its page for teachers, as that page puts them together."""

from __future__ import annotations

import json
from typing import Any

from sim.pages.classroom.practice_keys import keys_script
from tests.classroom.given.site_keys import brought, in_full
from tests.web.scene.given.widget_site import in_node

PUT = "import(`${source}/class/brought-along.js`).then((made) => give(made.inFull(data)));"


def key(lesson: str, *asks: str) -> dict[str, Any]:
    items = [{"id": f"{n}", "ask": ask, "least": 1.0} for n, ask in enumerate(asks)]
    return {"lesson": lesson, "forms": [{"items": items}]}


def test_a_translation_is_brought_as_its_texts_alone_and_the_page_has_its_whole_key() -> None:
    told = key("bumps", "“Hard”?", 'He says: "\\(x\\)"\n<b>.', "Same.")
    keys = [
        key("bumps", "„Keras“?", 'Katanya: "\\(y\\)"\n</b>.', "Same."),
        key("bumps", "碰撞", ""),  # made before the lesson had its third question
        key("other", "Else?"),
        told,
    ]
    given = brought(keys_script(keys).decode())["__cartsKeys"]
    assert [type(one) for one in given] == [list, str, str, str]
    assert given[0][0] == 3 and "Same." not in given[0]
    whole = in_node(PUT, given)
    assert [json.loads(text) for text in whole] == keys
    assert all("1.0" in text for text in whole)  # numbers stay as they are written
    assert list(map(json.loads, in_full(given))) == keys
