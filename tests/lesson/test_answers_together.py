"""Two versions of an answer, from two tabs or from a file, come together without loss."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sim.lesson.answer_file import read_answer_file
from tests.web.question.node_page import on_page

VECTORS = json.loads((Path(__file__).parent / "answers_together.json").read_text(encoding="utf-8"))
LOCKED: dict[str, Any] = {
    "id": "s1", "hash": "0123456789ab", "type": "choice", "form": "worksheet", "lesson": "l",
    "lessonHash": "0123456789ab", "value": "a", "first": "2026-01-01T10:00:00.000Z",
    "last": "2026-01-01T10:00:00.000Z", "tries": 1, "said": "A", "asked": "?",
    "locked": "2026-01-01T10:00:01.000Z",
}  # fmt: skip
EXPLAINED = {**LOCKED, "why": "because of inertia", "now": "b", "watched": LOCKED["last"]}
FILE = """const { makeFiles, readFile } = await load("answers/file.js");
const file = (entry) => makeFiles([["p#s1", entry]], { site: "tests", student: "" },
  "2026-01-01T11:00:00.000Z")[0].content;
"""
BOOK = """const { Book } = await load("answers/book.js");
const book = new Book();
await book.ready;
"""


@pytest.mark.parametrize("vector", VECTORS, ids=lambda vector: str(vector["law"]))
def test_two_versions_come_together_as_is_written(vector: dict[str, Any]) -> None:
    script = """const entry = await load("answers/entry.js");
    give(entry[data.do](data.old, data.new));"""
    assert on_page(script, vector) == vector["gives"]


def test_an_older_file_takes_no_explanation_away() -> None:
    script = f"""{FILE}{BOOK}
    await book.store.put("p#s1", data.here);
    const {{ entries }} = readFile(JSON.stringify(file(data.before)), "tests");
    const changed = await book.take("", entries);
    give([changed, await book.store.get("p#s1")]);"""
    changed, kept = on_page(script, {"here": EXPLAINED, "before": LOCKED})
    assert (changed, kept) == (0, EXPLAINED)


def test_a_file_has_the_same_question_once_more_and_both_read_it() -> None:
    script = f"""{FILE}
    const content = file(data);
    give([content, readFile(JSON.stringify(content), "tests").entries]);"""
    content, ((_, entry),) = on_page(script, EXPLAINED)
    assert entry["now"] == "b"
    (item,) = read_answer_file(json.dumps(content)).items
    assert item.more["now"] == "b"


def test_an_answer_that_was_cleared_comes_back_from_a_file_and_stays() -> None:
    def answer(value: str, hour: int) -> dict[str, Any]:
        times = {"first": "2026-01-01T09:00:00Z", "last": f"2026-01-01T{hour}:00:00Z"}
        return {"id": "q1", "hash": "0123456789ab", "type": "long", "value": value, "tries": 0,
                "form": "worksheet", **times}  # fmt: skip

    script = f"""{BOOK}
    const [written, cleared, more] = data;
    await book.put("worksheet", written);
    await book.put("worksheet", cleared);
    await book.take("", [["p#q1", written]]);
    const shown = book.get("worksheet", "q1").value;
    await book.refresh();
    give([shown, book.get("worksheet", "q1").value, (await book.store.get("p#q1")).value]);"""
    data = [answer("my long text", 10), answer("", 11), answer("x", 12)]
    assert on_page(script, data) == ["my long text"] * 3


def test_what_one_tab_keeps_the_other_hears_and_only_of_its_own_student() -> None:
    script = """const one = await load("store/storage.js");
    const other = await load("store/storage.js?other");
    const heard = [];
    (await other.openStore("tests")).hear((key) => heard.push(key));
    const all = await one.openAll("tests");
    await one.forStudent(all, "RED-OWL-27").put("p#theirs", { value: "a" });
    await one.forStudent(all, "").put("p#s1", { value: "a" });
    await new Promise((done) => setTimeout(done, 200));
    give(heard);"""
    assert on_page(script) == ["p#s1"]


def test_readings_and_drafts_are_no_answers_where_the_browser_keeps_nothing() -> None:
    script = f"""refuseTexts();
    const storage = await load("store/storage.js");
    await (await storage.openAll("tests" + storage.READINGS)).put("p/bench", {{ texts: [] }});
    await (await storage.openAll("tests~teacher")).put("p#hash", {{ text: "" }});
    {BOOK}
    await book.put("worksheet", {{ id: "q1", value: "a" }});
    give([book.store.kind, (await book.store.entries()).map(([key]) => key)]);"""
    assert on_page(script) == ["memory", ["p#q1"]]


def test_a_curve_that_is_changed_leaves_the_one_of_before() -> None:
    script = """const box = () => Object.assign(new EventTarget(), { value: "" });
    const part = { getAttribute: () => null, setAttribute() {} };
    const found = { querySelector: () => part, querySelectorAll: () => [] };
    const pad = Object.assign(new EventTarget(), found);
    const boxes = data.map(box);
    const root = { querySelector: () => pad, querySelectorAll: () => boxes };
    const { CurveForm } = await load("predict/curve.js");
    const form = new CurveForm(root, { cart: "A", quantity: "F" }, () => {});
    const type = (k, height) => {
      boxes[k].value = String(height);
      boxes[k].dispatchEvent(new Event("input"));
    };
    data.forEach((height, k) => type(k, height));
    const before = form.value;
    type(0, 4);
    const kept = form.value;
    form.value = kept;
    type(1, 9);
    give([before, kept]);"""
    assert on_page(script, [0, 1, 2, 3, 4]) == [[0, 1, 2, 3, 4], [4, 1, 2, 3, 4]]


def test_a_law_that_is_begun_again_stays_among_the_earlier_ones() -> None:
    script = """const { lawKeeper } = await load("law/keep.js");
    const { openStore } = await load("store/storage.js");
    const keeper = lawKeeper({ id: "own", hash: "0123456789ab", ask: "?" });
    await keeper.get();
    await keeper.put("an hour of work");
    keeper.setAside();
    await keeper.put("start");
    const { value, earlier } = await (await openStore("tests")).get("p#own");
    give([value, earlier.map((one) => one.value)]);"""
    assert on_page(script) == ["start", ["an hour of work"]]


def test_one_size_is_too_large_before_and_after_a_file_is_read() -> None:
    script = """const { readFile, tooLarge } = await load("answers/file.js");
    const most = 2_000_000;
    const seen = [tooLarge(most), tooLarge(most + 1), readFile(" ".repeat(most + 1), "tests")];
    give(seen.map((one) => one?.problem ?? ""));"""
    fits, large, read = on_page(script)
    assert (fits, large) == ("", read)
    assert "too large" in read


def test_a_reader_who_answers_a_hundred_times_keeps_each_of_the_answers() -> None:
    script = """const { setAside } = await load("answers/entry.js");
    const answers = [...Array(100).keys()].map((k) => ({ hash: "h", value: `${k}`, last: `${k}` }));
    const kept = answers.reduce((old, one) => setAside({ ...one, earlier: old.earlier }), {});
    give(kept.earlier.length);"""
    assert on_page(script, None) == 100
