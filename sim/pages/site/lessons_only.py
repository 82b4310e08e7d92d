"""A site of nothing but mkdocs.yml and worksheets/: pages that its author did not write.

Such a site says `docs_dir: worksheets`. It gets a home page that lists the lessons; and the page
"Class results" where its navigation names one. Look and Markdown: `usual_settings.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any
from urllib.parse import quote

import yaml

from sim.pages.language import tr, tr_counted
from sim.pages.text.fence_scan import after_front_matter
from sim.pages.text.plain_lines import lines_of
from sim.pages.text.sections import title_of

HOME = "index.md"
CLASS_RESULTS = "class-results.md"

_CLASS_PAGE = """\
---
title: {title}
description: {about}
hide: [toc]
---

# {title}

{how}

<div><carts-class id="class-results">
<p>{script}</p>
</carts-class></div>
"""


def _class_page() -> str:
    """The page in the language that is spoken now."""
    return _CLASS_PAGE.format(
        title=tr("Class results"),
        about=tr("Drop the answer files of a class here. Nothing leaves this computer."),
        how=tr(
            "Drop the answer files of your students here: single files, several at once, or a zip. "
            "With the answers of a test also its **key file** (`carts key` writes it). Nothing "
            "leaves this computer."
        ),
        script=tr("This part needs JavaScript. On the command line “carts class” does the same."),
    )


def ready_page(name: str, title: str, about: str, lessons: Mapping[str, Path]) -> str | None:
    """The Markdown of a page that such a site need not write, or None if there is none.

    `lessons`: their files by their address in the site.
    """
    if name == CLASS_RESULTS:
        return _class_page()
    if name == HOME:
        return "\n".join(_home(title, about, lessons))
    return None


def named_pages(nav: Any) -> Iterator[str]:
    """Every file that a navigation names."""
    if isinstance(nav, str):
        yield nav
    elif isinstance(nav, list):
        for item in nav:
            yield from named_pages(item)
    elif isinstance(nav, dict):
        for item in nav.values():
            yield from named_pages(item)


def without_class_results(nav: Any) -> Any:
    """The navigation of a site for students: that page is the teacher's."""
    if isinstance(nav, list):
        kept = [without_class_results(item) for item in nav]
        return [item for item in kept if item not in ({}, [], None)]
    if isinstance(nav, dict):
        kept_ = {key: without_class_results(item) for key, item in nav.items()}
        return {key: item for key, item in kept_.items() if item not in ([], None)}
    return None if nav == CLASS_RESULTS else nav


def _home(title: str, about: str, lessons: Mapping[str, Path]) -> Iterator[str]:
    yield from ("---", "hide: [navigation, toc]", "---", "", f"# {_plain(title)}", "")
    yield from ([_plain(about), ""] if about else [])
    for address, path in lessons.items():
        head = _head(path.read_text(encoding="utf-8-sig", errors="replace"))
        name = _plain(str(head.get("title") or path.stem))
        yield f"## [{name}]({quote(address)})"
        yield ""
        words = [_plain(str(head["description"]))] if head.get("description") else []
        words += (
            [tr_counted("1 minute.", "{n} minutes.", n=head["minutes"])]
            if isinstance(head.get("minutes"), int)
            else []
        )
        yield from ([" ".join(words), ""] if words else [])


def _head(text: str) -> dict[str, Any]:
    """The front matter of a lesson, and its first heading where that says no title."""
    lines = lines_of(text)
    top = after_front_matter(lines)
    try:
        head = yaml.safe_load("\n".join(lines[1 : max(1, top - 1)]))
    except (yaml.YAMLError, ValueError):  # a date that no calendar has, too
        head = {}
    title = title_of(lines[top:])
    first = {"title": title} if title else {}
    return first | (head if isinstance(head, dict) else {})


def _plain(text: str) -> str:
    """Text that Markdown shows as it is. It knows no backslash before & and <."""
    marks = re.sub(r"([\\`*_\[\]#$|])", r"\\\1", " ".join(text.split()))
    return marks.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
