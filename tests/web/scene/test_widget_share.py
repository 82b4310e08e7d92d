"""What a reader takes along: values, links and blocks that bring the same run back."""

from __future__ import annotations

import csv
import io
from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.pages.text.yaml.source import load
from sim.scene import read_fence
from tests import registry
from tests.web.scene.given.widget_site import COASTING, MEETING, STRUCK, baked, in_node


def facts(fence: dict[str, Any]) -> dict[str, Any]:
    described, header, numbers = baked(fence)
    controls = [
        {"set": c.set, "unit": c.unit, "low": c.shown(c.low), "high": c.shown(c.high)}
        | {"step": c.shown(c.step)}
        for c in described.controls
    ]
    plain = {"id": described.id, "scene": dict(described.plain), "show": list(described.show)}
    plain |= {"slow": described.slow, "forces": described.forces, "camera": described.view_speed}
    plain["controls"] = controls
    return {"fence": plain, "header": header, "numbers": list(numbers)}


def outcome(plain: dict[str, Any], changes: dict[str, Any]) -> Any:
    header, _ = answer({"id": 0, "kind": "run", "scene": plain, "set": changes})
    assert header["ok"], header
    return header["final"]


@pytest.mark.parametrize("fence", [MEETING, COASTING, STRUCK], ids=lambda fence: fence["id"])
def test_a_copied_block_is_a_good_one_and_runs_the_same(fence: dict[str, Any]) -> None:
    changes: dict[str, Any] = {"A.mass": 2, "until": "3 s"}
    block = in_node(
        """const { sceneBlock } = await import(source + "/scene/take-along/share.js");
        give(sceneBlock(data.fence, data.changes));""",
        {**facts(fence), "changes": changes},
    )
    assert block.startswith("```scene\n")
    plain = dict(load(block.removeprefix("```scene\n").removesuffix("```\n")).plain)
    copied = read_fence(plain)
    assert copied.id == f"{fence['id']}-copy"
    assert outcome(dict(copied.plain), {}) == outcome(dict(read_fence(fence).plain), changes)


def test_a_link_brings_the_state_back_and_a_hostile_one_is_refused() -> None:
    settings = {"A.mass": 2.5, "contact.restitution": "0.5", "A.velocity": "3 km/h"}
    back, others = in_node(
        """const { linkTo, readLink } = await import(source + "/scene/take-along/share.js");
        const link = linkTo("meeting", data.settings, 1.25);
        const hostile = ["carts:meeting?A.mass=%E0%A4%A", "carts:meeting?__proto__.x=1",
          "carts:meeting?A.mass=" + "9".repeat(80), "carts:meeting?" + "a=1&".repeat(3000),
          "carts:other?A.mass=1", "below", "carts:meeting?<script>=1"];
        give([readLink("#" + link, "meeting"), hostile.map((text) => readLink("#" + text, "meeting"))]);""",  # noqa: E501
        {"settings": settings},
    )
    assert back == {"settings": {**settings, "contact.restitution": 0.5}, "t": 1.25}
    assert [other and list(other) for other in others] == [
        *[["problem"]] * 4, None, None, ["problem"]
    ]  # fmt: skip


def test_the_table_has_every_row_with_quantity_and_unit_in_its_head() -> None:
    given = facts(MEETING)
    text = in_node(
        """const { fromWire } = await import(view + "/trajectory.js");
        const { csv } = await import(source + "/scene/take-along/csv.js");
        const trajectory = fromWire(data.header, Float64Array.from(data.numbers));
        give(csv({ header: data.header, trajectory }, ["x", "F", "p"], 0));""",
        given,
    )
    rows = list(csv.reader(io.StringIO(text)))
    assert rows[0][:3] == ["t in s", "position x of A in m", "position x of B in m"]
    assert "contact force F on A by B in N" in rows[0]
    assert "momentum p of wall + Earth in kg m/s" in rows[0]
    assert len(rows) == 1 + given["header"]["rows"]
    assert [float(row[0]) for row in rows[1:]] == given["numbers"][: given["header"]["rows"]]
    assert {len(row) for row in rows} == {len(rows[0])}


def test_the_table_ends_where_the_run_was_watched_to() -> None:
    text = in_node(
        """const { fromWire } = await import(view + "/trajectory.js");
        const { csv } = await import(source + "/scene/take-along/csv.js");
        const trajectory = fromWire(data.header, Float64Array.from(data.numbers));
        give(csv({ header: data.header, trajectory }, ["x"], 0, 2));""",
        facts(MEETING),
    )
    times = [float(row[0]) for row in list(csv.reader(io.StringIO(text)))[1:]]
    assert times
    assert 1 < max(times) <= 2  # s, of 6


def test_every_test_scene_can_be_copied_as_a_block() -> None:
    names = [name for name in registry.NAMES if name != "slow-and-long"]
    scenes = {name: registry.plain(name) for name in names}
    blocks = in_node(
        """const { sceneBlock } = await import(source + "/scene/take-along/share.js");
        give(Object.entries(data).map(([name, scene]) => [name, sceneBlock({ id: "one", scene,
          show: ["x"], slow: "auto", forces: "shown", camera: 0, controls: [] }, {})]));""",
        scenes,
    )
    for name, block in blocks:
        plain = dict(load(block.removeprefix("```scene\n").removesuffix("```\n")).plain)
        assert read_fence(plain).scene == read_fence({"id": "one", **scenes[name]}).scene, name


def test_a_copied_block_has_its_views_buttons_and_whether_it_is_watched_first() -> None:
    presets = {"elastic": {"contact.restitution": 1}, "schwer: auf leicht": {"A.mass": "4 kg"}}
    scene = {key: value for key, value in MEETING.items() if key not in ("id", "controls")}
    block = in_node(
        """const { sceneBlock } = await import(source + "/scene/take-along/share.js");
        give(sceneBlock({ id: "one", scene: data.scene, show: ["v"], slow: "auto", camera: 0,
          forces: "shown", controls: [], opened: ["lens", "ruler"], watch: "free",
          presets: data.presets }, {}));""",
        {"scene": scene, "presets": presets},
    )
    read = read_fence(dict(load(block.removeprefix("```scene\n").removesuffix("```\n")).plain))
    assert read.opened == ("lens", "ruler")
    assert read.watch == "free"
    assert read.presets == presets


def test_the_table_tells_the_forces_of_effects_with_who_exerts_them() -> None:
    rough = {"friction": {"coefficient": "0.02"}}
    push = {"push": {"cart": "A", "force": "0.1 N", "until": "1 s", "by": "fan"}}
    given = facts({**MEETING, "effects": [rough, push]})
    text = in_node(
        """const { fromWire } = await import(view + "/trajectory.js");
        const { csv } = await import(source + "/scene/take-along/csv.js");
        const trajectory = fromWire(data.header, Float64Array.from(data.numbers));
        const run = { header: data.header, trajectory };
        give([csv(run, ["x", "F"], 0), csv(run, ["x", "v"], 0), csv(run, ["R"], 0)]);""",
        given,
    )
    heads, *rows = list(csv.reader(io.StringIO(text[0])))
    first = dict(zip(heads, rows[0], strict=True))
    assert float(first["force on A by fan (pushes from outside) in N"]) == pytest.approx(0.1)
    rubbing = float(first["force on A by the track (friction) in N"])
    assert rubbing == pytest.approx(-0.02 * 0.5 * 9.81)
    assert "force on" not in text[1]
    resultants = next(csv.reader(io.StringIO(text[2])))
    assert resultants[1] == "resultant force R of A in N"
    assert [head for head in resultants if "R of" in head and " by " in head] == []
    assert "F on A by fan in N" in resultants
