"""How long a part of a lesson takes, beside its heading, in the words of the page.

An author writes `## A part {: data-minutes=8 }`. The sheet draws what stands in `data-length`.
"""

from __future__ import annotations

from xml.etree.ElementTree import Element

from sim.pages.language import tr
from sim.pages.text.sections import OPTIONAL


def add_lengths(root: Element) -> None:
    """Each heading of a part with minutes says its length, in the language of now."""
    for heading in root.iter("h2"):
        if (n := heading.get("data-minutes")) is None:
            continue
        optional = OPTIONAL in (heading.get("class") or "").split()
        said = tr("optional, {count} min", count=n) if optional else tr("{count} min", count=n)
        heading.set("data-length", said)
