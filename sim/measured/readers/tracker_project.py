"""Tracker's project files (.trk): XML with the marks of point masses in pixels of the film.

A mark of frame n at (x, y) pixels, y downwards, with origin (x0, y0), angle a (anticlockwise) and
scale s pixels per unit of length:

    t = start + (n − first frame) Δt
    X = ((x − x0) cos a − (y − y0) sin a)/s ,   Y = −((x − x0) sin a + (y − y0) cos a)/s

X counts, or where nobody turned the axes the way along the track (sim.measured.direction). Frames
without a mark are left out. Nothing of the file is run and no entity of it is resolved.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from sim.measured.direction import Vector, along, of_film
from sim.measured.refusal import refuse, shown
from sim.measured.track import FEWEST, Reading, Track
from sim.measured.units import Kind, Units, factor
from sim.scene.said import said

ANEW = said("save the project anew")
DEEPEST = 60
LARGEST = 1e9

Marks = list[tuple[float, Vector, int]]
"""Of one point mass: time in s, place (X, Y) in m, line."""


@dataclass(slots=True)
class _Node:
    """An element: its name or class, the line it begins on, text and children."""

    name: str
    kind: str
    line: int
    text: str = ""
    inside: list[_Node] = field(default_factory=list)

    def get(self, name: str) -> _Node | None:
        """The property of this name: of the node or of the object in it."""
        for one in self.inside:
            if one.name == name:
                return one
            if one.name == "" and (found := one.get(name)):
                return found
        return None


def claims(text: str) -> bool:
    """An XML object of Tracker's."""
    start = text[:2000]
    return start.lstrip().startswith("<") and "cabrillo.tracker" in start


def read(text: str, units: Units) -> Reading:
    """All point masses of the project; raises ReadingError."""
    root = _parsed(text)
    panels = [one for one in _all(root) if one.kind.endswith(".TrackerPanel")]
    if not panels:
        reason = said("no film panel is in this project")
        raise refuse(root.line, reason, said("save one tab with the film"))
    panel = panels[0]
    masses = [one for one in _all(panel) if one.kind.endswith(".PointMass")]
    if not masses:
        raise refuse(
            panel.line,
            said("no point mass is marked"),
            said("Track → New → Point mass, for each cart"),
        )
    first = int(_number(panel, ("videoclip", "startframe"), 0.0))
    begin = 1e-3 * _number(panel, ("videoclip", "starttime"), 0.0)
    step = 1e-3 * _number(panel, ("clipcontrol", "delta_t"), 0.0)
    if not 0.0 < step < 1e3:
        reason = said("the time from frame to frame is not in it")
        raise refuse(panel.line, reason, said("set the frame rate"))
    axes, notes = _axes(panel, units)
    seen: list[tuple[str, Marks]] = []
    for mass in masses:
        name, marks = _marks(mass, (first, begin, step), axes)
        if len(marks) < FEWEST:
            count = str(len(marks))
            notes.append(said("{cart}: {count} marks, left out", cart=shown(name), count=count))
        else:
            seen.append((name, marks))
    if not seen:
        reason = said("no point mass has {least} marks", least=str(FEWEST))
        raise refuse(masses[0].line, reason, said("mark every frame"))
    if len(seen) > 2:
        names = ", ".join(shown(name) for name, _ in seen)
        reason = said("{count} point masses: {names}", count=str(len(seen)), names=names)
        raise refuse(panel.line, reason, said("leave two in the project"))
    axis, turned = of_film([[place for _, place, _ in marks] for _, marks in seen])
    rate = f"{1.0 / step:.4g}"
    notes.insert(0, said("Tracker's project, {rate} frames per second", rate=rate))
    tracks = tuple(_track(name, marks, axis) for name, marks in seen)
    assumed = frozenset[Kind]() if panel.get("length_unit") else frozenset[Kind]({"length"})
    return Reading("length", tracks, (*notes, *([turned] if turned else [])), assumed=assumed)


def _parsed(text: str) -> _Node:
    try:
        from xml.parsers import expat
    except ImportError:  # a page carries the modules that it needs at its start, and not this one
        hint = said("use `carts fit`, or in Tracker File → Export → Data file")
        raise refuse(1, said("a Tracker project cannot be read in this page"), hint) from None

    parser = expat.ParserCreate()
    root = _Node("", "", 1)
    stack = [root]

    def start(tag: str, attributes: dict[str, str]) -> None:
        line = parser.CurrentLineNumber
        if len(stack) > DEEPEST:
            reason = said("objects in objects without end")
            raise refuse(line, reason, said("is this Tracker's project?"))
        one = _Node(attributes.get("name", ""), attributes.get("class", ""), line)
        stack[-1].inside.append(one)
        stack.append(one)

    def end(tag: str) -> None:
        stack.pop()

    def characters(content: str) -> None:
        stack[-1].text += content

    def doctype(*_: object) -> None:
        raise refuse(parser.CurrentLineNumber, said("a document type: Tracker writes none"))

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler, parser.StartDoctypeDeclHandler = characters, doctype
    try:
        parser.Parse(text.replace(' encoding="UTF-16"', ""), True)
    except expat.ExpatError as error:
        lines = text.count("\n") + 1
        reason = said(
            "the XML breaks off or is damaged ({what})", what=expat.ErrorString(error.code)
        )
        raise refuse(min(error.lineno, lines), reason, ANEW) from None
    except (ValueError, UnicodeError) as error:
        if hasattr(error, "faults"):
            raise
        raise refuse(1, said("this is no XML text"), ANEW) from None
    return root


def _all(node: _Node) -> list[_Node]:
    found = [node]
    for one in node.inside:
        found += _all(one)
    return found


def _number(node: _Node, path: tuple[str, ...], usual: float) -> float:
    """A number inside; `usual` where it is not there."""
    found: _Node | None = node
    for name in path:
        found = found.get(name) if found else None
    if found is None:
        return usual
    try:
        value = float(found.text.strip())
    except ValueError:
        value = math.nan
    if not abs(value) <= LARGEST:
        reason = said(
            "{key} is “{text}”, which is no number here", key=path[-1], text=shown(found.text)
        )
        raise refuse(found.line, reason, ANEW)
    return value


def _axes(panel: _Node, units: Units) -> tuple[tuple[float, float, float, float], list[str]]:
    """Origin in pixels, angle in radians, metres per pixel; and notes."""
    coords = panel.get("coords")
    frames = [one for one in _all(coords) if one.kind.endswith("ImageCoordSystem$FrameData")
              ] if coords else []  # fmt: skip
    node = frames[0] if frames else panel
    scale = _number(node, ("xscale",), 0.0)
    if scale <= 0.0 or scale == 1.0:
        line = coords.line if coords else panel.line
        reason = said("the film has no length scale")
        raise refuse(line, reason, said("Calibration stick along a ruler"))
    unit_node = panel.get("length_unit")
    unit = unit_node.text.strip() if unit_node else units.length
    metres = factor(unit, "length")
    if metres is None:
        line = unit_node.line if unit_node else panel.line
        reason = said("“{unit}” is not a unit of length", unit=shown(unit))
        raise refuse(line, reason, said("m, cm or mm"))
    notes: list[str] = [said("{count} pixels for each {unit}", count=f"{scale:.4g}", unit=unit)]
    scales = {round(_number(one, ("xscale",), scale), 6) for one in frames}
    if len(scales) > 1:
        notes.append(said("the scale changes during the film: that of its first frame is taken"))
    angle = math.radians(_number(node, ("angle",), 0.0))
    origin = _number(node, ("xorigin",), 0.0), _number(node, ("yorigin",), 0.0)
    return (*origin, angle, metres / scale), notes


def _marks(
    mass: _Node, clock: tuple[int, float, float], axes: tuple[float, float, float, float]
) -> tuple[str, Marks]:
    name_node, data = mass.get("name"), mass.get("framedata")
    name = (name_node.text.strip() if name_node else "") or "cart"
    x0, y0, angle, metres = axes
    first, begin, step = clock
    marks: dict[int, tuple[Vector, int]] = {}
    for one in data.inside if data else ():
        index = one.name.strip("[]")
        if not (index.isascii() and index.isdigit() and len(index) < 8) or one.get("x") is None:
            continue
        x, y = _number(one, ("x",), 0.0) - x0, _number(one, ("y",), 0.0) - y0
        right = x * math.cos(angle) - y * math.sin(angle)
        up = -x * math.sin(angle) - y * math.cos(angle)
        marks[int(index)] = (right * metres, up * metres), one.line
    return name, [(begin + (n - first) * step, *marks[n]) for n in sorted(marks)]


def _track(name: str, marks: Marks, axis: Vector) -> Track:
    times, places, lines = zip(*marks, strict=True)
    return Track(name, times, tuple(along(axis, place) for place in places), lines)
