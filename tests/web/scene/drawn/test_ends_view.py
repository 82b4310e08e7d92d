"""What stands at an end of the track: its names and its picture; of a wall nothing new."""

from __future__ import annotations

import csv
import io
import re
from typing import Any

import pytest

from sim.pages.blocks.bake import bake_with
from sim.pages.text.yaml.source import load
from sim.pages.widget.render import render
from sim.scene import read_fence
from tests.web.scene.given.against_ends import AGAINST, THINGS, ends
from tests.web.scene.given.widget_site import baked, in_node

WALL = ends()
EDGE = {"wide": 604.0, "narrow": 276.0}  # x of the right end in the pictures of these scenes


def group(text: str, kind: str) -> str:
    """What stands at the right end in the wide or the narrow picture."""
    found = re.search(rf'carts-stage-{kind}".*?<g data-wall="right">(.*?)</g>', text, re.DOTALL)
    assert found is not None
    return found[1]


def paths(markup: str) -> dict[str, str]:
    """`d` of each path by what marks it."""
    found = {}
    for path in re.findall(r"<path [^>]*>", markup):
        given = dict(re.findall(r'([\w-]+)="([^"]*)"', path))
        name = given.get("data-part") or given.get("class") or "hatch"
        found[name] = given.get("d", "")
    return found


def test_a_page_with_a_wall_holds_nothing_of_this() -> None:
    text = render(*baked(WALL))
    assert "_is" not in text.split('<script type="application/json"')[1].split('"fence"')[0]
    for kind in EDGE:
        drawn = paths(group(text, kind))
        assert list(drawn) == ["carts-wall", "hatch", "carts-wall-face"]
        assert drawn["hatch"] == drawn["carts-wall"]


@pytest.mark.parametrize("what", THINGS)
@pytest.mark.parametrize("kind", EDGE)
def test_each_thing_stands_before_a_hatched_mounting(kind: str, what: str) -> None:
    drawn = paths(group(render(*baked(ends(right_is=what))), kind))
    plain = paths(group(render(*baked(WALL)), kind))
    edge = re.match(r"M([\d.]+) ", plain["carts-wall-face"])
    assert edge is not None
    assert drawn["carts-wall-face"].startswith(f"M{edge[1]} ")  # touched where a wall would be
    assert drawn["hatch"] in drawn["carts-wall"]
    mounting = [float(x) for x, _ in re.findall(r"([\d.]+) ([\d.]+)", drawn["hatch"])]
    assert mounting[0] == float(edge[1])  # below the track
    assert float(edge[1]) + 15 < mounting[2] < {"wide": 720, "narrow": 350}[kind]  # in the picture
    assert drawn["thing"]


def test_foam_has_bubbles_a_spring_a_coil_a_board_neither() -> None:
    looks = {what: group(render(*baked(ends(right_is=what))), "wide") for what in THINGS}
    lines = {what: paths(markup)["thing"] for what, markup in looks.items()}
    assert lines["foam"].count("a3.5 3.5") > 10
    assert "a" not in lines["spring"] + lines["board"]
    coils = [what for what, markup in looks.items() if 'class="carts-coil"' in markup]
    assert coils == ["spring"]


DRAWN = """const { thingPaths, depthOf } = await import(view + "/deformation/things.js");
const layout = { width: 720, track: 100, beam: 20 };
const xs = (path) => [...path.matchAll(/[ML]([-\\d.]+) /g)].map(([, x]) => Number(x));
give([1, -1].map((way) => {
  const wall = { edge: way > 0 ? 600 : 120, way, top: 36 };
  return data.dents.map((dent) => {
    const { face, hatch, was } = thingPaths(data.what, wall, layout, dent, 40);
    const far = (all) => all.map((x) => way * (x - wall.edge));
    const first = face.slice(0, face.indexOf("M", 1));
    return { face: Math.max(...far(xs(first))), back: far(xs(hatch))[2], was,
      depth: depthOf(data.what, wall, layout) };
  });
}));"""


@pytest.mark.parametrize("what", THINGS)
def test_it_gives_way_as_far_as_the_cart_comes_and_its_mounting_stands_still(what: str) -> None:
    right, left = in_node(DRAWN, {"what": what, "dents": [0, 10, 25, 80]})
    for seen in (right, left):
        assert [one["face"] for one in seen] == [0, 10, 25, 80]
        depth = seen[0]["depth"]
        assert [one["back"] for one in seen] == [depth, depth, max(depth, 33), 88]
        assert seen[0]["was"] == ""
        assert seen[1]["was"].startswith("M600 " if seen is right else "M120 ")


NAMES = """const b = await import(view + "/bodies.js");
give(["left", "A", "right"].map((name) => [b.body(name, data), b.brief(name, data)]));"""


@pytest.mark.parametrize(
    ("track", "names"),
    [
        ({}, [("the left wall", "left wall"), ("the right wall", "right wall")]),
        ({"left": "open"}, [("the wall", "wall"), ("the wall", "wall")]),
        ({"right_is": "foam"}, [("the wall", "wall"), ("the foam", "foam")]),
        (
            {"left_is": "spring", "right_is": "board"},
            [("the spring", "spring"), ("the board", "board")],
        ),
        (
            {"left_is": "foam", "right_is": "foam"},
            [
                ("the foam on the left", "foam on the left"),
                ("the foam on the right", "foam on the right"),
            ],
        ),
    ],
)
def test_a_sentence_and_a_label_name_it(
    track: dict[str, str], names: list[tuple[str, str]]
) -> None:
    left, cart, right = in_node(NAMES, {"left": "wall", "right": "wall", "length": 2, **track})
    assert [tuple(left), tuple(right)] == names
    assert cart == ["A", "A"]


TEXT = re.compile(r"(?<=>)[^<>]+(?=<)|(?<=aria-label=\")[^\"]*")


@pytest.mark.parametrize("what", THINGS)
def test_a_page_names_it_and_no_wall(what: str) -> None:
    fence = {**ends(right_is=what), "title": "A", "presets": {}}
    shown = render(*baked(fence)).split('<script type="application/json"')[0]
    told = "\n".join(TEXT.findall(shown))
    for name in (
        f"on A by the {what}",
        f"on the {what} by A",
        f"A touches the {what}.",
        f"{what} + Earth",
    ):
        assert name in told
    assert "wall" not in told


def test_arrows_that_are_asked_for_are_named_by_it() -> None:
    asked = {**ends(right_is="board"), "predict": {"arrows": ["A-right"]}}
    text = render(*baked(asked))
    assert ">force on A by the board</label>" in text
    assert ">force on the board by A</label>" in text


def facts(fence: dict[str, Any]) -> dict[str, Any]:
    described, header, numbers = baked(fence)
    kept = {"id": described.id, "scene": dict(described.plain), "show": ["v"], "slow": "auto"}
    kept |= {"forces": "shown", "camera": 0, "controls": []}
    return {"fence": kept, "header": header, "numbers": list(numbers)}


def test_the_saved_table_names_it() -> None:
    text = in_node(
        """const { fromWire } = await import(view + "/trajectory.js");
        const { csv } = await import(source + "/scene/take-along/csv.js");
        const trajectory = fromWire(data.header, Float64Array.from(data.numbers));
        give(csv({ header: data.header, trajectory }, ["F", "p"], 0));""",
        facts(AGAINST),
    )
    heads = next(csv.reader(io.StringIO(text)))
    assert "contact force F on A by the foam in N" in heads
    assert "momentum p of foam + Earth in kg m/s" in heads


def test_a_link_and_a_block_bring_it_back() -> None:
    changes = AGAINST["presets"]["soft spring"]
    back, block = in_node(
        """const { linkTo, readLink, sceneBlock } =
          await import(source + "/scene/take-along/share.js");
        const link = linkTo("against", data.changes, 1);
        give([readLink("#" + link, "against"), sceneBlock(data.fence, data.changes)]);""",
        {**facts(AGAINST), "changes": changes},
    )
    assert back == {"settings": changes, "t": 1}
    plain = dict(load(block.removeprefix("```scene\n").removesuffix("```\n")).plain)
    assert read_fence(plain).scene.track.right_is == "spring"


def test_a_prepared_run_names_what_stands_at_the_end() -> None:
    plain = read_fence(AGAINST).plain
    headers = [bake_with(plain, changes).header for changes in AGAINST["presets"].values()]
    told = [header["track"].get("right_is", "wall") for header in headers]
    assert told == ["foam", "spring", "board", "wall"]
