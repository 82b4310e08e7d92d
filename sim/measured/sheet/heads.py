"""What a column holds, by its unit and by what it is called in schools of many languages.

A unit says it surely (m/s is a velocity, whatever stands before it), a word where no unit is.
Whose column it is stands behind or before: “Position 1”, “v_A”, “位置B”, “Cart B: velocity”.
"""

from __future__ import annotations

import re
from typing import Literal

from sim.measured.units import of_acceleration, plain_unit
from sim.scene.quantity import LENGTH_READ, SPEED, TIME_READ

Quantity = Literal["time", "pos", "vel", "acc"]

WORDS: dict[Quantity, str] = {
    "time": "t|time|timestamp|clock|zeit|uhrzeit|temps|tiempo|tempo|tid|tijd|czas|время|时间|時間|"
    "时刻|時刻|masa|நேரம்",
    "pos": "x|s|pos|position|place|distance|displacement|ort|weg|strecke|abstand|abscisse|posición|"
    "posicion|distancia|posizione|posição|positie|läge|położenie|положение|координата|位置|位移|距离|"
    "坐标|kedudukan|sesaran|jarak|நிலை|இடப்பெயர்ச்சி",
    "vel": "v|vel|velocity|speed|geschwindigkeit|vitesse|velocidad|velocità|velocidade|snelheid|"
    "hastighet|prędkość|скорость|速度|halaju|kelajuan|laju|வேகம்|திசைவேகம்",
    "acc": "a|acc|acceleration|beschleunigung|accélération|aceleración|accelerazione|aceleração|"
    "versnelling|acceleratie|przyspieszenie|ускорение|加速度|pecutan|முடுக்கம்",
}
SPEED_UNITS = r"(?:[cm]?m(?:/s|[\s·⋅*.]*s(?:\^?[-−]1|⁻¹))|km/h)"
_SPEED_HEAD = re.compile(
    rf"(?:[(\[/（]|\bin\b)\s*{SPEED_UNITS}(?:[\^²2]{{1,3}})?\s*[)\]）]?\s*(?:\w{{1,8}}\s*)?"
    r"(?:[\t;,|\"]|$|Run)",
    re.I,
)
_GLUED = "[A-Za-z0-9]{1,12}"  # behind a word; behind a letter: xA, x1, xb
_SEPARATED = r"[\s_.,:-]+(?:of\s+|ch\s*)?(?:(?:cart|wagen)\s+)?(?P<who>[A-Za-z0-9]{1,12})"


def longest_first(words: str, *, letters: bool = False) -> str:
    """Of what `|` parts the words, or the single `letters`; “pos” comes behind “position”."""
    chosen = [one for one in words.split("|") if (len(one) == 1 and one.isascii()) == letters]
    return "|".join(sorted(chosen, key=len, reverse=True))


def _named(words: str) -> tuple[re.Pattern[str], ...]:
    """A word or a letter, and whose it is behind it; a word, and a letter, behind whose it is."""
    word, letter = (longest_first(words, letters=one) for one in (False, True))
    return (
        re.compile(rf"\W*(?:{word})(?:{_SEPARATED}|(?:of\s+)?(?P<glued>{_GLUED}))?\W*", re.I),
        re.compile(rf"\W*(?:{letter})(?:{_SEPARATED}|(?P<glued>[A-Za-z]?\d{{1,2}}|[A-Za-z]))?\W*",
                   re.I),
        re.compile(rf"\W*(?P<who>.{{1,24}}?)[\s_.,:-]+(?:{word})\W*", re.I),
        re.compile(rf"\W*(?P<who>.{{1,24}}?)[\s_.,:-]+(?:{letter})\W*", re.I),
    )  # fmt: skip


_NAMED = {kind: _named(words) for kind, words in WORDS.items()}
_ANY = re.compile("|".join(WORDS.values()) + "|force|kraft", re.I)
CART_WORDS = "cart|wagen|glider|trolley|troli|kereta|chariot|carro|sensor"
_GENERIC = re.compile(rf"\b(?:smart|{CART_WORDS})\b", re.I)
NUMBERED = "id|no|nr|number"  # behind what is counted: “cart no”, “Run nr”
SIDEWAYS = ("y", "z", "vertical")
_TIME = re.compile(rf"\W*(?:{WORDS['time']})(?:[\s_.-]+[A-Za-z0-9]{{1,8}}|\d{{0,2}})\W*", re.I)
_WHO = re.compile(r".+?(?:[\s_.,-]+(?P<after>[A-Za-z0-9]{1,12})|(?P<digits>\d{1,2}))\W*")


def is_time(name: str) -> bool:
    """Whether a column with this name holds times; “Time 2” is the second sensor's."""
    return _TIME.fullmatch(name) is not None


def holds_times(name: str, unit: str) -> bool:
    """The same, by its unit too, whatever it is called."""
    return is_time(name) or _by_unit(unit) == "time"


def quantity_of(name: str, unit: str) -> tuple[Quantity | None, str]:
    """What a column holds, and whose it is: ("vel", "B") for “v_B” in m/s or “Cart B: velocity”."""
    if name.strip().lower() in SIDEWAYS:
        return None, ""
    kind = _by_unit(unit)
    for one, (word, letter, word_behind, letter_behind) in _NAMED.items():
        if one == "time" or kind not in (None, one):
            continue
        if match := word.fullmatch(name) or letter.fullmatch(name):
            return one, match["who"] or match["glued"] or ""
        match = word_behind.fullmatch(name)
        if kind == one:  # its unit tells: a letter alone might be a cart's
            match = match or letter_behind.fullmatch(name)
        if match and (whose := owner(match["who"])) is not None:
            return (None, "") if whose.lower() in SIDEWAYS else (one, whose)
    if kind is None or kind == "time":
        return kind, ""
    match = _WHO.fullmatch(name)
    whose = (match["after"] or match["digits"]) if match else ""
    return (None, "") if whose.lower() in SIDEWAYS else (kind, whose)


def owner(text: str) -> str | None:
    """The cart that stands before a quantity; None where a quantity stands there too."""
    if _ANY.fullmatch(text.strip()):
        return None if len(text.strip()) > 1 or text.strip() in "vV" else text.strip()
    return " ".join(_GENERIC.sub(" ", text).split()).strip("_.,:- ") or text.strip()


def _by_unit(unit: str) -> Quantity | None:
    unit = plain_unit(unit)
    if not unit:
        return None
    if unit in TIME_READ.units:
        return "time"
    if unit in LENGTH_READ.units:
        return "pos"
    if unit in SPEED.units:
        return "vel"
    return None if of_acceleration(unit) is None else "acc"


def has_speeds(head: str) -> bool:
    """Whether a line of heads names a unit of velocity or acceleration."""
    return _SPEED_HEAD.search(head) is not None
