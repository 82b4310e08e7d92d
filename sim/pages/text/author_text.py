"""The text of a file that an author wrote."""

from __future__ import annotations

from pathlib import Path

from sim.pages.findings import AuthorError, Finding

SAVE_AS = "save the file as UTF-8 (Notepad: Save as, Encoding: UTF-8)"
PLAIN = "save its text as plain text, UTF-8, under this name"
OTHERS = (
    (b"{\\rtf", "this is rich text (RTF)"),  # how TextEdit and WordPad save, whatever the name
    (b"%PDF-", "this is a PDF file"),
    (b"\xd0\xcf\x11\xe0", "this is an old Word document"),
)
"""How files begin that no program for plain text saved."""
ZIPPED = b"PK\x03\x04"
INSIDE = (
    (b"word/", "this is a Word document"),
    (b"mimetypeapplication/vnd.oasis.opendocument.text", "this is a LibreOffice document"),
)
"""What names of files in a zip tell of it."""
UTF_16 = (b"\xff\xfe", b"\xfe\xff")


def author_text(path: Path, shown: str) -> str:
    """The file's text; raises `AuthorError` where it is none, as `decoded` tells. `shown`: what the
    file is called for its author."""
    text = decoded(path.read_bytes(), shown)
    return text.replace("\r\n", "\n").replace("\r", "\n")


def decoded(data: bytes, shown: str) -> str:
    """What these bytes say; raises `AuthorError` where they are no text, or, at its line, where
    they are not UTF-8 (as Notepad saves “ANSI”). A mark at their beginning (“UTF-8 with BOM”) is
    none of the text, as the generator reads it too."""
    if other := _another_kind(data):
        raise AuthorError([Finding(shown, 1, 1, "not-text", other, PLAIN)])
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        message = "this is not UTF-8 text"
        raise AuthorError([Finding(shown, line, 1, "not-text", message, SAVE_AS)]) from None


def _another_kind(data: bytes) -> str:
    """What the file is instead of text; empty where it may be text."""
    if data.startswith(ZIPPED):
        return next((told for name, told in INSIDE if name in data), "this is a zip file")
    told = next((told for begin, told in OTHERS if data.startswith(begin)), "")
    if not told and b"\0" in data and not data.startswith(UTF_16):
        return "this is no text: it holds bytes of the value 0"
    return told


def shown_here(path: Path) -> str:
    """A path as messages show it: from the current folder where that is possible."""
    here = Path.cwd()
    return (path.relative_to(here) if path.is_relative_to(here) else path).as_posix()
