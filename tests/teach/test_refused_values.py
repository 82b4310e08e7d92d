"""A value that Python refused stays in its field, and is told of, until it is mended or undone."""

from __future__ import annotations

from tests.teach.session_in_node import at_work

LESSON = "# Title\n\n# block\nmass: 1 kg\nlength: 2 m\n\nLast."
BEGUN = """
await begin(data.lesson);
await session.open();
open();
const field = (k) => all(".carts-teach-fields input")[k];
const note = (k) => all(".carts-teach-fields .carts-teach-note")[k].textContent;
type(field(0), "2!");
field(0).dispatchEvent(new window.Event("change"));
await turn(30);
"""


def test_another_field_does_not_take_it_away() -> None:
    said = at_work(
        BEGUN
        + """
        type(field(1), "3 m");
        field(1).dispatchEvent(new window.Event("change"));
        await turn(50);
        const shown = [field(0).value, note(0), session.text];
        press(".carts-teach-save");
        await turn(30);
        give([...shown, status()]);
        """,
        lesson=LESSON,
    )  # fmt: skip
    value, note, text, status = said
    assert (value, note) == ("2!", "This cannot be written.")
    assert text == LESSON.replace("2 m", "3 m")
    assert "mass: This cannot be written." in status and "without what you typed last" in status


def test_nor_does_a_change_by_which_the_fields_are_made_anew() -> None:
    said = at_work(
        BEGUN
        + """
        session.change(session.text.replace("length", "width: 1 m\\nlength"), "", 0);
        await turn(50);
        give([field(0).value, note(0), all(".carts-teach-fields input").length]);
        """,
        lesson=LESSON,
    )
    assert said == ["2!", "This cannot be written.", 3]


def test_the_value_of_the_text_ends_it() -> None:
    said = at_work(
        BEGUN
        + """
        type(field(0), "1 kg");
        field(0).dispatchEvent(new window.Event("change"));
        await turn(30);
        const mended = note(0);
        type(field(0), "2!");
        field(0).dispatchEvent(new window.Event("change"));
        await turn(30);
        session.change(session.text.replace("1 kg", "5 kg"), "", 0);
        await turn(50);
        give([mended, field(0).value, note(0)]);
        """,
        lesson=LESSON,
    )
    assert said == ["", "5 kg", ""]


def test_going_back_takes_it_along() -> None:
    said = at_work(
        BEGUN
        + """
        session.change(session.text.replace("Last", "Least"), "", 0);
        await turn(50);
        session.undo();
        await turn(50);
        give([field(0).value, note(0)]);
        """,
        lesson=LESSON,
    )
    assert said == ["1 kg", ""]


def test_a_value_on_its_way_is_not_reset_by_a_look() -> None:
    said = at_work(
        """
        await begin(data.lesson);
        await session.open();
        open();
        const mass = one(".carts-teach-fields input");
        holds = ({ do: what }) => what === "set";
        session.change(session.text.replace("Last", "Least"), "", 0);
        type(mass, "2 kg");
        mass.dispatchEvent(new window.Event("change"));
        session.panel.take(session.look); // a look comes before the value is in the text
        const meanwhile = mass.value;
        holds = () => false;
        while (asked.length) answer();
        await turn(50);
        give([meanwhile, session.text]);
        """,
        lesson=LESSON,
    )
    assert said == ["2 kg", LESSON.replace("1 kg", "2 kg").replace("Last", "Least")]
