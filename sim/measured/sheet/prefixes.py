"""What loggers write around the head of a column: the run, the dataset, or whose column it is.

    Run 1: Time (s)     Position (m) Run #1     Data Set 2:Force(N)     Group 3: Time (s)

What stands before a colon in every head, that of the time too, is no cart where it is one dataset,
or where behind each stand a time and the same of two carts: a run. Else it is a cart (“A: x (m)”).
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.measured.sheet.heads import SIDEWAYS, holds_times, quantity_of
from sim.measured.sheet.whose import force_on, is_force
from sim.measured.units import head, narrow

_NUMBER = r"[\W_]{0,3}(?:(?:nr|no|n°|nº)\.?\s*)?(?P<number>\d{1,4})"
RUN_WORDS = (
    "run|trial|lauf|durchgang|messung|versuch|essai|mesure|ensayo|prueba|larian|cubaan|运行|实验"
)
"""What a run is called, before its number or over a column of numbers."""
_WORDS = (
    f"{RUN_WORDS}|data\\s?set|durchlauf|datensatz|messreihe|jeu de données|medición|"
    "conjunto de datos|数据集|测量"
)
_RUN = rf"(?:(?:{_WORDS}){_NUMBER}|(?P<latest>latest))"
_ALONE = re.compile(rf"[\W_]*{_RUN}[\W_]*", re.I)
_BEHIND = re.compile(rf"(?P<rest>.*?)[\s_,;-]*(?<![^\W_]){_RUN}\W*", re.I)
_BEFORE = re.compile(rf"\W*{_RUN}[\s_]+(?P<rest>.+)", re.I)
_COLON = re.compile(r"[\"'\s]*(?P<prefix>[^:()\[\]]{1,24}?)\s*:\s*(?P<rest>.+)")


def run_alone(text: str) -> str:
    """The run that a text names and nothing else: "2" for “Run #2”; empty: it names none."""
    match = _ALONE.fullmatch(narrow(text))
    return _run(match) if match else ""


def _run(match: re.Match[str]) -> str:
    return match["number"] or match["latest"]


def parted(cells: Sequence[str]) -> list[tuple[str, str]]:
    """Of each head the run, which may be empty, and what is left of it."""
    texts = [narrow(cell).strip() for cell in cells]
    found = [_COLON.fullmatch(text) for text in texts]
    datasets = _datasets([match for match, text in zip(found, texts, strict=True) if text])
    parts = []
    for text, match in zip(texts, found, strict=True):
        run = run_alone(match["prefix"]) if match else ""
        if match and (run or match["prefix"] in datasets):
            parts.append((run or datasets[match["prefix"]], match["rest"]))
        elif match and holds_times(*head(match["rest"])):  # “A: Time (s)”: the sensor of this cart
            parts.append(("", match["rest"]))
        else:
            parts.append(_around(text))
    return parts


def _datasets(heads: Sequence[re.Match[str] | None]) -> dict[str, str]:
    """The prefixes that name no cart, each with the run that it is; one alone is no run."""
    parts: dict[str, list[tuple[str, str]]] = {}
    for match in heads:
        if match is None:
            return {}
        parts.setdefault(match["prefix"], []).append(head(match["rest"]))
    if len(parts) == 1:
        return dict.fromkeys(parts, "")
    whole = all(any(holds_times(*one) for one in own) and _of_two(own) for own in parts.values())
    return {prefix: prefix for prefix in parts} if whole else {}


def _of_two(heads: Sequence[tuple[str, str]]) -> bool:
    """Whether two of the columns hold the same of two carts: then what stands before is a run."""
    seen: dict[str, set[str]] = {}
    for name, unit in heads:
        what, whose = quantity_of(name, unit)
        kind = "force" if is_force(name, unit) else what
        whose = (force_on(name) or "") if kind == "force" else whose
        if kind and kind != "time" and whose.lower() not in ("x", *SIDEWAYS):
            seen.setdefault(kind, set()).add(whose)
    return any(len(owners) > 1 for owners in seen.values())


def _around(text: str) -> tuple[str, str]:
    """A run that stands behind the head, or before it without a colon."""
    for pattern in (_BEHIND, _BEFORE):
        match = pattern.fullmatch(text)
        if match and match["rest"].strip():
            return _run(match), match["rest"]
    return "", text
