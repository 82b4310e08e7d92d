"""A law that cannot be asked: which line, what is wrong, what would help."""

from __future__ import annotations


class WrongLawError(ValueError):
    """`line` counts from 1 in the text of the law; message and hint are for its author."""

    def __init__(self, file: str, line: int, message: str, hint: str = "") -> None:
        super().__init__(f"{file}:{line}: {message}")
        self.file, self.line, self.message, self.hint = file, line, message, hint


class EndlessError(BaseException):
    """Raised by a counting line. No law can catch it."""

    def __init__(self, line: int) -> None:
        super().__init__(line)
        self.line = line
