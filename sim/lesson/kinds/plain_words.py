"""Answers in words as they are compared; sim/web/src/question/marking/plain.js does the same.

Capitals, spaces and punctuation do not count. A point or a comma inside a number does: 1.5 is not
1:5, and .5 is not 5. Which of the two it is does not count either, as schools write both.
"""

from __future__ import annotations

import re
import unicodedata

_RAISED = re.compile("[⁺⁻⁰¹²³⁴-⁹]+")  # NFKC alone makes 102 of 10²
_DASH = re.compile("[−–‐]")
_NUMBER = re.compile(r"[.,]*[0-9]+(?:[.,]+[0-9]+)*")
_DECIMAL = re.compile(r"([0-9]*)[.,]([0-9]+)")
_POINT = "\ue000"  # stands for the point of a number while others are dropped; no text has it
_BLANKS = r" \t\n\v\f\r\u1680\u2028\u2029\ufeff"  # \s of JavaScript, after NFKC
_PUNCTUATION = re.compile(f"[{_BLANKS}.,;:!?“”„\"'’`()。、«»‹›‘…¿¡「」『』]+")
_SIGN = re.compile(r" ?([=+\-*/·×÷<>≤≥≈±^%°|&]) ?")
_DIGIT_FIRST = re.compile(r"([0-9]) ([^0-9 ])")
_DIGIT_LAST = re.compile(r"([^0-9 ]) ([0-9])")


def plain(text: str) -> str:
    """A text as it is compared; empty for one that is nothing but punctuation."""
    text = _RAISED.sub(r"^\g<0>", text.replace("´", "'"))
    text = _DASH.sub("-", unicodedata.normalize("NFKC", text).lower())
    text = _NUMBER.sub(_number, text.replace(_POINT, ""))
    text = _PUNCTUATION.sub(" ", text).strip(" ")
    text = _SIGN.sub(r"\1", text)
    text = _DIGIT_LAST.sub(r"\1\2", _DIGIT_FIRST.sub(r"\1\2", text))
    return text.replace(_POINT, ".")


def _number(found: re.Match[str]) -> str:
    """One number with its point kept; of 1,2,3 and of “no.5” the signs are punctuation."""
    one = _DECIMAL.fullmatch(found[0])
    if one is None or (not one[1] and found.string[: found.start()][-1:].isalpha()):
        return found[0].replace(".", " ").replace(",", " ")
    return f"{one[1] or 0}{_POINT}{one[2]}"
