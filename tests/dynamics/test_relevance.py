"""What an effect would change is what the formula of that effect says, and nothing is guessed."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from typing import Any

import pytest
from click.testing import CliRunner

from sim.bridge.protocol import answer
from sim.cli import main
from sim.dynamics.relevance.difference import READS
from sim.dynamics.relevance.ranking import EffectChange, hint, ranked_effects, rows
from sim.effects.estimates import estimate_of
from sim.scene import SceneError, read_scene
from sim.scene.effects import kinds
from tests import registry

M, V, T, G = 0.5, 0.6, 4.0, 9.81


def alone(**more: Any) -> dict[str, Any]:
    """One cart that glides; its graphs are V and V T high."""
    cart = {"mass": M, "position": 0.0, "velocity": V}
    return {"carts": {"A": cart}, "until": T, **more}


def rung(scene: dict[str, Any], effect: str) -> EffectChange:
    return next(r for r in ranked_effects(read_scene(scene)) if r.candidate.effect == effect)


def change(rungs: EffectChange) -> float:
    assert rungs.changes is not None
    return rungs.changes.amount


def test_missing_friction_would_stop_as_much_as_coulomb_says() -> None:
    found = rung(alone(), "friction")
    mu = estimate_of("friction").numbers["coefficient"]
    assert found.changes.quantity == "v.A" and found.changes.at == T
    assert change(found) == pytest.approx(mu * G * T, rel=1e-12)
    assert found.changes.relative == pytest.approx(mu * G * T / V, rel=1e-12)
    assert found.visible and not found.candidate.listed


def test_missing_air_would_take_what_its_closed_form_says() -> None:
    c = estimate_of("drag").numbers["quadratic"]
    left = V / (1.0 + c * V * T / M)
    assert change(rung(alone(), "drag")) == pytest.approx(V - left, rel=1e-9)


def test_a_slope_left_out_would_give_g_sine_t() -> None:
    angle = estimate_of("incline").numbers["angle"]
    assert angle == pytest.approx(0.1 * math.pi / 180)
    assert change(rung(alone(), "incline")) == pytest.approx(G * math.sin(angle) * T, rel=1e-12)


def test_leaving_out_a_listed_effect_is_the_run_without_it() -> None:
    found = rung(alone(effects=[{"friction": {"coefficient": 0.01}}]), "friction")
    assert found.candidate.listed
    assert change(found) == pytest.approx(0.01 * G * T, rel=1e-12)


def test_an_author_says_how_large_it_would_be() -> None:
    own = alone(
        estimate=[{"friction": {"coefficient": 1e-4}}, {"push": {"cart": "A", "force": 0.01}}]
    )
    found = rung(own, "friction")
    assert change(found) == pytest.approx(1e-4 * G * T, rel=1e-12)
    assert not found.visible and "cannot show" in found.sentence
    assert change(rung(own, "push")) == pytest.approx(0.01 * T / M, rel=1e-12)
    assert rung(own, "push").candidate.size.startswith("0.01 N")


def test_a_law_that_delivers_more_than_its_e_is_left_out_with_what_it_delivers() -> None:
    """A stiff bumper takes no time to speak of: without it hardly anything changes."""
    plain = registry.two_carts(law="push-only-uncorrected", restitution=0.5, stiffness=1e8)
    row = next(
        one for one in ranked_effects(read_scene(plain)) if one.candidate.effect == "contact"
    )
    assert row.changes is not None
    assert abs(row.changes.relative) < 1e-3


def test_a_change_of_the_whole_graph_is_told_without_an_exponent() -> None:
    plain = registry.two_carts(until="2 s")
    plain["effects"] = [{"push": {"cart": "A", "force": "100 N"}}]
    told = [rung.sentence for rung in ranked_effects(read_scene(plain))]
    assert any("%" in one for one in told)
    assert not any("e+" in one.partition("%")[0][-8:] for one in told)


def test_an_estimate_changes_no_run() -> None:
    from sim.dynamics.loop.run import run

    mine, plain = (
        run(read_scene(scene)) for scene in (alone(estimate=[{"incline": {"angle": 1}}]), alone())
    )
    assert (mine.x, mine.v, mine.effects) == (plain.x, plain.v, {})


@pytest.mark.parametrize(
    ("estimate", "path"),
    [
        ("friction", ("estimate",)),
        ([{"friction": {}}], ("estimate", 0, "friction")),
        ([{"fricton": {"coefficient": 1}}], ("estimate", 0, "fricton")),
    ],
)
def test_a_wrong_estimate_is_an_error_at_its_place(estimate: object, path: tuple[Any, ...]) -> None:
    with pytest.raises(SceneError) as error:
        read_scene(alone(estimate=estimate))
    assert [problem.path for problem in error.value.problems] == [path]


def test_what_takes_no_time_is_told_against_what_does() -> None:
    """Two equal carts, e = 1: each moves on with the other's velocity, a contact later."""
    carts = {
        "A": {"mass": 1, "position": 0, "velocity": 1},
        "B": {"mass": 1, "position": 1},
    }
    scene = {"carts": carts, "contact": {"stiffness": 50}, "until": 2}
    found = rung(scene, "contact")
    assert found.candidate.listed
    # B is pushed for π sqrt(μ/k) at half the speed on average, and so is late by half of that.
    assert change(found) == pytest.approx(math.pi * math.sqrt(0.5 / 50) / 2, rel=0.05)
    sudden = rung({**scene, "contact": {"law": "instant"}}, "contact")
    assert not sudden.candidate.listed and sudden.candidate.size == "500 N/m"


@pytest.mark.parametrize("name", sorted(registry.PATHS))
def test_every_ladder_is_whole_sorted_and_has_one_line(name: str) -> None:
    scene = registry.scene(name)
    rungs = ranked_effects(scene)
    assert {r.candidate.effect for r in rungs} - {"contact"} == set(kinds())
    known = [r.changes.relative for r in rungs if r.changes is not None]
    assert known == sorted(known, reverse=True)
    assert [r.changes is None for r in rungs] == sorted(r.changes is None for r in rungs)
    for one in rungs:
        assert one.visible == (one.changes is not None and one.changes.relative > READS)
        listed = any(e.kind == one.candidate.effect for e in scene.effects)
        assert one.candidate.effect == "contact" or one.candidate.listed == listed


def test_an_effect_without_a_usual_size_says_so() -> None:
    found = rung(alone(), "push")
    assert found.changes is None and "no usual size" in found.sentence


def test_the_command_prints_the_interface_and_the_page_gets_the_same() -> None:
    path = str(registry.PATHS["light-meets-heavy"])
    printed = json.loads(CliRunner().invoke(main, ["plan", "--relevance", "--json", path]).stdout)
    assert printed == rows(ranked_effects(registry.scene("light-meets-heavy")))
    wanted = {"effect", "listed", "changes", "visible", "sentence"}
    assert all(wanted <= set(row) for row in printed)
    assert set(printed[0]["changes"]) == {"quantity", "at", "amount", "relative"}
    plain = registry.plain("light-meets-heavy")
    header, numbers = answer({"id": 1, "kind": "relevance", "scene": plain, "set": {"A.mass": 2}})
    assert header["ok"] and len(numbers) == 0 and header["reads"] == READS
    assert [row["effect"] for row in header["rungs"]] != []
    assert header["rungs"][0]["sentence"]["code"].startswith("{effect} would change")
    text = CliRunner().invoke(main, ["plan", "--relevance", path]).stdout
    above, below = text.split("---- a graph shows 1 %")
    assert "would show that" in above and "Air resistance" in below


def test_a_run_loads_no_estimate() -> None:
    code = (
        "import sys; from sim.bridge.protocol import answer; "
        f"answer({{'id': 1, 'kind': 'run', 'scene': {alone()!r}}}); print(sorted(sys.modules))"
    )
    loaded = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert "estimate" not in loaded.stdout and "relevance" not in loaded.stdout


def test_a_hint_names_what_is_listed_in_vain_and_what_is_missed_most() -> None:
    vain = read_scene(alone(effects=[{"friction": {"coefficient": 1e-6}}]))
    assert hint(ranked_effects(vain)).startswith("Without friction")
    missed = read_scene(alone(until=9))  # friction and drag: 0.53 m/s of 0.6
    assert hint(ranked_effects(missed)).startswith("Friction (μ = 0.006) would change")
    assert hint(ranked_effects(read_scene(alone(until=0.1)))) == ""


def test_a_check_gives_one_hint_and_no_error(tmp_path: Any) -> None:
    scenes = tmp_path / "scenes"
    scenes.mkdir()
    cart = "carts: {A: {mass: 1, position: 0, velocity: 1}}\n"
    (scenes / "a.yml").write_text(f"{cart}effects:\n  - friction: {{coefficient: 1e-6}}\n")
    done = CliRunner().invoke(main, ["check", str(scenes)])
    assert done.exit_code == 0, done.output
    assert done.output.count(": hint: ") == 1 and "a.yml:2:1: hint: " in done.output
    assert done.output.endswith("no findings\n")
    found = json.loads(CliRunner().invoke(main, ["check", "--json", str(scenes)]).stdout)
    assert [(row["severity"], row["code"]) for row in found] == [("hint", "relevance")]


@pytest.mark.parametrize("until", [1.0005, 1.01])
def test_a_contact_a_moment_later_is_no_other_velocity_at_the_end(until: float) -> None:
    """At 1 s the two touch; in air half a millisecond later, when the shorter run is over."""
    carts = {
        "A": {"mass": 1, "position": 0.3, "velocity": 0.5},
        "B": {"mass": 1, "position": 1.0},
    }
    plain = {"carts": carts, "contact": {"law": "instant"}, "until": until}
    found = rung(plain, "drag")
    assert found.changes is not None
    assert not found.visible
    assert found.changes.amount > 0.0


def test_two_runs_are_compared_up_to_where_the_shorter_one_was_stopped() -> None:
    """Bumpers have three events in a contact, sudden ones have one: these go on for longer."""
    carts = {"A": {"mass": 0.001, "position": 0.5, "velocity": 10}}
    track = {"left": "wall", "right": "wall", "length": 1.2}
    plain = {"carts": carts, "track": track, "contact": {"stiffness": 1e12}, "until": 200.03}
    found = rung(plain, "contact")
    assert found.changes is not None and found.changes.at < 170.0
    assert found.changes.relative < 0.01
