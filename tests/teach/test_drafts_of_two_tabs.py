"""Two tabs of teacher mode: neither covers the draft of the other."""

from __future__ import annotations

from tests.teach.session_in_node import at_work

LESSON = "# Title\n\nLast."
BEGUN = """
const key = `${page()}#published`;
const draft = (text, last) => ({ text, base: data.lesson, last, hash: "published" });
const rows = () => all(".carts-teach-earlier").map(({ textContent }) => textContent);
const texts = () => [...kept.values()].map(({ text }) => text).sort();
"""


def test_what_another_tab_keeps_stays_and_is_offered() -> None:
    said = at_work(
        BEGUN
        + """
        kept.set(key, draft("Begun.", "2026-01-01T10:00:00Z"));
        await begin(data.lesson);
        await session.open();
        await otherKeeps(key, draft("Theirs.", "2026-01-01T11:00:00Z"));
        await otherKeeps(key, draft("Theirs, longer.", "2026-01-01T11:01:00Z"));
        session.change("Mine.", "", 0);
        await turn(30);
        const before = texts();
        const offered = rows();
        press(".carts-teach-older");
        await turn(30);
        give({ before, offered, opened: session.text, mine: session.drafts.key !== key });
        """,
        lesson=LESSON,
    )  # fmt: skip
    assert said["before"] == ["Mine.", "Theirs, longer."]
    assert len(said["offered"]) == 1 and "another draft of this lesson" in said["offered"][0]
    assert said["opened"] == "Theirs, longer."
    assert said["mine"]


def test_what_another_tab_has_covered_is_kept_again() -> None:
    said = at_work(
        BEGUN
        + """
        await begin(data.lesson);
        await session.open();
        session.change("Mine.", "", 0);
        await turn(30);
        await otherKeeps(key, draft("Theirs.", "2026-01-01T11:00:00Z"));
        await turn(30);
        give(texts());
        """,
        lesson=LESSON,
    )  # fmt: skip
    assert said == ["Mine.", "Theirs."]


def test_the_newest_draft_comes_back_and_the_other_is_offered() -> None:
    said = at_work(
        BEGUN
        + """
        kept.set(key, draft("Older.", "2026-01-01T10:00:00Z"));
        kept.set(`${key}~other`, draft("Newer.", "2026-01-01T11:00:00Z"));
        await begin(data.lesson);
        await session.open();
        const begun = [session.text, rows().length];
        session.reset();
        await turn(30);
        give([...begun, texts()]);
        """,
        lesson=LESSON,
    )  # fmt: skip
    assert said == ["Newer.", 1, ["Older."]]


def test_the_draft_of_another_test_is_not_offered_beside_a_file() -> None:
    said = at_work(
        """
        const exam = (word) => "# Test\\n\\n```quiz\\nopen: {word: " + word + "}\\n```\\n";
        const rows = () => all(".carts-teach-earlier").length;
        await begin(null);
        await session.open();
        const other = { text: "x", base: exam("EAGLE"), last: "2026-01-01", hash: "published" };
        await otherKeeps(session.drafts.key, other);
        const before = rows();
        await choose(exam("FALCON"));
        await turn(50);
        await otherKeeps(session.drafts.key, other);
        give([before, rows(), session.panel.root.textContent.includes("EAGLE")]);
        """
    )
    assert said == [0, 0, False]
