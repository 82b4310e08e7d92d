"""A report as one HTML file: to keep, to send, to print. No script, no request."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from sim.classroom.show.escaped import escape
from sim.classroom.show.report_page import ENGLISH, report_html
from sim.scene.said import in_words, template

TITLE = template("Class results")
_POLICY = "default-src 'none'; style-src 'unsafe-inline'"
_PAGE = (
    "body { font: 16px/1.5 Roboto, 'Segoe UI', 'Noto Sans', sans-serif; margin: 2rem auto; "
    "max-width: 56rem; padding: 0 1rem; color: #1b1f27; background: #fff; }\n"
    "@media print { body { margin: 0; font-size: 11pt; } }\n"
)


def style() -> str:
    """The style of a report, as the page has it too."""
    return Path(__file__).with_name("report.css").read_text(encoding="utf-8")


def standalone(
    reports: Sequence[Mapping[str, Any]],
    words: Mapping[str, str] = ENGLISH,
    language: str = "en",
) -> str:
    """The whole file, with one report after the other; `words`: each English sentence in the
    language.
    """
    title = in_words(TITLE, words)
    whole = "".join(report_html(report, words) for report in reports)
    opened = whole.replace("<details>", "<details open>")  # texts are escaped
    return whole_file(f"<h1>{escape(title)}</h1>\n{opened}", title, language=language)


def whole_file(body: str, title: str, sheet: str = "", language: str = "en") -> str:
    """A file of its own around HTML that is escaped; `sheet`: more style, after the report's."""
    return (
        f'<!doctype html>\n<html lang="{language}"><head><meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>\n{_PAGE}{style()}{sheet}</style></head>\n"
        f'<body class="carts-class-report">{body}\n'
        "</body></html>\n"
    )
