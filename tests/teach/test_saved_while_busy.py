"""What was typed last is in the file, though Python is busy when the button is pressed."""

from __future__ import annotations

import pytest

from tests.teach.session_in_node import at_work

LESSON = "# Title\n\n# block\nmass: 1 kg\n\nLast."
BEGUN = """
await begin(data.lesson);
await session.open();
open();
const mass = one(".carts-teach-fields input");
holds = ({ do: what }) => data.held.includes(what);
"""


@pytest.mark.parametrize("button", ["save", "zip"])
@pytest.mark.parametrize("left", [True, False], ids=["the field was left", "within the pause"])
def test_a_value_typed_just_before_is_in_the_file(button: str, left: bool) -> None:
    said = at_work(
        BEGUN
        + """
        session.change(data.lesson.replace("Last", "Least"), "", 0);
        await turn(5); // the look is under way, and takes long
        type(mass, "2 kg");
        if (data.left) mass.dispatchEvent(new window.Event("change"));
        press(data.button);
        await turn(30);
        const before = { files: files.length, status: status() };
        holds = () => false;
        answer();
        await turn(50);
        give({ before, text: await given(), status: status() });
        """,
        lesson=LESSON, held=["look"], left=left, button=f".carts-teach-{button}",
    )  # fmt: skip
    assert said["before"] == {"files": 0, "status": "Taking over what you typed …"}
    assert said["text"] == LESSON.replace("Last", "Least").replace("1 kg", "2 kg")
    assert said["status"].startswith("Saved as")


def test_a_value_that_is_refused_is_named_in_place_of_saved() -> None:
    said = at_work(
        BEGUN
        + """
        type(mass, "2!");
        press(".carts-teach-save");
        await turn(30);
        const first = status();
        type(mass, "3 kg");
        press(".carts-teach-save");
        await turn(30);
        give([first, status(), await given()]);
        """,
        lesson=LESSON, held=[],
    )  # fmt: skip
    assert "mass: This cannot be written." in said[0] and "Saved" not in said[0]
    assert said[1].startswith("Saved as")
    assert said[2] == LESSON.replace("1 kg", "3 kg")


def test_without_python_a_lesson_is_saved_at_once() -> None:
    said = at_work(
        """
        start = async () => { throw new Error("no worker"); };
        await begin(data.lesson);
        await session.open();
        session.change(`${session.text} More.`, "");
        press(".carts-teach-save");
        await turn();
        give([await given(), status()]);
        """,
        lesson=LESSON,
    )
    assert said[0] == f"{LESSON} More."
    assert said[1].startswith("Saved as")


def test_a_python_that_hangs_keeps_no_file_back() -> None:
    said = at_work(
        """
        const { UnderWay } = await import(`${source}/teach/under-way.js`);
        const values = new UnderWay();
        values.add("mass", new Promise(() => {}));
        values.add("length", Promise.resolve(""));
        give(await values.all(20));
        """
    )
    assert said == ["mass: Python has not answered yet."]
