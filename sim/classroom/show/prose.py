"""An author's Markdown as plain words: for a line of a table or of a slip, where nothing is set."""

from __future__ import annotations

import re

_EMPHASIS = re.compile(r"(?<![\w*])(\*{1,3}|_{1,3})(?=\S)(.+?)(?<=\S)\1(?![\w*])")
_LINK = re.compile(r"!?\[([^\]]*)\]\([^)]*\)")
_FORMULA = re.compile(
    r"\\\((.+?)\\\)|\\\[(.+?)\\\]|\$\$(.+?)\$\$|(?<![\\\w$])\$(?=\S)([^$\n]+?)(?<=\S)\$(?![\w$])",
    re.DOTALL,
)
_RULE = re.compile(r"^[ |:-]*\|[ |:-]*\n", re.MULTILINE)  # below the head of a table
_ROW = re.compile(r"^ *\| *(.+?) *\|? *$", re.MULTILINE)
_CELLS = re.compile(r" *\| *")
_FRACTION = re.compile(r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}")
_WORDS = re.compile(r"\\(?:text|mathrm|operatorname|vec|overline)\{([^{}]*)\}")
_COMMAND = re.compile(r"\\([A-Za-z]+) ?|\\[,;:! ]")
_SIGNS = {
    "Delta": "Δ", "cdot": "·", "times": "×", "approx": "≈", "le": "≤", "leq": "≤", "ge": "≥",
    "geq": "≥", "neq": "≠", "ne": "≠", "pm": "±", "to": "→", "alpha": "α", "theta": "θ", "mu": "µ",
    "pi": "π", "sum": "Σ", "sqrt": "√", "degree": "°", "circ": "°",
}  # fmt: skip


def prose(markdown: str) -> str:
    """The words in one line, formulas as one would type them: m_A Δv_A = −m_B Δv_B."""
    text = _ROW.sub(lambda row: f"{_CELLS.sub(', ', row[1])};", _RULE.sub("", markdown))
    text = _FORMULA.sub(lambda found: _typed(found[found.lastindex or 0]), text)
    text = _LINK.sub(r"\1", text).replace("`", "")
    return " ".join(_EMPHASIS.sub(r"\2", _EMPHASIS.sub(r"\2", text)).split())


def _typed(formula: str) -> str:
    """A formula in one line: fractions with a stroke, Greek letters as themselves."""
    text = _WORDS.sub(r"\1", formula)
    text = _FRACTION.sub(lambda found: f"{_group(found[1])}/{_group(found[2])}", text)
    text = _COMMAND.sub(lambda found: _SIGNS.get(found[1], found[1]) if found[1] else " ", text)
    return text.replace("-", "−").replace("{", "").replace("}", "")


def _group(part: str) -> str:
    return f"({part})" if re.search(r"[+\-]", part.strip()) else part
