"""The hand-in code: a form's chosen answers in twelve letters and digits, to write on paper.

60 bits as twelve letters of Crockford's alphabet (no I, L, O, U): 44 bits of answers in mixed
radix (each item one digit, 0: not answered) and a CRC of 16 bits over them and the form (its word
and hash). A CRC of 16 bits finds every wrong letter and every two neighbours that changed places;
a random text passes once in 65 536. The code names no student.
"""

from __future__ import annotations

import binascii
from collections.abc import Sequence

from sim.scene.said import said

ALPHABET = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
ANSWER_BITS, CHECK_BITS, LETTERS = 44, 16, 12
_READ_AS = str.maketrans({"O": "0", "I": "1", "L": "1"})


class HandInError(ValueError):
    """The code cannot be this form's; the message says why."""


def fits(options: Sequence[int]) -> bool:
    """Whether a form whose items have so many options each can be written as a code."""
    return bool(options) and all(options) and _size(options) <= 1 << ANSWER_BITS


def encode(options: Sequence[int], chosen: Sequence[int], form_hash: str) -> str:
    """The code; `chosen` counts from 1, 0: not answered."""
    if not fits(options) or len(chosen) != len(options):
        raise HandInError("this form is too long for a code")
    number = 0
    for count, choice in zip(options, chosen, strict=True):
        if not 0 <= choice <= count:
            raise HandInError("an answer is not one of the options")
        number = number * (count + 1) + choice
    whole = number << CHECK_BITS | _check(number, form_hash)
    letters = [ALPHABET[whole >> 5 * k & 31] for k in reversed(range(LETTERS))]
    return "-".join("".join(letters[k : k + 4]) for k in (0, 4, 8))


def decode(options: Sequence[int], code: str, form_hash: str) -> tuple[int, ...]:
    """The chosen answers; raises `HandInError` for a code that is not this form's."""
    text = "".join(c for c in code.upper().translate(_READ_AS) if c.isalnum())
    if len(text) != LETTERS or any(c not in ALPHABET for c in text):
        raise HandInError(said("a hand-in code has {n} letters and digits", n=f"{LETTERS}"))
    whole = 0
    for c in text:
        whole = whole << 5 | ALPHABET.index(c)
    number = whole >> CHECK_BITS
    if whole & (1 << CHECK_BITS) - 1 != _check(number, form_hash) or number >= _size(options):
        raise HandInError("a letter is wrong, or this is the code of another form")
    chosen = []
    for count in reversed(options):
        number, choice = divmod(number, count + 1)
        chosen.append(choice)
    return tuple(reversed(chosen))


def _size(options: Sequence[int]) -> int:
    size = 1
    for count in options:
        size *= count + 1
    return size


def _check(number: int, form_hash: str) -> int:
    return binascii.crc_hqx(form_hash.encode() + number.to_bytes(6, "big"), 0xFFFF)
