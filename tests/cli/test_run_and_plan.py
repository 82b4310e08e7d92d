"""`carts run` and `carts plan`, as a person and as a program would call them."""

from __future__ import annotations

import itertools
import json

import pytest
from click.testing import CliRunner

from sim.cli import main
from tests import registry

PAPER = str(registry.PATHS["paper-two-carts"])


def carts(*arguments, stdin=None):
    return CliRunner().invoke(main, [str(a) for a in arguments], input=stdin)


@pytest.mark.parametrize("name", registry.NAMES)
def test_every_scene_runs_and_has_a_plan(name):
    path = registry.PATHS[name]
    document = json.loads(carts("run", path, "--json").stdout)
    phases = json.loads(carts("plan", path, "--json").stdout)
    assert document["format"] == 1
    assert document["plan"] == phases
    assert phases[0]["from"] == 0 and phases[-1]["until"] == document["final"]["t"]
    for before, after in itertools.pairwise(phases):
        assert before["until"] == after["from"]
    for phase in phases:
        assert phase["why"]
        assert phase["packages"] == (["numpy", "scipy"] if phase["tier"] == 3 else [])


def test_the_document_of_a_run_has_the_keys_of_the_interface():
    document = json.loads(carts("run", PAPER, "--json").stdout)
    assert set(document) == {
        "format",
        "outcome",
        "plan",
        "events",
        "warnings",
        "final",
        "energy",
        "momentum",
        "work",
        "evaluations",
        "impossible",
    }
    assert document["outcome"]["kind"] == "reached-end"
    assert set(document["events"][0]) == {
        "t",
        "kind",
        "bodies",
        "before",
        "after",
        "impulse",
        "force",
    }
    assert document["events"][-1]["kind"] == "end"
    assert document["final"]["v"] == {"A": -0.8, "B": 0.4}
    assert document["evaluations"] == {
        "effects": {},
        "solvers": {"free-flight": 2, "pair-contact": 1},
    }


def test_a_scene_may_come_from_standard_input():
    text = (registry.PATHS["paper-two-carts"]).read_text(encoding="utf-8")
    assert json.loads(carts("run", "-", "--json", stdin=text).stdout)["final"]["v"]["B"] == 0.4


def test_events_can_be_counted_instead_of_listed():
    document = json.loads(carts("run", PAPER, "--json", "--no-events").stdout)
    assert "events" not in document
    assert document["event_counts"] == {"contact": 1, "peak": 1, "separate": 1, "end": 1}


def test_columns_name_quantity_and_unit():
    lines = carts("run", PAPER, "--csv").stdout.splitlines()
    assert lines[0] == ("t (s),x A (m),v A (m/s),a A (m/s²),x B (m),v B (m/s),a B (m/s²),F A-B (N)")
    assert lines[1].startswith("0.0,")
    assert all(line.count(",") == 7 for line in lines)


def test_an_error_goes_to_standard_error_with_its_place():
    result = carts("run", "-", stdin="carts:\n  A: {mass: -1, position: 1 m}\n")
    assert (result.exit_code, result.stdout) == (1, "")
    assert result.stderr.startswith("stdin:2:13: error: carts.A.mass: mass must be greater than 0")
    assert "hint:" in result.stderr


@pytest.mark.parametrize(
    "arguments",
    [
        ("run",),
        ("run", "nowhere.yml"),
        ("run", PAPER, "--method", "magic"),
        ("run", PAPER, "--json", "--csv"),
        ("dance",),
    ],
)
def test_a_wrong_call_ends_with_2_and_says_why(arguments):
    result = carts(*arguments)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr


def test_the_readable_forms_tell_the_story():
    story = carts("run", PAPER).stdout
    for word in ("contact", "peak", "separate", "warmed the bumpers", "The run reached its end"):
        assert word in story
    assert "Not simulated: friction" in carts("plan", PAPER).stdout


def test_where_no_bumper_is_pressed_none_is_warmed():
    text = registry.PATHS["light-meets-heavy"].read_text(encoding="utf-8")
    sudden = "carts: {A: {mass: 1, position: 0.2, velocity: 1}, B: {mass: 1, position: 0.5}}\n"
    sudden += "contact: {law: instant, restitution: 0.5}\nuntil: 1\n"
    assert "J warmed the bumpers." in carts("run", "-", stdin=text).stdout
    story = carts("run", "-", stdin=sudden).stdout
    assert "0.1875 J became heat in contacts." in story and "bumpers" not in story


def test_where_friction_takes_all_and_nothing_touches_no_heat_is_denied():
    """It said “0 J became heat.” below “Work: friction −0.16 J”."""
    rubbed = "carts: {A: {mass: 0.5, position: 0.4, velocity: 0.8}}\n"
    rubbed += "effects: [friction: {coefficient: 0.1}]\nuntil: 3\n"
    story = carts("run", "-", stdin=rubbed).stdout
    assert "Work: friction −0.16 J." in story and "heat" not in story


def test_two_runs_print_the_same_bytes():
    assert carts("run", PAPER, "--json").stdout == carts("run", PAPER, "--json").stdout


def test_a_scene_block_as_a_page_copies_it_is_a_scene_file_too():
    text = registry.PATHS["light-meets-heavy"].read_text(encoding="utf-8")
    block = f"```scene\n{text}```\n"
    bare, fenced = (carts("run", "-", "--certify", "--json", stdin=one) for one in (text, block))
    assert fenced.exit_code == 0 and fenced.stdout == bare.stdout
    wrong = carts("run", "-", stdin=block.replace("mass: 500 g", "mass: -500 g"))
    at = 1 + block.splitlines().index(next(s for s in block.splitlines() if "mass: 500 g" in s))
    assert f"stdin:{at}:" in wrong.stderr  # the line that the author sees
