"""A run that takes long says so, once, on standard error, and nowhere else."""

from __future__ import annotations

import json
import time
from collections.abc import Callable

import pytest
from click.testing import CliRunner, Result

from sim.cli import main, progress
from sim.dynamics.loop.run import run
from sim.dynamics.relevance import ranking

SCENE = """
carts:
  A: {mass: 1e-12 kg, position: 0.5 m}
  B: {mass: 1e12 kg, position: 1 m, velocity: -0.1}
until: 1 s
worlds: [bigger-pushes-more]
"""


def carts(*words: str) -> Result:
    return CliRunner().invoke(main, [*words[:1], "-", *words[1:]], input=SCENE)


def slow(monkeypatch: pytest.MonkeyPatch) -> Callable[..., object]:
    """The exact run, that takes three times as long as anybody waits in silence."""
    monkeypatch.setattr(progress, "PATIENCE", 0.05)

    def late(*words: object, **more: object) -> object:
        time.sleep(0.15)
        return run(*words, **more)  # type: ignore[arg-type]

    monkeypatch.setattr(progress, "run", late)
    return late


@pytest.mark.parametrize("command", ["run", "plan"])
def test_a_command_that_computes_for_long_says_so_beside_its_json(
    monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    slow(monkeypatch)
    result = carts(command, "--json")
    assert result.exit_code == 0
    assert result.stderr == "Still computing after 0.05 s. Ctrl+C ends it.\n"
    assert json.loads(result.stdout)


def test_the_ladder_of_effects_says_so_too(monkeypatch: pytest.MonkeyPatch) -> None:
    late = slow(monkeypatch)
    monkeypatch.setattr(ranking, "run", late)
    assert carts("plan", "--relevance").stderr.count("Still computing") == 1


def test_a_quick_run_says_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress, "PATIENCE", 60.0)  # of a machine that does much else
    assert carts("run", "--json").stderr == ""


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("--world", "bigger-pushes-more", "--no-events"), "--no-events does not go with a world"),
        (("--method", "rk4", "--max-events", "9"), "--max-events does not go with a stepping"),
    ],
)
def test_an_option_that_a_run_has_no_use_for_is_refused(
    words: tuple[str, ...], reason: str
) -> None:
    result = carts("run", *words)
    assert result.exit_code == 2
    assert reason in result.stderr
