"""YAML without what surprises authors: no tags, no anchors, no key twice."""

from __future__ import annotations

from functools import lru_cache

import yaml

KEPT = 2048
"""Texts whose nodes are kept: a lesson's blocks are read some five times when its page is made, and
again at each edit of `carts serve`."""

_ENDS_OF_YAML = "\x85\u2028\u2029"


class RefusedError(Exception):
    """Something that YAML knows and scenes do not use, at a line and column from 0."""

    def __init__(self, event: yaml.Event, message: str) -> None:
        super().__init__(message)
        self.message = message
        mark = event.start_mark
        self.line, self.col = (mark.line, mark.column) if mark else (0, 0)


class Loader(yaml.SafeLoader):
    """PyYAML's own composer, without anchors, aliases and tags (they can blow a text up).

    Its marks count lines as editors do: for YAML a line also ends at U+2028 and its like.
    """

    def __init__(self, text: str) -> None:
        self._text = text
        self._odd = any(sign in text for sign in _ENDS_OF_YAML)
        super().__init__(text)

    def get_mark(self) -> yaml.Mark:
        """Where it is now."""
        mark = super().get_mark()
        if self._odd:
            before = self._text[: mark.index]
            mark.line, mark.column = before.count("\n"), len(before) - before.rfind("\n") - 1
        return mark

    def compose_node(self, parent: yaml.Node | None, index: int) -> yaml.Node | None:
        """The next node, or RefusedError."""
        event = self.peek_event()  # type: ignore[no-untyped-call]
        if isinstance(event, yaml.AliasEvent) or getattr(event, "anchor", None):
            raise RefusedError(event, "anchors and aliases (& and *) are not used here")
        if getattr(event, "tag", None):
            raise RefusedError(event, f"the tag {shown_tag(event.tag)} is not used here")
        return super().compose_node(parent, index)


@lru_cache(maxsize=KEPT)
def composed(text: str) -> yaml.Node | None:
    """The nodes of a text, the same for every caller: nobody changes them.

    Raises RefusedError and what PyYAML raises.
    """
    loader = Loader(text)
    try:
        return loader.get_single_node()
    finally:
        loader.dispose()


def shown_tag(tag: str) -> str:
    """A tag as its author wrote it."""
    return "!!" + tag.removeprefix("tag:yaml.org,2002:") if tag.startswith("tag:") else tag
