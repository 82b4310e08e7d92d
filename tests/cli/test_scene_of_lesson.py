"""Commands take a scene from where it stands: the lesson, and after # its id."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from sim.cli import main
from sim.dynamics.result.outcome import UnsolvedError

FIRST = "carts: {A: {mass: 1 kg, position: 0.4 m, velocity: 0.5 m/s}}\n"
WRONG = "carts: {A: {mass: 1 kg, place: 0.4 m}}\n"
LESSON = f"# Two\n\n```scene\nid: one\n{FIRST}```\n\nText.\n\n```scene\nid: other\n%s```\n"


def carts(*arguments: str) -> Result:
    return CliRunner().invoke(main, list(arguments))


@pytest.fixture
def lesson(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.chdir(tmp_path)
    Path("two.md").write_text(LESSON % FIRST.replace("0.5", "2"), encoding="utf-8")
    return "two.md"


@pytest.mark.parametrize("command", ["run", "plan"])
def test_a_scene_of_a_lesson_is_taken_as_if_it_stood_in_a_file(lesson: str, command: str) -> None:
    Path("one.yml").write_text(FIRST, encoding="utf-8")
    of_lesson, of_file = carts(command, f"{lesson}#one"), carts(command, "one.yml")
    assert of_lesson.exit_code == of_file.exit_code == 0, of_lesson.output
    assert of_lesson.output == of_file.output


def test_a_scene_as_one_file_is_named_as_elsewhere(
    lesson: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sim.pages.single.of_scene.single_file", lambda block, *_, **__: "a page")
    assert carts("single", f"{lesson}#other").exit_code == 0
    assert Path("other.html").is_file()


def test_another_id_is_another_scene(lesson: str) -> None:
    ends = [
        json.loads(carts("run", f"{lesson}#{name}", "--json").output)["final"]["v"]["A"]
        for name in ("one", "other")
    ]
    assert ends == [0.5, 2.0]


@pytest.mark.parametrize("command", ["run", "plan", "cost"])
@pytest.mark.parametrize("asked", ["two.md", "two.md#nobody"])
def test_of_several_scenes_all_ids_are_said(lesson: str, command: str, asked: str) -> None:
    found = carts(command, asked)
    assert found.exit_code == 2
    assert "Name one scene of two.md: two.md#one | other" in found.output
    assert ("There is no scene “nobody” here." in found.output) == asked.endswith("nobody")


def test_a_mistake_is_told_at_its_line_of_the_lesson(lesson: str) -> None:
    Path(lesson).write_text(LESSON % WRONG, encoding="utf-8")
    found = carts("run", f"{lesson}#other")
    assert found.exit_code == 1
    assert "two.md:12:25: error: carts.A.place" in found.output


@pytest.mark.parametrize(
    ("named", "place"), [("one.yml", "one.yml:1:1"), ("two.md#other", "two.md:11:1")]
)
def test_what_cannot_be_solved_is_told_where_its_scene_stands(
    lesson: str, monkeypatch: pytest.MonkeyPatch, named: str, place: str
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise UnsolvedError("no solver", "use another law", 0.0, ("A",))

    Path("one.yml").write_text(FIRST, encoding="utf-8")
    monkeypatch.setattr("sim.cli.progress.run", refuse)
    found = carts("run", named)
    assert found.exit_code == 1
    assert found.stderr == f"{place}: error: no solver\n  hint: use another law\n"
