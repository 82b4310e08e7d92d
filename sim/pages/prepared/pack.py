"""Prepared runs as a script: gzip as base64, which a page on file:// can load and check.

bytes   = length of the text [8 bytes, little end first] + text + numbers
text    = JSON: the axes of the grid, the presets, and the header of each run, or why there is
          none; filled up with spaces to a multiple of 8 bytes
numbers = float64 [SI], the columns of one run after those of the other
"""

from __future__ import annotations

import hashlib
import json
import sys
from array import array
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sim.pages.blocks.bake import Run, bake_with, without_title
from sim.pages.gzipped import gzipped
from sim.pages.prepared.grid import Grid, grid_of
from sim.pages.runtime.payload import make_payload
from sim.scene import Fence

FOLDER = "prepared/"
"""Beside the page's script."""

MOST_BYTES = 120_000
"""Of gzip, for one scene: less than a picture, so that a lesson stays a light one."""

MOST_RUNS = 125
"""Three values of four sliders, eleven each of two. The whole site is built a tenth more slowly."""

MOST_NUMBERS = 150_000
"""In all runs of a scene: where one run is long, and so dear, few are prepared."""


MOST_KEPT = 64
"""Scenes whose runs a build remembers, in the worst case a fifth of a megabyte each."""


@dataclass(frozen=True, slots=True)
class Prepared:
    """What the page has to know, and the scripts by their names in `FOLDER`."""

    parts: tuple[Mapping[str, Any], ...]
    stops: Mapping[str, Sequence[float]]  # the values of each slider, in its own unit
    scripts: Mapping[str, str]
    runs: int
    size: int  # bytes of gzip


_kept: dict[str, Prepared | None] = {}


def prepare(fence: Fence, lesson_run: Run) -> Prepared | None:
    """The runs of `fence`, as many as fit; None where no grid fits. `lesson_run`: the default.

    They are the same in every language, and computed once: only texts may differ.
    """
    scene, _ = without_title(fence.plain)
    facts = (fence.id, scene, fence.controls, fence.switches, [*fence.presets.values()],
             fence.predict is None)  # fmt: skip
    key = hashlib.sha256(repr(facts).encode()).hexdigest()
    if key not in _kept:
        while len(_kept) >= MOST_KEPT:
            del _kept[next(iter(_kept))]
        _kept[key] = _prepared(fence, lesson_run)
    return _kept[key]


def _prepared(fence: Fence, lesson_run: Run) -> Prepared | None:
    numbers = lesson_run.numbers
    fit = 2 * MOST_BYTES // len(gzipped(numbers.tobytes()))  # together they are smaller
    most = min(MOST_RUNS, MOST_NUMBERS // len(numbers), fit)
    made: dict[str, Run] = {}  # a smaller grid has many of the settings of the one before
    while (grid := grid_of(fence, most)) is not None:
        found = _packed(fence, grid, made)
        if found.size <= MOST_BYTES:
            return found
        most = most * MOST_BYTES * 9 // (10 * found.size)
    return None


def _packed(fence: Fence, grid: Grid, made: dict[str, Run]) -> Prepared:
    scene, _ = without_title(fence.plain)
    settings = {repr(changes): changes for changes in grid.settings()}
    made.update({k: bake_with(scene, v) for k, v in settings.items() if k not in made})
    runs = [made[repr(changes)] for changes in grid.settings()]
    payload, scripts = make_payload(fence.id, _bytes(grid, runs))
    parts = tuple(dict(vars(part)) for part in payload.parts)
    sliders = {one.set: one for one in fence.controls}
    stops = {
        axis.set: [sliders[axis.set].shown(x) for x in axis.numbers]
        for axis in grid.axes
        if axis.set in sliders
    }
    return Prepared(parts, stops, scripts, len(runs), sum(part["size"] for part in parts))


def _bytes(grid: Grid, runs: Sequence[Run]) -> bytes:
    numbers = array("d")
    for run in runs:
        numbers.extend(run.numbers if run.header["ok"] else ())
    if sys.byteorder == "big":
        numbers.byteswap()
    plain = {
        "axes": [
            {"set": axis.set, "values": axis.values, "numbers": axis.numbers} for axis in grid.axes
        ],
        "presets": list(grid.presets),
        "headers": [run.header for run in runs],
    }
    text = json.dumps(plain, ensure_ascii=False, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 8)
    return len(text).to_bytes(8, "little") + text + numbers.tobytes()
