"""Where the pages of a site have the way into teacher mode: a link at the foot of each lesson."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sim.pages.language import words
from sim.pages.teach.publish import Published, published

END = "</article>"  # of the text of a page, in the theme


@dataclass(slots=True)
class Doors:
    """The lessons of one build. `folder`: where they lie; None: this site has no teacher mode."""

    root: Path
    folder: Path | None = None
    extensions: Iterable[object] = ()
    configs: Mapping[str, Any] = field(default_factory=dict)
    lessons: dict[str, tuple[Path, str]] = field(default_factory=dict)
    made: dict[str, Published] = field(default_factory=dict)
    whole: bool = False  # a preview, which its teacher alone sees: nothing is withheld

    def note(self, name: str, file: str, language: str) -> None:
        """The page `name` is made of the file `file`, counted from the root."""
        path = self.root / file
        if self.folder and path.is_relative_to(self.folder) and path.is_file():
            self.lessons[name] = path, language

    def with_door(self, html: str, name: str | None, assets: str, ids: Mapping[str, str]) -> str:
        """The page with its link, if it is a lesson; all pages of the site have been rendered."""
        if name not in self.lessons or END not in html:
            return html
        path, language = self.lessons[name]
        made = published(
            path,
            self.root,
            ids=ids,
            extensions=self.extensions,
            configs=self.configs,
            words=words(language),
            whole=self.whole,
        )
        if made is None:
            return html
        self.made[name] = made
        return html.replace(END, f"{made.door(assets)}\n{END}", 1)

    def write(self, assets: Path, script: bytes, style: bytes) -> None:
        """The files of teacher mode below the folder `assets`."""
        (assets / "teacher.js").write_bytes(script)
        (assets / "teacher.css").write_bytes(style)
        for one in self.made.values():
            (assets / one.name).parent.mkdir(parents=True, exist_ok=True)
            (assets / one.name).write_bytes(one.script)
