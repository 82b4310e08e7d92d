"""What a page's policy forbids, found in its HTML."""

from __future__ import annotations

import re
from html.parser import HTMLParser


class _Blocked(HTMLParser):
    """Collects what the policy forbids, so that an author hears of it instead of wondering."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            target = (value or "").strip().lower()
            if name == "style" or name.startswith("on"):
                self.found.append(f"{name}= on <{tag}>")
            elif name in ("href", "src", "action") and target.startswith("javascript:"):
                self.found.append(f"{name}=javascript: on <{tag}>")
            elif tag != "a" and name in ("src", "href") and re.match(r"(https?:)?//", target):
                self.found.append(f"<{tag} {name}={value}>")
        if tag in ("style", "iframe", "object", "embed", "base"):
            self.found.append(f"<{tag}>")
        if tag == "script" and not any(name in ("src", "type") for name, _ in attrs):
            self.found.append("<script> with its text in the page")


def blocked(content: str) -> list[str]:
    """What in a page's own content the policy will not allow."""
    parser = _Blocked()
    parser.feed(content)
    return parser.found
