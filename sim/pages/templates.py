"""How elements are written: the templates of a package, and JSON that a page can carry."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from sim.pages.language import tr_counted, tr_html

_UNSAFE = {ord(c): f"\\u{ord(c):04x}" for c in "<>&\u2028\u2029"}


@cache
def templates(package: str) -> Environment:
    """The templates of a package, in the folder templates/ beside its modules."""
    made = Environment(
        loader=PackageLoader(package),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        auto_reload=False,  # they change with the program, not while it runs
    )
    made.globals |= {"tr": tr_html, "tr_counted": tr_counted}
    made.filters["lower_first"] = lambda text: text[:1].lower() + text[1:]
    return made


def element(name: str, identity: str, inside: str, facts: Mapping[str, Any]) -> str:
    """`<carts-name>` with what stands in it, and what its script knows."""
    return (
        f'<carts-{name} id="{escape(identity)}" class="carts carts-{name}" data-state="still">\n'
        f'{inside}\n<script type="application/json" class="carts-{name}-baked">'
        f"{script_json(facts)}</script>\n</carts-{name}>"
    )


def script_json(value: Mapping[str, Any]) -> Markup:
    """JSON that can stand in a script element whatever the texts in it say."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return Markup(text.translate(_UNSAFE))
