"""Whatever a command is given, it answers with a place, a reason and an exit code."""

from __future__ import annotations

import json

import pytest
from click.testing import CliRunner

from sim.cli import main, progress
from sim.cli.progress import run_on_terminal
from sim.pages.findings import Finding
from sim.scene import read_scene
from tests import registry

TWO = "carts:\n  A: {mass: 1, position: 0.5}\n  B: {mass: 1, position: 1.5}\n"

MISTAKES = {
    "two names of one pair": (
        TWO + "contact: {pairs: {A-B: {restitution: 0}, B-A: {restitution: 1}}}\n",
        "stdin:4:42: error: contact.pairs.B-A: “B-A” is the same pair as “A-B”",
    ),
    "a wall that is not there": (
        TWO + "contact: {pairs: {B-right: {restitution: 0}}}\n",
        "stdin:4:19: error: contact.pairs.B-right: “B-right” needs a wall",
    ),
    "a cart called nothing": (
        "carts: {null: {mass: 1, position: 1}}\n",
        "stdin:1:9: error: carts.null: “null” cannot name a cart",
    ),
    "a push that ends before it begins": (
        TWO + "effects:\n  - push: {cart: A, force: 1, from: 2, until: 1}\n",
        "stdin:5:47: error: effects.0.push.until: the push ends at 1 s, but begins at 2 s",
    ),
    "static friction below the other": (
        TWO + "effects:\n  - friction: {coefficient: 0.2, static: 0.1}\n",
        "stdin:5:42: error: effects.0.friction.static: static friction is never less",
    ),
    "no scene": ("", "stdin:1:1: error: carts: expected keys here, found nothing"),
    "a list": ("- 1\n", "stdin:1:1: error: expected lines of “key: value”"),
    "an endless bracket": ("carts: " + "[" * 800, "stdin:"),
    "not a text": (b"\xff\xfe", "stdin:1:1: error: this is not UTF-8 text"),
}


def carts(*arguments, stdin=None):
    return CliRunner().invoke(main, [str(a) for a in arguments], input=stdin)


@pytest.mark.parametrize("command", ["run", "plan"])
@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_in_a_scene_ends_with_1_and_its_place(command, name):
    text, message = MISTAKES[name]
    result = carts(command, "-", "--json", stdin=text)
    assert (result.exit_code, result.stdout) == (1, "")
    assert result.stderr.startswith(message)
    assert "hint: " in result.stderr
    assert "Traceback" not in result.stderr


ABSURD = [
    "carts: {A: {mass: 1e308, position: 0}}",
    "carts: {A: {mass: 1e-320, position: 0}}",
    "carts: {A: {mass: 1, position: 1e400}}",
    "carts: {A: {mass: 1, position: 0}}\nuntil: 1e300",
    "carts: {A: {mass: 1, position: 0}}\ngravity: 1e99",
    "carts: {A: {mass: 1, position: 0, velocity: 1e51}}",
    "carts: {A: {mass: 1, position: 0, velocity: .inf}}",
    "carts: {A: {mass: 1, position: 0}}\neffects: [{incline: {angle: 89}}]",
    "carts: {A: {mass: 1, position: 0}}\neffects: [{drag: {linear: 1e-60}}]",
    f"carts: {{A: {{mass: {'9' * 300}, position: 0}}}}",
    f"carts: {{A: {{mass: {'9' * 500}, position: 0}}}}",
    "carts: {" + ", ".join(f"c{k}: {{mass: 1, position: {k}}}" for k in range(30_000)) + "}",
    "carts: {A: {mass: 1, position: 0}}\neffects:\n" + " - friction: {coefficient: 0}\n" * 2001,
]


@pytest.mark.parametrize("text", ABSURD, ids=lambda text: text[:60].replace("\n", " "))
def test_absurd_values_are_refused_before_any_work(text):
    result = carts("run", "-", "--json", stdin=text)
    assert (result.exit_code, result.stdout) == (1, "")
    assert ": error: " in result.stderr
    assert "Traceback" not in result.stderr


BOX = "track: {length: 1, left: wall, right: wall}\ncontact: {law: instant}\n"
ENDLESS = [
    "carts: {A: {mass: 1, position: 0.5, velocity: 1}}\nuntil: 1e49\n" + BOX,
    "carts: {A: {mass: 1, position: 0.5, velocity: 1e49}}\n" + BOX,
    "carts: {A: {mass: 1e-40, position: 0.5, velocity: 1}}\nuntil: 1e9\n" + BOX,
]


@pytest.mark.parametrize("text", ENDLESS)
def test_a_run_without_an_end_is_stopped_and_says_what_to_change(text):
    document = json.loads(carts("run", "-", "--json", "--max-events", 2000, stdin=text).stdout)
    assert document["outcome"]["kind"] == "too-many-events"
    assert "Ask for an earlier end (until)" in document["outcome"]["sentence"]
    assert document["final"]["v"]["A"] is not None


def test_mistakes_come_in_the_order_of_the_lines():
    text = "until: never\ncarts:\n  A: {mass: -1, position: x}\ncolour: red\nshow: [q]\n"
    errors = [e for e in carts("run", "-", stdin=text).stderr.splitlines() if e[:5] == "stdin"]
    assert [int(line.split(":")[1]) for line in errors] == [1, 3, 3, 4, 5]


def test_run_and_check_say_the_same(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = TWO + "colour: red\nshow: [q]\nforces: maybe\nid: Bad Id\nview: away\ncontrols: 3\n"
    (tmp_path / "bad.yml").write_text(text, encoding="utf-8")
    told = carts("run", "bad.yml").stderr
    assert carts("check", "bad.yml").stdout == told + "6 findings\n"


def test_a_scene_file_may_say_how_it_is_shown(tmp_path):
    (tmp_path / "shown.yml").write_text(TWO + "id: two\nshow: [x]\nslow: never\n", encoding="utf-8")
    assert carts("run", tmp_path / "shown.yml").exit_code == 0
    assert carts("check", tmp_path / "shown.yml").stdout == "no findings\n"


def test_a_mark_at_the_beginning_of_a_windows_file_is_no_mistake():
    assert carts("run", "-", stdin=b"\xef\xbb\xbf" + TWO.encode()).exit_code == 0


def test_a_world_that_does_not_exist_is_answered_with_those_that_do():
    result = carts("run", "-", "--world", "nope", stdin=TWO)
    assert result.exit_code == 2
    assert "There is no world “nope”. Worlds: " in result.stderr
    assert "bigger-pushes-more" in result.stderr
    assert "Write in it" not in result.stderr
    unnamed = carts("run", "-", "--world", "bigger-pushes-more", stdin=TWO).stderr
    assert "Write in it: worlds: [bigger-pushes-more]" in unnamed


@pytest.mark.parametrize("command", ["run", "plan"])
def test_a_path_that_cannot_be_read_is_a_wrong_call(command, tmp_path):
    (tmp_path / "loop.yml").symlink_to("loop.yml")
    for path in (tmp_path, tmp_path / "nowhere.yml", tmp_path / "loop.yml", "a\0b"):
        result = carts(command, path)
        assert (result.exit_code, result.stdout) == (2, "")
        assert "Error: " in result.stderr
        assert "Traceback" not in result.stderr


def test_the_account_of_a_run_is_told_by_name():
    story = carts("run", registry.PATHS["incline-bounce"]).stdout
    assert "From outside: incline gave 0.684832 N s, walls gave −0.585522 N s." in story
    assert "height on the incline" in story
    story = carts("run", registry.PATHS["release-and-friction"]).stdout
    assert "Work: release 0.06 J, friction −0.06 J." in story
    story = carts("run", registry.PATHS["magnets-repel"]).stdout
    assert "No impulse from outside." in story
    assert "  magnets" in story


class Terminal:
    """Standard error that is a terminal."""

    def __init__(self):
        self.text = ""

    def write(self, text):
        self.text += text

    def flush(self):
        pass

    def isatty(self):
        return True


LONG = read_scene(
    {
        "carts": {"A": {"mass": 1, "position": "0.5", "velocity": 1}},
        "track": {"length": 1, "left": "wall", "right": "wall"},
        "until": 3000,
    }
)


def test_a_long_run_tells_a_terminal_how_far_it_is(monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr("sys.stderr", terminal)
    monkeypatch.setattr(progress, "QUIET", 0.0)
    run_on_terminal("long.yml", LONG, keep_motion=False)
    assert terminal.text.startswith("\rt = ")
    assert "of 3000 s" in terminal.text
    assert terminal.text.endswith(" \r"), "the line is wiped in the end"


def test_a_long_run_tells_nobody_else():
    text = json.dumps({"carts": {"A": {"mass": 1, "position": 1}}, "until": 1})
    result = carts("run", "-", "--json", stdin=text)
    assert result.stderr == ""
    assert json.loads(result.stdout)["format"] == 1


def test_what_cannot_be_solved_is_a_finding(monkeypatch, capsys):
    from sim.dynamics.result.outcome import UnsolvedError

    def refuse(*_, **__):
        raise UnsolvedError("no solver", "use another law", 0.0, ("A",))

    monkeypatch.setattr(progress, "run", refuse)
    with pytest.raises(SystemExit) as ended:
        run_on_terminal("odd.yml", LONG)
    assert ended.value.code == 1
    told = str(Finding("odd.yml", 1, 1, "unsolved", "no solver", "use another law"))
    assert capsys.readouterr().err == told + "\n"


def test_a_check_in_a_folder_without_lessons_says_so(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = carts("check")
    assert done.exit_code == 2
    assert "There are no lessons here" in done.stderr
