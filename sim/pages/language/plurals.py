"""The forms of a sentence that counts: which there are, and which of them a number takes.

A `.po` file gives all forms of its language, and in its head gettext's expression for the form of
a number (`Plural-Forms: nplurals=3; plural=…`). A page gets no expression, which its policy would
not let it run, but a table: the form of each number below 200.
"""

from __future__ import annotations

from collections.abc import Sequence

NUMBERS = 200
"""So many numbers a rule of forms is asked for: all below 100, and each pair of last digits."""


def key_of(sentence: str | Sequence[str]) -> str:
    """What a sentence is called in `words`; of forms for one and for more the latter."""
    return sentence if isinstance(sentence, str) else sentence[-1]


def forms_of(said: str | Sequence[str]) -> tuple[str, ...]:
    """What is said, as one form or as all of them."""
    return (said,) if isinstance(said, str) else tuple(said)


def rule_of(expression: str) -> str:
    """The forms of the numbers from 0 to 199 by gettext's expression (`Plural-Forms: …; plural=`).

    Raises ValueError for one that looks at more of a number than its last two digits.
    """
    from gettext import c2py  # not in the page, which gets the table

    form = c2py(expression)
    rule = [form(n) for n in range(NUMBERS)]
    if any(form(n) != rule[100 + n % 100] for n in range(NUMBERS, 10 * NUMBERS)):
        raise ValueError(f"plural={expression}: more of a number than its last two digits counts")
    return "".join(map(str, rule))
