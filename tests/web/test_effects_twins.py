"""What acts is drawn and told the same by Python and by the page."""

from __future__ import annotations

import re
from typing import Any

import pytest

from sim.pages.widget import render
from sim.pages.widget.effects_forces import forces_at
from sim.pages.widget.effects_props import props
from sim.pages.widget.effects_view import arrows, effects_view
from sim.pages.widget.effects_words import acting_sentences, push_marks
from sim.pages.widget.layout import lay_out
from sim.pages.widget.run import from_wire, value_at
from sim.pages.widget.scale_of import read_scales
from sim.pages.yaml_source import load
from sim.scene import apply_changes, read_fence, read_scene
from tests import registry
from tests.web.widget_site import baked, in_node

TIMES = (0.0, 0.3, 1.0, 1.7, 2.9)
CROWD = {
    "carts": {n: {"mass": 1, "position": f"{0.2 + 0.4 * k}"} for k, n in enumerate("ABCDE")},
    "track": {"length": "2.4 m", "left": "wall", "right": "wall"},
    "effects": [
        {"friction": {"coefficient": "0.02", "carts": ["A", "C"]}},
        {"drag": {"linear": "0.3", "quadratic": "0.1"}},
        {"incline": {"angle": "-3 deg"}},
        {"push": {"cart": "B", "force": "1 N", "until": "1 s", "by": "fan"}},
        {"spring": {"between": ["A", "B"], "stiffness": 2, "length": "0.1 m", "active": False}},
    ],
}
SCENES: dict[str, dict[str, Any]] = {
    name: registry.plain(name) for name in registry.NAMES if "effects" in registry.plain(name)
} | {"crowd": CROWD}


def drawn(fence: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """What Python draws and says of a scene, and what the page needs to do the same."""
    described, header, numbers = baked({"id": "scene", **fence})
    run = from_wire(header, numbers)
    scales = read_scales(header, described.controls, run, 0.0)
    layouts = [lay_out(header, scales, kind=k, camera=0, forces=True) for k in ("wide", "narrow")]
    pictures = []
    for layout in layouts:
        for t in TIMES:
            x = {name: layout.at(value_at(run.t, run.x[name], run.v[name], t)) for name in run.x}
            half = {b["name"]: b["length"] * layout.scale / 2 for b in header["bodies"]}
            x |= {"left": layout.at(0), "right": layout.at(header["track"]["length"] or 0)}

            def face(name: str, side: str, x: Any = x, half: Any = half) -> float:
                away = half.get(name, 0.0)
                return float(x[name] + (-away if side == "left" else away))

            pieces = props(header, layout, t, face, x.__getitem__)
            pictures.append(pieces + arrows(header, run, layout, scales.force, t, x.__getitem__))
    here = {
        "pictures": pictures,
        "forces": [forces_at(header, run, t) for t in TIMES],
        "words": [acting_sentences(header, numbers=told) for told in (False, True)],
        "marks": [[list(mark) for mark in push_marks(header, forces=f)] for f in (False, True)],
    }
    there = {
        "header": header,
        "numbers": numbers.tolist(),
        "layouts": [layout.as_dict() for layout in layouts],
        "force": scales.force,
    }
    return here, there


def test_effects_are_drawn_and_told_the_same() -> None:
    both = {name: drawn(fence) for name, fence in SCENES.items()}
    there = in_node(
        """const [e, f, p, t, w] = await Promise.all(["effects", "effects-forces", "effects-props",
          "trajectory", "effects-words"].map((name) => import(`${source}/${name}.js`)));
        const out = {};
        for (const [name, { header, numbers, layouts, force }] of Object.entries(data.scenes)) {
          const run = { header, trajectory: t.fromWire(header, Float64Array.from(numbers)) };
          const { x, v } = run.trajectory;
          const pictures = layouts.flatMap((layout) => data.times.map((time) => {
            const at = (m) => layout.origin + m * layout.scale;
            const centre = (name) => name === "left" ? at(0) : name === "right"
              ? at(header.track.length ?? 0)
              : at(t.valueAt(run.trajectory.t, x[name], v[name], time));
            const face = (name, side) => {
              const body = header.bodies.find((one) => one.name === name);
              const half = (body?.length ?? 0) * layout.scale / 2;
              return centre(name) + (side === "left" ? -half : half);
            };
            return [...p.props(header, layout, time, face, centre),
              ...e.arrows(run, layout, force, time, centre)];
          }));
          out[name] = { pictures, forces: data.times.map((time) => f.forcesAt(run, time)),
            words: [false, true].map((told) => w.actingSentences(header, told)),
            marks: [false, true].map((told) =>
              w.pushMarks(header, told).map(({ t, sentence }) => [t, sentence])) };
        }
        give(out);""",
        {"times": TIMES, "scenes": {name: page for name, (_, page) in both.items()}},
    )
    for name, (here, _) in both.items():
        assert there[name] == here, name


@pytest.mark.parametrize("name", ["push-a-train", "incline-friction-holds", "spring-pair"])
def test_a_prediction_hides_forces_and_their_numbers(name: str) -> None:
    """The set-up is drawn; how large a force is, and what comes of it, is not."""
    asked = {"id": "asked", **SCENES[name], "predict": {"text": "What happens?"}}
    page = render(*baked(asked)).partition('<script type="application/json"')[0]
    (acting,) = re.findall(r'class="carts-acting">([^<]*)<', page)
    assert not re.search(r"μ = |\d N", acting)
    assert "carts-acts" not in page
    assert "begins" not in page


def test_hidden_forces_of_effects_are_not_in_the_picture() -> None:
    fence = {"id": "hidden", **SCENES["balanced-push"], "forces": "hidden"}
    page = render(*baked(fence)).partition('<script type="application/json"')[0]
    assert "carts-acts" not in page
    assert "carts-hand" in page
    assert "0.0981" not in page


def test_what_is_switched_off_is_not_drawn() -> None:
    off = {
        **SCENES["friction-stop"],
        "effects": [{"friction": {"coefficient": 1, "active": False}}],
    }
    described, header, numbers = baked({"id": "off", **off})
    run = from_wire(header, numbers)
    scales = read_scales(header, described.controls, run, 0.0)
    layout = lay_out(header, scales, kind="wide", camera=0, forces=True)
    view = effects_view(header, run, layout, scales.force, told=True, forces=True)
    assert view == {"behind": [], "front": []}
    assert layout.slots  # its row is there: the picture keeps its size when it is turned on


def test_a_link_and_a_copied_block_keep_what_is_switched() -> None:
    fence = {"id": "crowd", **CROWD, "controls": [{"switch": "spring"}]}
    changes = {"friction.coefficient": 0.05, "effects.4.active": True, "push.active": False}
    described = read_fence(fence)
    facts = {
        "id": "crowd", "scene": dict(described.plain), "show": ["x"], "slow": "auto",
        "forces": "shown", "camera": 0, "controls": [], "switches": [{"set": "spring.active"}],
    }  # fmt: skip
    block, back = in_node(
        """const s = await import(source + "/share.js");
        give([s.sceneBlock(data.fence, data.changes),
          s.readLink(s.linkTo("crowd", data.changes, 0), "crowd").settings]);""",
        {"fence": facts, "changes": changes},
    )
    assert back == changes
    copied = read_fence(dict(load(block.removeprefix("```scene\n").removesuffix("```\n")).plain))
    assert copied.scene == read_scene(apply_changes(dict(described.plain), changes))
    assert copied.switches[0].value is True


def test_a_stretched_spring_pulls_both_ends_with_arrows_of_one_length() -> None:
    """B starts 0.2 m too far from A: 2 N/m times 0.2 m pulls A to the right and B to the left."""
    stretched = {
        "id": "stretched",
        "carts": {"A": {"mass": 1, "position": "0.4 m"}, "B": {"mass": 3, "position": "1.2 m"}},
        "track": {"length": "2 m"},
        "effects": [{"spring": {"between": ["A", "B"], "stiffness": 2, "length": "0.4 m"}}],
    }
    page = render(*baked(stretched)).partition('<script type="application/json"')[0]
    pushes = re.findall(r'data-on="([AB])"><path[^>]* d="M([\d.]+) [^>]*?L([\d.]+) [\d.]+L', page)
    for k in (0, 2):  # the wide picture, the narrow one
        (on_a, start_a, neck_a), (on_b, start_b, neck_b) = pushes[k : k + 2]
        assert (on_a, on_b) == ("A", "B")
        assert float(neck_a) > float(start_a)
        pulls = float(neck_a) - float(start_a), float(start_b) - float(neck_b)
        assert pulls[0] == pytest.approx(pulls[1], abs=0.2)  # drawn to tenths of a unit
    assert page.count("on A by B (spring): 0.400 N") == 1
    assert page.count("on B by A: 0.400 N") == 1  # on a phone there is less room
