"""What a teacher must not miss: what is said of a save, and that a page shows a draft."""

from __future__ import annotations

from tests.teach.session_in_node import at_work

BEGUN = """
globalThis.history = { replaceState() {} };
document.documentElement.className = "carts-runs";
await begin("# block\\nmass: 1\\n\\nText.");
await session.open();
await turn(60);
const heavier = async () => {
  open();
  type(one(".carts-teach-fields input"), "2");
  await turn(800);
};
const line = () => document.querySelector(".carts-teach-draft");
"""


def test_what_is_said_of_a_save_stands_beside_what_scrolls_and_a_warning_looks_like_one() -> None:
    kinds, scrolls = at_work(
        BEGUN
        + """
        const kinds = [];
        const save = async () => {
          press(".carts-teach-save");
          await turn(60);
          kinds.push(one(".carts-teach-status").dataset.kind);
        };
        await save();
        session.change(`${session.text}${KEPT_OUT}\\n`, "");
        await turn(400);
        await save();
        session.look.findings.push({ line: 1, col: 1, file: "docs/a.md", message: "", hint: "" });
        await save();
        const scrolls = [".carts-teach-status", ".carts-teach-state", ".carts-teach-undo"];
        give([kinds, scrolls.filter((name) => one(name).closest(".carts-teach-body"))]);
        """,
    )
    assert kinds == ["", "warning", "fault"]
    assert scrolls == []


def test_a_page_that_is_left_with_a_draft_says_so_and_leads_back() -> None:
    found = at_work(
        BEGUN
        + """
        session.close();
        const found = [line() === null]; // as published: nothing is to be said
        session.show();
        await heavier();
        session.close();
        found.push(line().textContent);
        line().querySelector(".carts-teach-on").dispatchEvent(new window.Event("click"));
        found.push(line() === null, session.panel.root.hidden);
        give(found);
        """,
    )
    said = "You see your draft, not the published lesson."
    assert found == [True, f"{said} Go on changing Show the published one", True, False]


def test_the_link_says_that_a_draft_is_kept_as_long_as_there_is_one() -> None:
    """Before, a lesson that was opened again did not tell of it."""
    script = """
    const marks = new Map();
    globalThis.localStorage = {
      getItem: (key) => marks.get(key) ?? null,
      setItem: (key, value) => void marks.set(key, value),
      removeItem: (key) => void marks.delete(key),
    };
    const { teacherDoor } = await import(`${source}/teach/door.js`);
    globalThis.HTMLAnchorElement = window.HTMLElement;
    globalThis.location = { pathname: "/p/", href: "file:///p/", hash: "", search: "" };
    Object.defineProperty(document, "baseURI", { value: "file:///p/" });
    const found = [];
    const again = () => {
      const link = document.querySelector(".carts-teach-door a");
      link.textContent = "Change";
      teacherDoor();
      found.push(link.textContent);
    };
    again();
    await heavier();
    again();
    session.reset();
    await turn(400);
    again();
    give(found);
    """
    assert at_work(BEGUN + script) == ["Change", "Change (your draft is kept)", "Change"]


def test_what_waits_for_a_run_is_open_as_long_as_the_panel_is() -> None:
    script = """
    const runs = () => document.documentElement.classList.contains("carts-runs");
    const found = [runs()];
    session.close();
    give([...found, runs()]);
    """
    assert at_work(BEGUN + script) == [False, True]


def test_the_way_back_to_the_published_lesson_is_there_when_there_is_one() -> None:
    script = """
    const back = () => one(".carts-teach-reset button").disabled;
    const found = [back()];
    await heavier();
    found.push(back());
    session.undo();
    found.push(back());
    give(found);
    """
    assert at_work(BEGUN + script) == [True, False, True]
