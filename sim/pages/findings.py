"""One finding of a check: where it is, what is wrong, how it should look.

The printed form is the one compilers use, so that editors and build logs make it clickable:

    worksheets/first.md:14:11: error: carts.A.mass: must be more than 0
      hint: for example mass: 0.5 kg
"""

from __future__ import annotations

import html
from collections.abc import Iterable
from dataclasses import asdict, dataclass, replace
from typing import Literal

Severity = Literal["error", "warning", "hint"]


@dataclass(frozen=True, slots=True, order=True)
class Finding:
    """A mistake of an author at `line` and `col` (from 1) of `file`."""

    file: str
    line: int
    col: int
    code: str
    message: str
    hint: str = ""
    severity: Severity = "error"

    def __str__(self) -> str:
        text = f"{self.file}:{self.line}:{self.col}: {self.severity}: {self.message}"
        return f"{text}\n  hint: {self.hint}" if self.hint else text

    def as_hint(self, told: str) -> Finding:
        """At the same place a hint in place of a mistake."""
        return replace(self, message=told, hint="", severity="hint")

    def as_row(self) -> dict[str, str | int]:
        """The row of `carts check --json`."""
        row = asdict(self)
        order = ("file", "line", "col", "severity", "code", "message", "hint")
        return {key: row[key] for key in order}

    def as_annotation(self) -> str:
        """A workflow command of GitHub Actions: the note stands on its line of the commit."""
        place = f"file={_value(self.file)},line={self.line},col={self.col}"
        text = f"{self.message}. {self.hint}" if self.hint else self.message
        kind = "notice" if self.severity == "hint" else self.severity
        return f"::{kind} {place}::{_plain(text)}"


def _plain(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _value(text: str) -> str:
    return _plain(text).replace(":", "%3A").replace(",", "%2C")


class SiteError(RuntimeError):
    """The site cannot be built; the message is for the person who builds it."""


class AuthorError(Exception):
    """Everything that is wrong with one block of a lesson, never an empty list."""

    def __init__(self, findings: Iterable[Finding]) -> None:
        self.findings = tuple(findings)
        super().__init__("\n".join(str(finding) for finding in self.findings))


AUTHOR_ERROR = "carts-author-error"
"""The class of the box below."""


def error_box(findings: tuple[Finding, ...], title: str = "This block cannot be shown") -> str:
    """What a reader of the preview sees in the place of a block with mistakes."""
    text = html.escape("\n".join(map(str, findings)))
    return (
        f'<div class="admonition failure {AUTHOR_ERROR}">'
        f'<p class="admonition-title">{title}</p>'
        f"<pre><code>{text}</code></pre></div>"
    )
