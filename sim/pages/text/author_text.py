"""The text of a file that an author wrote."""

from __future__ import annotations

from pathlib import Path

from sim.pages.findings import AuthorError, Finding

SAVE_AS = "save the file as UTF-8 (Notepad: Save as, Encoding: UTF-8)"
RICH_TEXT = "{\\rtf"  # how TextEdit and WordPad save, whatever the name


def author_text(path: Path, shown: str) -> str:
    """The file's text; raises `AuthorError`, at its line, where it is not UTF-8 (as Notepad saves
    “ANSI”). A mark at its beginning (“UTF-8 with BOM”) is none of the text, as the generator reads
    it too. `shown`: what the file is called for its author."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        message, hint = "this is not UTF-8 text", SAVE_AS
        finding = Finding(shown, line, 1, "not-text", message, hint)
    else:
        if not text.startswith(RICH_TEXT):
            return text
        message, hint = "this is rich text (RTF)", "save the file as plain text, UTF-8"
        finding = Finding(shown, 1, 1, "not-text", message, hint)
    raise AuthorError([finding])


def shown_here(path: Path) -> str:
    """A path as messages show it: from the current folder where that is possible."""
    here = Path.cwd()
    return (path.relative_to(here) if path.is_relative_to(here) else path).as_posix()
