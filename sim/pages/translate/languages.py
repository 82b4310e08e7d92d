"""The languages of a site's lessons: which pages there are, and what stands at the top of each."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from sim.pages.blocks.makers import Page
from sim.pages.findings import AuthorError, Finding
from sim.pages.translate.page_line import draft_line, language_line, languages_of, with_lines
from sim.pages.translate.translation import Translation, translations_of

# Every page loads the words of the search: of a lesson in several languages it has the title and
# the first lines in each, all else in English.
_PART = re.compile(r"<h([2-6]) ")
_UNSEARCHED = r"<h\1 data-search-exclude "


@dataclass(frozen=True, slots=True)
class Languages:
    """`made`: the lessons that are made of a catalogue, by their address; `lessons`: addresses of
    those that somebody wrote. `folder`: where lessons lie."""

    folder: Path = Path()
    lessons: tuple[str, ...] = ()
    made: Mapping[str, Translation] = field(default_factory=dict)

    @classmethod
    def of(
        cls, folder: Path, root: Path, lessons: Iterable[Path], report: Callable[[Finding], None]
    ) -> Languages:
        """Of the `lessons` in a folder; catalogues that cannot be read are reported."""
        made: dict[str, Translation] = {}
        written = tuple(path.relative_to(folder.parent).as_posix() for path in lessons)
        for path in (path for path in lessons if path.parent == folder):
            try:
                for one in translations_of(path, folder, root):
                    made[one.source.page.relative_to(folder.parent).as_posix()] = one
            except AuthorError as error:
                for finding in error.findings:
                    report(finding)
        return cls(folder, written, made)

    def at(self, path: Path) -> Translation | None:
        """The lesson that is made for the page at `path`, if one is."""
        inside = path.is_relative_to(self.folder.parent)
        return self.made.get(path.relative_to(self.folder.parent).as_posix()) if inside else None

    @property
    def paths(self) -> list[Path]:
        """Where the files of the made lessons would lie, language by language."""
        pages = (one.source.page for one in self.made.values())
        return sorted(pages, key=lambda page: page.parent.name)

    def with_lines(self, html: str, uri: str, page: Page) -> str:
        """The content of the page at `uri` with its languages, and how far its translation is."""
        lines = language_line(uri, languages_of(uri, (*self.lessons, *self.made)), page.language)
        if one := self.made.get(uri):
            items = {item.id for quiz in page.items.quizzes for item in quiz.form.items}
            left, parts = one.counted(items)
            lines = draft_line(page.language, draft=one.draft, left=left, parts=parts) + lines
            html = _PART.sub(_UNSEARCHED, html)
        return with_lines(html, lines) if lines else html
