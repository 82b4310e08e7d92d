"""A “ #” that made the rest of a text unreadable: told in place of what YAML says of the rest."""

from __future__ import annotations

from collections.abc import Iterator

import yaml

from sim.pages.text.yaml.loader import Loader
from sim.pages.text.yaml.lost import CUT_OFF, PROSE_KEYS, is_quantity, place_of
from sim.pages.text.yaml.typos import CUT, HINT_CUT, Typo

_OPEN = (yaml.FlowMappingStartToken, yaml.FlowSequenceStartToken)
_CLOSE = (yaml.FlowMappingEndToken, yaml.FlowSequenceEndToken)
_WORDS = frozenset({"true", "false", "null", "~"})


def cut_off(text: str) -> Typo | None:
    """The first “ #” behind a text that goes on in the next line, or whose bracket closes behind
    the #. Remarks on lines of their own, texts in quotes and below | have no such token.
    """
    tokens = list(_tokens(text))
    depth = 0
    for k, one in enumerate(tokens):
        depth += isinstance(one, _OPEN) - isinstance(one, _CLOSE)
        if not isinstance(one, yaml.ScalarToken) or not one.plain:
            continue
        found = CUT_OFF.match(text, one.end_mark.index)
        if found and (_closes(text, found.end()) if depth else _goes_on(tokens, k)):
            return *place_of(text, found.start(1)), CUT, HINT_CUT
    return None


def _tokens(text: str) -> Iterator[yaml.Token]:
    """What can be read up to the mistake, and what was read ahead."""
    loader = Loader(text)
    try:
        while loader.check_token():
            yield loader.get_token()  # type: ignore[no-untyped-call]
    except yaml.YAMLError:
        yield from loader.tokens
    finally:
        loader.dispose()


def _closes(text: str, at: int) -> bool:
    """Whether the rest of the line closes more brackets than it opens."""
    rest = text[at - 1 :].partition("\n")[0]
    return sum((sign in "]}") - (sign in "[{") for sign in rest) > 0


def _goes_on(tokens: list[yaml.Token], k: int) -> bool:
    """Whether the free text of this token has another right behind it."""
    after = tokens[k + 1] if k + 1 < len(tokens) else None
    text = str(getattr(tokens[k], "value", ""))
    if not isinstance(after, yaml.ScalarToken) or text.lower() in _WORDS or is_quantity(text):
        return False
    if k < 2 or not isinstance(tokens[k - 1], yaml.ValueToken):
        return True
    key = str(getattr(tokens[k - 2], "value", ""))
    return key in PROSE_KEYS or key.isdecimal()
