"""From a `law` block to `<carts-law>`. Without a script, and on paper, the law is code."""

from __future__ import annotations

from html import escape

from sim.pages.blocks.bake import Run
from sim.pages.language import told, tr_html
from sim.pages.law.block import ASK, LawBlock
from sim.pages.templates import element
from sim.pages.widget.baked import baked_values


def render_law(block: LawBlock, run: Run) -> str:
    """HTML of the element; `run`: of the law that the reader begins with."""
    facts = {
        "id": block.id,
        "hash": block.hash,
        "ask": block.ask,
        "file": block.file,
        "start": block.start,
        "baked": baked_values(block.fence, run.header, run.numbers),
    }
    ask = escape(told(ASK) if block.ask == ASK else block.ask)
    begins = tr_html("What the law is to begin with:")
    inside = (
        f'<p class="carts-law-ask">{ask}</p>\n'
        f'<div class="carts-law-paper"><p>{begins}</p>'
        f"<pre><code>{escape(block.start)}</code></pre></div>\n"
        '<div class="carts-law-live" hidden></div>'
    )
    return element("law", block.id, inside, facts)
