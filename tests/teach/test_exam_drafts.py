"""The draft of a test belongs to the file that it began from; another file shows nothing of it."""

from __future__ import annotations

from typing import Any

from tests.teach.session_in_node import at_work

EXAM = """\
# Test of forces

```quiz
id: post
mode: exam
title: After
open: {word: FALCON}
```

Last.
"""
DRAFT = EXAM.replace("Last.", "Least.").replace("FALCON", "EAGLE")
NEWER = EXAM.replace("title: After", "title: After the lessons")


def opened(own: str, *, published: str = "") -> dict[str, Any]:
    """What is there when this file is opened where a draft that began from EXAM is kept."""
    return dict(
        at_work(
            """
            const hash = data.published ? await hashOf(data.published) : "published";
            kept.set(`${page()}#${hash}`, { ...data.draft, last: "2026-01-01", hash });
            await begin(null, hash);
            await session.open();
            await choose(data.own);
            await turn(100);
            const { text } = session;
            const rows = all(".carts-teach-earlier").length;
            session.change(`${text}More.`, "");
            await turn(300);
            const drafts = [...kept.values()].map((draft) => draft.text);
            give({ text, rows, drafts, told: session.panel.root.textContent });
            """,
            own=own, draft={"text": DRAFT, "base": EXAM}, published=published,
        )
    )  # fmt: skip


def test_the_draft_comes_back_with_the_file_that_it_began_from() -> None:
    for published in ("", EXAM):
        said = opened(EXAM, published=published)
        assert (said["text"], said["rows"]) == (DRAFT, 0)
        assert said["drafts"] == [f"{DRAFT}More."]


def test_a_newer_file_is_what_is_shown_and_the_draft_is_offered() -> None:
    said = opened(NEWER)
    assert (said["text"], said["rows"]) == (NEWER, 1)
    assert sorted(said["drafts"]) == sorted([DRAFT, f"{NEWER}More."])  # neither covers the other


def test_the_draft_comes_back_with_the_published_file() -> None:
    said = opened(NEWER, published=NEWER)
    assert (said["text"], said["rows"]) == (DRAFT, 0)


def test_with_any_other_file_nothing_of_the_draft_is_shown() -> None:
    for other in ("", "# Test of forces\n", EXAM.replace("FALCON", "?"), "# Something else\n"):
        said = opened(other)
        assert (said["text"], said["rows"]) == (other, 0)
        assert "EAGLE" not in said["told"] and "FALCON" not in said["told"]
        assert DRAFT in said["drafts"]  # it waits for its file
