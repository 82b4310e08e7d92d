"""What goes over the wire, without a browser."""

from __future__ import annotations

import json

import pytest

from sim.bridge.protocol import answer
from tests import registry


def ask(plain, **more):
    return answer({"id": 3, "kind": "run", "scene": plain, **more})


@pytest.mark.parametrize("name", registry.NAMES)
def test_every_scene_is_answered_with_full_columns(name):
    header, numbers = ask(registry.plain(name))
    assert header["ok"] and header["id"] == 3
    assert len(numbers) == header["rows"] * len(header["columns"])
    times = list(numbers[: header["rows"]])
    assert header["columns"][0] == ["t"]
    assert times == sorted(times) and times[0] == 0.0 and times[-1] == header["until"]
    assert json.loads(json.dumps(header, allow_nan=False)) == header


def test_a_jump_of_the_force_has_two_samples_at_one_time():
    header, numbers = ask(registry.plain("paper-two-carts"))
    rows = header["rows"]
    column = {tuple(c): numbers[k * rows : (k + 1) * rows] for k, c in enumerate(header["columns"])}
    t, force, x = column["t",], column["F", "A-B"], column["x", "A"]
    doubled = [k for k in range(rows - 1) if t[k] == t[k + 1]]
    assert len(doubled) == 2
    assert force[doubled[0]] == 0.0 and force[doubled[0] + 1] > 3.8
    assert force[doubled[1]] < -3.1 and force[doubled[1] + 1] == 0.0
    assert all(x[k] == pytest.approx(x[k + 1], abs=1e-15) for k in doubled)


def test_a_change_arrives():
    header, _ = ask(registry.plain("paper-two-carts"), set={"A.mass": "2 kg"})
    assert header["bodies"][0]["mass"] == 2.0


@pytest.mark.parametrize(
    "request_",
    [
        {},
        {"kind": "dance"},
        {"kind": "run"},
        {"kind": "run", "scene": 7},
        {"kind": "run", "scene": {"carts": {"A": {"mass": "no"}}}},
        {"kind": "run", "scene": registry.plain("instant"), "set": {"A.mass": -1}},
        {"kind": "run", "scene": registry.plain("instant"), "set": {"B.colour": 1}},
        {"kind": "run", "scene": registry.plain("instant"), "set": {"A.mass": {"deep": []}}},
    ],
)
def test_whatever_is_asked_gets_an_answer_and_never_an_exception(request_):
    header, numbers = answer(request_)
    assert header["ok"] is False and len(numbers) == 0
    assert all(p["message"] for p in header["problems"])
    json.dumps(header, allow_nan=False)


def test_a_run_of_a_great_many_contacts_stays_small_enough_to_draw():
    plain = {
        "carts": {"A": {"mass": 1, "position": "0.5", "velocity": 30}},
        "track": {"left": "wall", "right": "wall", "length": 1},
        "contact": {"stiffness": 1e7},
        "until": 100,
    }
    header, numbers = ask(plain)
    assert header["ok"] and len(header["events"]) > 5_000
    assert len(numbers) < 1_000_000


def test_a_long_run_tells_that_it_is_at_work_and_so_do_its_samples(monkeypatch):
    """A page takes a Python that is silent for eight seconds for lost: on an old laptop a row of
    spheres that bounces for half a minute ended with “it may have run out of memory”."""
    of_run, of_samples = [], []
    monkeypatch.setattr("sim.bridge.protocol._at_work", lambda t, _: of_run.append(t))
    monkeypatch.setattr("sim.bridge.protocol.alive", lambda: of_samples.append(1))
    spheres = {
        "carts": {"A": {"mass": 1, "position": 0.3}, "B": {"mass": 1, "position": 0.7}},
        "track": {"left": "wall", "length": 0.9},
        "contact": {"law": "hertz", "restitution": 0.9, "stiffness": 10000},
        "effects": [{"incline": {"angle": "-5 deg"}}],
        "until": 4,
    }
    header, _ = ask(spheres)
    assert len(of_run) > 1 and of_run == sorted(of_run)
    assert len(of_samples) > header["rows"] / 20
