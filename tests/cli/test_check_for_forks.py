"""A fork's automatic build: notes on the lines, and a workflow that calls what exists."""

from __future__ import annotations

import re
from pathlib import Path

import click
import yaml
from click.testing import CliRunner

from sim.cli import COMMANDS, main
from sim.pages.findings import Finding

ROOT = Path(__file__).parents[2]
WORKFLOW = ROOT / ".github" / "workflows" / "lessons.yml"


def test_a_mistake_is_a_note_on_its_line(tmp_path: Path) -> None:
    lesson = tmp_path / "a,b.md"
    lesson.write_text("# A\n\n```scene\nid: one\ncarts:\n  A: {mass: -1}\n```\n", encoding="utf-8")
    result = CliRunner().invoke(main, ["check", "--format", "github", str(lesson)])
    assert result.exit_code == 1
    notes = [line for line in result.output.splitlines() if line.startswith("::")]
    assert notes
    assert all(re.match(r"::error file=[^,:]*a%2Cb\.md,line=\d+,col=\d+::\S", n) for n in notes)


def test_a_note_is_one_line_whatever_the_message_says() -> None:
    finding = Finding("x.md", 3, 1, "code", "100 % wrong\nreally", "so\r\nor so")
    note = finding.as_annotation()
    assert "\n" not in note and "\r" not in note
    assert "100 %25 wrong%0Areally" in note


def test_the_workflow_calls_commands_and_targets_that_exist() -> None:
    steps = [
        step
        for job in yaml.safe_load(WORKFLOW.read_text(encoding="utf-8"))["jobs"].values()
        for step in job["steps"]
    ]
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    called = [step["run"] for step in steps if "run" in step]
    assert called
    for line in called:
        if line.startswith("make "):
            assert re.search(rf"^{line.split()[1]}:", makefile, re.M), line
            continue
        program, name, *arguments = line.split()
        assert program == ".venv/bin/carts" and name in COMMANDS, line
        command = main.get_command(click.Context(main), name)
        assert command is not None
        options = {option for parameter in command.params for option in parameter.opts}
        assert {word for word in arguments if word.startswith("--")} <= options, line


def test_what_is_so_by_default_is_counted_and_listed_when_asked(tmp_path: Path) -> None:
    """An older lesson builds unchanged; its author learns what a new default does in it."""
    lesson = tmp_path / "worksheets" / "old.md"
    lesson.parent.mkdir()
    asks = "predict: {choice: [left, right]}"
    scene = "```scene\nid: {}\ncarts: {{A: {{mass: 1 kg, position: 1 m}}}}\n{}\n```\n\n"
    number = "type: number\nask: How much?\nanswer: 1 m\ntolerance: 0.1 m"
    question = "```question\nid: {}\n" + number + "\n{}\n```\n\n"
    text = "# Old\n\n" + scene.format("first", asks) + question.format("waits", "")
    text += question.format("open", "after: none") + scene.format("free", "watch: free")
    text += "## Next\n\n" + question.format("later", "") + scene.format("last", "")
    lesson.write_text(text, encoding="utf-8")
    counted = CliRunner().invoke(main, ["check", str(lesson)])
    assert counted.exit_code == 0, counted.output
    assert (
        "Good to know: 3 scenes and questions open to a student who has watched the run"
        in counted.output.splitlines()[-1]
    )
    listed = CliRunner().invoke(main, ["check", "--defaults", str(lesson)]).output
    assert re.findall(r"hint: (?:id: )?(“\w+” is watched|opens when “\w+”)", listed) == [
        "“first” is watched",
        "opens when “first”",
        "“last” is watched",
    ]
