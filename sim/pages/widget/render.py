"""From a fence and its run to the complete `<carts-scene>` element."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from html import escape
from typing import Any

from sim.pages.blocks.bake import packages_of
from sim.pages.templates import script_json
from sim.pages.widget.baked import baked_values
from sim.pages.widget.worlds import WORLDS, render_worlds


def render(
    fence: Any, header: Mapping[str, Any], numbers: Sequence[float], *, drawn: bool = True
) -> str:
    """HTML of the element: its picture as the page's script draws it, and the baked run as JSON.

    `header` and `numbers` are a good answer of `sim.bridge.protocol.answer`. Where the fence asks
    for a prediction, nothing of the run but its start state gets into the HTML. Where it hides the
    forces, a second inside that shows them waits in a template until the reader has found one.
    Not `drawn`: without pictures, for a page that draws them itself.
    """
    values = baked_values(fence, header, numbers)
    inside, shown = _inside(values, drawn=drawn), ""
    if fence.forces == "hidden" and any(c["stiffness"] for c in header["contacts"]):
        open_fence = replace(fence, forces="shown", show=(*fence.show, "F"))
        all_values = baked_values(open_fence, header, numbers)
        differs = {key: value for key, value in all_values.items() if values.get(key) != value}
        data = escape(str(script_json(differs)))
        found = _inside(all_values, drawn=drawn, found=True)
        shown = f'<template class="carts-shown" data-baked="{data}">{found}</template>\n'
    worlds = render_worlds(fence)
    own = {WORLDS} if worlds else set()
    packages = " ".join(sorted({*fence.packages, *packages_of(header), *own}))
    asks = " carts-asks" if fence.predict else ""
    return (
        f'<carts-scene id="{escape(fence.id)}" class="carts{asks}" data-state="still" '
        f'data-packages="{packages}">\n{inside}\n'
        f'<script type="application/json" class="carts-baked">{script_json(values)}</script>\n'
        f"{shown}</carts-scene>{worlds}"
    )


def _inside(values: Mapping[str, Any], *, drawn: bool, found: bool = False) -> str:
    """What stands in the element before anything moves."""
    if not drawn:
        return ""
    from sim.pages.drawing import draw  # V8: only where a site is built

    return draw("scene", {"baked": values, "found": found})
