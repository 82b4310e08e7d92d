"""What a tolerance allows, over time: every run that it allows lies inside, and not much else."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest

from sim.bridge import certify_answer
from sim.bridge.protocol import answer
from sim.certify.band import MOST_PIECES, pieces
from sim.certify.certificate import Certificate, certify
from sim.certify.run import Limit
from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.scene import Scene, read_scene

PAIR: dict[str, Any] = {
    "carts": {
        "A": {"mass": "0.50(1) kg", "position": "0.3 m", "velocity": "0.6 m/s"},
        "B": {"mass": "1.5 kg ± 20 g", "position": "1.200(5) m"},
    },
    "contact": {"restitution": 0.9, "stiffness": "150 N/m"},
    "until": "4 s",
}
ENDS = {"A.mass": (0.49, 0.51), "B.mass": (1.48, 1.52), "B.position": (1.195, 1.205)}
ROUNDING = 1e-12
"""m and m/s. What the engine's own rounding makes of a number of size 1."""


def proved(scene: dict[str, Any], **more: Any) -> dict[str, Any]:
    header, numbers = answer({"id": 1, "kind": "certify", "scene": scene, **more})
    assert header["ok"] and not len(numbers)
    return header


def allowed(chosen: tuple[float, ...]) -> dict[str, Any]:
    carts = {name: dict(cart) for name, cart in PAIR["carts"].items()}
    for path, value in zip(ENDS, chosen, strict=True):
        cart, key = path.split(".")
        carts[cart][key] = value
    return PAIR | {"carts": carts}


def test_every_run_that_the_tolerances_allow_lies_in_the_band() -> None:
    band = proved(PAIR)["band"]
    assert len(band["t"]) >= 97  # every instant of a graph, and both edges of wide events
    choices = [(low, (low + high) / 2, high) for low, high in ENDS.values()]
    for chosen in itertools.product(*choices):
        done = run(read_scene(allowed(chosen)))
        for k, t in enumerate(band["t"]):
            for kind, numbers in zip("xv", sample(done, t), strict=True):
                for name, number in zip(PAIR["carts"], numbers, strict=True):
                    low, high = band[kind][name][k]
                    assert low - ROUNDING <= number <= high + ROUNDING, (name, kind, t)


@pytest.mark.parametrize("ends", [True, False], ids=["with an end", "without an end"])
def test_a_band_for_which_there_is_no_time_takes_nothing_from_what_was_proved(
    ends: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    def hurried(scene: Scene, *, limit: Limit, instants: Sequence[float] = ()) -> Certificate:
        if instants:  # the proof of the band begins when the time is over
            return certify(scene, limit=Limit(limit.changes, 0.0), instants=instants)
        found = certify(scene, limit=limit)
        return found if ends else replace(found, x={}, v={})

    monkeypatch.setattr(certify_answer, "certify", hurried)
    told = proved(PAIR)
    kinds = [event["kind"] for event in told["certificate"]["events"]]
    assert (kinds[0], kinds[-2:]) == ("contact", ["separate", "end"])
    assert bool(told["certificate"]["final"]["x"]) is ends
    assert told["band"] is None


def test_within_an_events_own_time_the_band_holds_before_and_after() -> None:
    """B's place is tolerant, so nobody knows just when A, of 0.6 m/s, has bounced off."""
    told = proved(PAIR | {"contact": {"law": "instant", "restitution": 0.9}})
    low, high = map(float, told["certificate"]["events"][0]["t"])
    band = told["band"]
    inside = [k for k, t in enumerate(band["t"]) if low + 1e-6 < t < high - 1e-6]
    assert inside and all(min(abs(t - edge) for t in band["t"]) < 1e-6 for edge in (low, high))
    for k in inside:
        least, most = band["v"]["A"][k]
        assert least < 0 and most >= 0.6  # perhaps already, perhaps not yet


def test_the_band_of_one_tolerant_mass_is_less_than_twice_as_wide_as_it_must_be() -> None:
    scene = PAIR | {"carts": {**PAIR["carts"], "B": {"mass": 1.5, "position": 1.2}}}
    low, high = proved(scene)["band"]["v"]["A"][-1]

    def after(m: float) -> float:
        return (m - 0.9 * 1.5) / (m + 1.5) * 0.6

    assert low <= after(0.49) and after(0.51) <= high
    assert high - low < 2 * (after(0.51) - after(0.49))


def test_a_number_that_a_reader_sets_has_no_tolerance_any_more() -> None:
    exact = {"A.mass": 0.5, "B.mass": 1.5, "B.position": 1.2}
    assert proved(PAIR, set=exact)["band"] is None
    low, high = map(float, proved(PAIR, set=exact)["certificate"]["final"]["v"]["A"])
    assert high - low < 1e-14


def test_pieces_are_all_of_a_tolerance_and_never_more_than_promised() -> None:
    for count in range(1, 7):
        halves = {f"C{k}.mass": Fraction(1, 100) for k in range(count)}
        found = list(pieces(halves))
        assert len(found) <= MOST_PIECES
        first = [spans["C0.mass"] for spans in found]
        assert min(low for low, _ in first) == -Fraction(1, 100)
        assert max(high for _, high in first) == Fraction(1, 100)
        assert sum(high - low for low, high in set(first)) == Fraction(1, 50)


def test_a_reason_goes_to_the_page_as_a_template() -> None:
    scene = PAIR | {"contact": {"law": "hertz", "restitution": 0.9, "stiffness": 1e4}}
    told = proved(scene)["certificate"]
    code = "{what} has no bound: its force is not linear"
    assert told["reason"] == {"code": code, "values": {"what": "hertz"}}


def test_too_many_changes_for_a_page_are_refused_by_number() -> None:
    row = {"A": {"mass": 1, "position": 0.2, "velocity": 1}, "B": {"mass": 1, "position": 0.6}}
    box = {"left": "wall", "right": "wall", "length": 1}
    scene = {
        "carts": row,
        "track": box,
        "until": 900,
        "contact": {"law": "instant", "restitution": 1},
    }
    told = proved(scene)["certificate"]
    assert told["order"] == "not-provable"
    assert told["reason"]["code"] == "there are more than {most} changes"


def test_a_proof_tells_all_along_that_it_is_at_work() -> None:
    """A page takes a Python without a sign for lost, and a slow laptop proves for a minute."""
    signs: list[int] = []
    instants = [0.1 * k for k in range(1, 40)]
    found = certify(read_scene(PAIR), limit=Limit(alive=lambda: signs.append(1)), instants=instants)
    assert found.x
    assert len(signs) > len(instants)
