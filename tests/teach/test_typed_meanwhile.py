"""What a teacher types while Python looks, or puts notes back, is neither lost nor mixed up."""

from __future__ import annotations

from tests.teach.session_in_node import at_work

LESSON = "# Title\n\n# block\nmass: 1 kg\n\nLast."


def test_what_is_typed_while_the_first_look_runs_stays_and_is_shown() -> None:
    said = at_work(
        """
        const slow = ways.look;
        let looks = 0;
        ways.look = (message) => ({ ...slow(message), more: (looks += 1) === 1 });
        holds = ({ do: what }) => what === "look";
        await begin(data.lesson);
        const begun = session.open();
        await turn(20);
        answer(); // the pieces are there, the second slice is under way
        await turn(20);
        open();
        const [prose] = all(".carts-teach-prose").slice(-1);
        type(prose, "Last words.");
        await turn(400); // longer than the pause
        const about = asked[0].message.text;
        answer();
        await turn(20);
        const shown = prose.value;
        type(prose, "Last words!!");
        const { text } = session;
        holds = () => false;
        while (asked.length) answer();
        await begun;
        give({ about, shown, text, adopted, state: session.panel.root.dataset.state,
          seen: session.look.pieces.map((piece) => piece.text).join("") });
        """,
        lesson=LESSON,
    )  # fmt: skip
    assert said["about"] == LESSON
    assert said["shown"] == "Last words."
    assert said["text"] == said["seen"] == LESSON.replace("Last.", "Last words!!")
    assert set(said["adopted"]) == {LESSON}  # the page's own elements are those of its own text
    assert said["state"] == "ready"


NOTED = "# Title\n\nnote: (stands in the teacher's own file)\n\nLast."
OWN = NOTED.replace("(stands in the teacher's own file)", "Ask Ana first.")


def test_edits_made_while_notes_are_put_back_stay() -> None:
    said = at_work(
        """
        await begin(data.lesson);
        await session.open();
        holds = ({ do: what }) => what === "restore";
        await choose(data.own);
        session.change(data.lesson.replace("Last", "Least"), "", 0);
        holds = () => false;
        answer();
        await turn(60);
        give([session.text, status()]);
        """,
        lesson=NOTED, own=OWN,
    )  # fmt: skip
    assert said[0] == OWN.replace("Last", "Least")
    assert said[1].startswith("Notes and marking guides are back")


def test_a_file_that_is_not_the_one_of_this_lesson_is_told_so_and_changes_nothing() -> None:
    """Of a picture, too, it was said that so many notes do not stand in it."""
    said = at_work(
        """
        await begin(data.lesson);
        await session.open();
        const said = [];
        for (const name of ["b.md", "carts.png", "a.md", "a.md.txt"]) {
          await choose(name === "a.md.txt" ? data.own : "# Another", name);
          const own = one(".carts-teach-own .carts-error");
          said.push([own?.textContent ?? "", session.text === data.lesson]);
        }
        give(said);
        """,
        lesson=NOTED, own=OWN,
    )  # fmt: skip
    assert said == [
        ["This is the file b.md; needed: a.md. Nothing was changed.", True],
        ["carts.png is no lesson: its name would end in .md.", True],
        [
            "No notes or marking guides of this lesson stand in this file. Nothing was changed.",
            True,
        ],
        ["", False],
    ]


def test_the_own_file_is_asked_for_whenever_notes_are_missing() -> None:
    said = at_work(
        """
        kept.set(`${page()}#older`, { text: "Old.", base: "O", last: "2026-01-01", hash: "older" });
        await begin(data.lesson);
        await session.open();
        const seen = [];
        const look = () => seen.push([".carts-teach-own", ".carts-teach-earlier"]
          .map((which) => all(which).length));
        look();
        await choose(data.own);
        look();
        session.undo();
        look();
        session.redo();
        look();
        session.reset();
        look();
        await turn(300);
        give(seen);
        """,
        lesson=NOTED, own=OWN,
    )  # fmt: skip
    assert said == [[1, 1], [0, 1], [1, 1], [0, 1], [1, 1]]


def test_without_python_the_own_file_can_be_opened_in_place_of_the_text() -> None:
    said = at_work(
        """
        start = async () => { throw new Error("no worker"); };
        await begin(data.lesson);
        await session.open();
        await choose(data.own);
        const told = status();
        press(".carts-teach-instead");
        await turn(300);
        open(); // linkedom tells nothing of it
        const area = one("textarea.carts-teach-prose, .carts-teach-code textarea");
        const instead = [session.text, area.value, all(".carts-teach-own").length];
        session.undo();
        give({ told, instead, undone: [session.text, area.value] });
        """,
        lesson=NOTED, own=OWN,
    )  # fmt: skip
    assert said["told"].startswith("Notes and marking guides could not be put back: ")
    assert said["instead"] == [OWN, OWN, 0]
    assert said["undone"] == [NOTED, NOTED]
