"""What was kept as text while the database was closed goes into it, and nothing is lost by that."""

from __future__ import annotations

from typing import Any

from tests.web.question.node_page import on_page

DATABASE = """
const { keepEarlier } = await load("answers/entry.js");
const { instead, takeTexts } = await load("store/brought-over.js");
const { textStore } = await load("store/text-store.js");
const base = new Map(data.base);
const store = {
  get: async (key) => base.get(key),
  put: async (key, value) => void base.set(key, keepEarlier(base.get(key), value)),
};
for (const [key, value] of data.texts) {
  localStorage.setItem(`carts:tests:${key}`, JSON.stringify(value));
}
"""
TAKE = """
await takeTexts(store, "tests");
give({ base: [...base], texts: (await textStore("tests").entries()).map(([key]) => key) });
"""


def entry(value: str, hour: int, **more: Any) -> dict[str, Any]:
    time = f"2026-11-21T{hour:02}:00:00.000Z"
    return {"id": "why", "type": "free", "hash": "", "value": value, "last": time, **more}


def taken(base: dict[str, Any], texts: dict[str, Any]) -> tuple[dict[str, Any], list[str]]:
    """What the database holds afterwards, and what is still kept as text."""
    data = {"base": list(base.items()), "texts": list(texts.items())}
    found = on_page(DATABASE + TAKE, data)
    return dict(found["base"]), found["texts"]


def test_of_two_answers_the_later_counts_and_the_other_is_kept() -> None:
    for one, other in ((8, 9), (9, 8)):
        base, texts = taken({"p#why": entry("a", one)}, {"p#why": entry("b", other)})
        later, earlier = ("b", "a") if other > one else ("a", "b")
        assert base["p#why"]["value"] == later
        assert [each["value"] for each in base["p#why"]["earlier"]] == [earlier]
        assert texts == []


def test_what_the_database_does_not_know_goes_into_it() -> None:
    base, texts = taken({}, {"p#why": entry("b", 9), "@FOX/p#why": entry("c", 9)})
    assert {key: each["value"] for key, each in base.items()} == {"p#why": "b", "@FOX/p#why": "c"}
    assert texts == []


def test_a_locked_prediction_stays_locked() -> None:
    locked = entry("equal", 8, locked="2026-11-21T08:00:00.000Z")
    base, _ = taken({"p#why": locked}, {"p#why": entry("larger", 9)})
    assert (base["p#why"]["value"], base["p#why"]["locked"]) == ("equal", locked["locked"])
    assert "larger" in [each["value"] for each in base["p#why"]["earlier"]]


def test_readings_of_both_stay_where_they_are() -> None:
    base, texts = taken({"p#cart": {"files": ["a.csv"]}}, {"p#cart": {"files": []}})
    assert base == {"p#cart": {"files": ["a.csv"]}}
    assert texts == ["p#cart"]


def test_who_worked_here_works_here_while_the_database_is_closed() -> None:
    student = {"code": "FOX", "last": "2026-11-21T08:00:00.000Z"}
    script = """
await takeTexts(store, "tests");
const kept = await instead(textStore("tests"), "tests");
const here = await kept.get("student");
await takeTexts(store, "tests");
give([kept.behind, here.code, base.get("student"), (await kept.entries()).length]);
"""
    data = {"base": [["student", student]], "texts": []}
    assert on_page(DATABASE + script, data) == [True, "FOX", student, 0]


def test_where_there_never_was_a_database_nothing_is_missed() -> None:
    script = """give((await instead(textStore("tests"), "tests")).behind ?? false);"""
    assert on_page(DATABASE + script, {"base": [], "texts": []}) is False


def test_a_full_storage_gives_back_what_lies_in_it() -> None:
    full = """
const setItem = () => { throw new Error("QuotaExceededError"); };
const get = (it, key) => (key === "setItem" ? setItem : it[key]);
globalThis.localStorage = new Proxy(localStorage, { get });
"""
    given = {"base": [], "texts": [["p#why", entry("kept", 9)]]}
    look = 'await takeTexts(store, "tests");\ngive([base.get("p#why")?.value, textStore("tests")]);'
    assert on_page(DATABASE + full + look, given) == ["kept", None]


def test_a_browser_that_lets_nobody_look_has_kept_nothing() -> None:
    closed = (
        'Object.defineProperty(globalThis, "localStorage", { get() { throw new Error("no"); } });'
    )
    look = '\nawait takeTexts(store, "tests");\ngive([...base]);'
    assert on_page(DATABASE + closed + look, {"base": [], "texts": []}) == []
