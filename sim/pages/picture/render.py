"""From a scene and an instant to a drawing in the page: no script, no Python."""

from __future__ import annotations

from dataclasses import replace
from html import escape

from sim.pages.blocks.bake import bake
from sim.pages.drawing import draw
from sim.pages.findings import AuthorError
from sim.pages.language import tr
from sim.pages.picture.block import PictureBlock
from sim.pages.widget.baked import baked_values


def render_picture(picture: PictureBlock, number: int) -> str:
    """HTML of the `number`th picture of a page; raises `AuthorError` if its scene cannot run."""
    run = bake(picture.scene.fence.plain)
    if isinstance(run, list):
        raise AuthorError(map(picture.scene.places.finding, run))
    fence = replace(picture.scene.fence, id=f"picture-{number}")
    values = baked_values(fence, run.header, run.numbers)
    drawn = draw("picture", {"baked": values, "at": picture.at})
    name = escape(run.header.get("title") or tr("Carts on an air track"))
    return f'<div class="carts carts-picture" role="img" aria-label="{name}">{drawn}</div>'
