"""Stores without a browser: earlier answers, what was refused, and whose keys are told."""

from __future__ import annotations

from typing import Any

from tests.web.scene.given.widget_site import in_node

OLD: dict[str, Any] = {"id": "q", "hash": "a", "type": "single", "value": "x", "last": "1"}
NEW: dict[str, Any] = {**OLD, "hash": "b", "value": "y", "last": "2"}
TEXTS = """const methods = {
  getItem(key) { return this[key] ?? null; },
  setItem(key, text) { this[key] = text; },
  removeItem(key) { delete this[key]; },
};
globalThis.localStorage = Object.create(methods);
globalThis.document = { documentElement: { dataset: {}, lang: "en" } };
const { keptAsText } = await import(source + "/store/text-store.js");
const { sheltered } = await import(source + "/store/shelter.js");
const { forStudent } = await import(source + "/store/storage.js");
const { STUDENT } = await import(source + "/shared/code-word.js");
const store = keptAsText("s");
"""


def test_an_answer_to_an_older_question_stays_among_the_earlier_ones_as_text_too() -> None:
    script = "for (const one of data) await store.put('q', one); give(await store.get('q'));"
    kept = in_node(TEXTS + script, [OLD, NEW])
    assert (kept["value"], kept["earlier"]) == ("y", [OLD])


def test_what_the_browser_refused_is_told_with_what_it_kept() -> None:
    """So that it is in the file which a student saves."""
    script = """await store.put("kept", data[0]);
    const full = { ...store, put: () => Promise.reject(new Error("full")) };
    const safe = sheltered(full, "s");
    const refused = await safe.put("refused", data[1]).catch((error) => error.message);
    give([refused, (await safe.entries()).map(([key]) => key)]);"""
    assert in_node(TEXTS + script, [OLD, NEW]) == ["full", ["kept", "refused"]]


def test_a_student_is_told_of_their_own_keys_alone() -> None:
    script = """for (const key of ["p#q", "@FOX/p#q", STUDENT]) await store.put(key, { value: 1 });
    const told = async (code) => (await forStudent(store, code).entries()).map(([key]) => key);
    give([await told(""), await told("FOX"), await told("OWL")]);"""
    assert in_node(TEXTS + script, None) == [["p#q"], ["p#q"], []]
