"""The text of a lesson between its blocks as HTML, as the build makes it.

The build's own Markdown extension takes blocks out and puts them in; here the page has most of
their elements already. What it does to the text itself (notes that wait, lengths of parts) is done
here by the same steps.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any
from xml.etree.ElementTree import Element

from sim.pages.language import speaking
from sim.pages.question import PageItems
from sim.pages.text.fence_scan import Block, after_front_matter

_MD_LINK = re.compile(r'(<a [^>]*href="(?![a-z]+:|#)[^":]*)\.md(["#])')


@dataclass(frozen=True, slots=True)
class Site:
    """What the build knows beside the lesson: other lessons' ids, Markdown's extensions, words."""

    ids: Mapping[str, str] = field(default_factory=dict)
    extensions: Sequence[str] = ()
    configs: Mapping[str, Any] = field(default_factory=dict)
    words: Mapping[str, str] = field(default_factory=dict)  # of the interface, in its language


def frame_of(
    lines: Sequence[str], parts: Sequence[Block], items: PageItems, site: Site
) -> str | None:
    """The Markdown of these lines with `<carts-place data-block="0">` for the first of its blocks;
    None where an extension of the site is not here. What waits is marked in the lines."""
    from markdown import Markdown

    from sim.pages.question.render import waits_line
    from sim.pages.text.steps import add_steps

    kept: list[str] = []
    done = after_front_matter(lines)
    for k, block in enumerate(parts):
        kept += [*lines[done : block.start], "", f"{block.indent}{_word(k)}", ""]
        done = block.end
    kept += lines[done:]
    try:
        md = Markdown(extensions=[*site.extensions], extension_configs={**site.configs})
    except (ImportError, KeyError, TypeError, AttributeError):
        return None
    scenes = {_word(k) for k, block in enumerate(parts) if block.name == "scene"}

    def waits(scene: str) -> str:
        return str(md.htmlStash.store(waits_line(scene, items.runs(scene))))

    def wide(note: Element) -> bool:
        return not scenes.isdisjoint(map(str.strip, note.itertext()))

    own = {block.stated_id for block in parts}
    spoken = partial(speaking, site.words)
    add_steps(md, waits=waits, wide=wide, taken=lambda: own, spoken=spoken)
    with speaking(site.words):
        made = md.convert("\n".join(kept))
    for k in range(len(parts)):
        place = f'<carts-place data-block="{k}"></carts-place>'
        made = made.replace(f"<p>{_word(k)}</p>", place).replace(_word(k), place)
    return _MD_LINK.sub(r"\1.html\2", made)


def _word(k: int) -> str:
    return f"cartsblock{k:05d}"
