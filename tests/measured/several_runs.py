"""Logs of several runs in one file, as loggers export them."""

from __future__ import annotations

from collections.abc import Sequence


def beside(texts: Sequence[str]) -> str:
    """Logs of equal length as runs side by side, as loggers export them."""
    lines = [text.removeprefix("\ufeff").splitlines() for text in texts]
    heads = [",".join(f"{name.strip(chr(34))} Run #{k}" for name in rows[0].split(","))
             for k, rows in enumerate(lines, 1)]  # fmt: skip
    rows = [",".join(parts) for parts in zip(*(one[1:] for one in lines), strict=True)]
    return "\n".join([",".join(heads), *rows]) + "\n"


def below(texts: Sequence[str]) -> str:
    """Logs one under the other: the time starts anew."""
    first, *others = [text.splitlines() for text in texts]
    return "\n".join([*first, *(line for one in others for line in one[1:])]) + "\n"
