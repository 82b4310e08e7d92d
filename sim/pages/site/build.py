"""One build of the site, whatever generator runs it: what is collected on the way, and the end.

A generator's shell makes one `SiteBuild`, asks it for a `Page` before each Markdown file, hands
over what came out, lets it finish the HTML and calls `complete` when all pages are written.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from sim.pages import licences
from sim.pages.blocks.extension import Page
from sim.pages.blocks.scene_block import SiteIds
from sim.pages.classroom import practice_keys
from sim.pages.classroom.practice_keys import practice_key
from sim.pages.findings import Finding, SiteError
from sim.pages.head.page_head import Needs, finish, needs_of
from sim.pages.head.policy import Audience, inline_scripts, is_trusted
from sim.pages.language import (
    ENGLISH,
    UnknownLanguageError,
    language_folder,
    of_page,
    own_words_script,
    words_script,
)
from sim.pages.offline import Hosting
from sim.pages.prepared import FOLDER as PREPARED
from sim.pages.single import to_download
from sim.pages.site import files as site_files
from sim.pages.site.carried import node_modules
from sim.pages.site.ids_twice import ids_twice
from sim.pages.site.own_files import strangers
from sim.pages.site.site_id import check_site_id
from sim.pages.teach.doors import Doors
from sim.pages.text.formulas import Formulas
from sim.pages.text.lesson_places import described, shown
from sim.pages.text.lesson_text import language_findings
from sim.pages.text.not_found import with_help
from sim.pages.translate.languages import Languages

_STATISTICS = {"numpy", "scipy"}


@dataclass(slots=True)
class SiteBuild:
    """`root`: the folder of mkdocs.yml. `site_id`: the name that answers are stored under."""

    root: Path
    audience: Audience
    site_id: str
    report: Callable[[Finding], None]
    ids: SiteIds = field(default_factory=SiteIds)
    asked: dict[str, frozenset[str]] = field(default_factory=dict)  # packages by page
    needs: dict[str, Needs] = field(default_factory=dict)
    trusted: list[re.Pattern[str]] = field(default_factory=list)
    keys: dict[str, dict[str, Any]] = field(default_factory=dict)
    done: frozenset[str] | None = None  # packages of the runtime that the site has already
    doors: Doors = field(init=False)
    teacher_word: str = ""  # asked for by teacher mode, and by the key to all questions without it
    hosting: Hosting | None = None  # for a web server
    lessons: Path | None = None  # the folder of lessons: scenes in there are watched first
    prepared: dict[str, str] = field(default_factory=dict)  # scripts with runs, by name
    languages: Languages = field(default_factory=Languages)
    formulas: Formulas = field(init=False)

    def __post_init__(self) -> None:
        self.doors = Doors(self.root)
        self.formulas = Formulas(node_modules(self.root))
        check_site_id(self.site_id)

    @property
    def packages(self) -> frozenset[str]:
        """The Python packages that the pages need."""
        return frozenset().union(*self.asked.values())

    def page(
        self, path: Path, *, whole: str, markdown: str, stated: object = None, theme: str = ENGLISH
    ) -> Page:
        """The page of the lesson at `path`; `markdown`: what of `whole` is to be rendered.

        `stated`: the language that its front matter names; `theme`: that of the generator's theme.
        """
        # Generators cut the front matter off: findings count lines of the whole file.
        first_line = 1 + whole.replace("\r\n", "\n").count("\n") - markdown.count("\n")
        watch = "first" if self.lessons and path.is_relative_to(self.lessons) else ""
        report, lesson = self.report, described(path, self.root)
        if made := self.languages.at(path):
            lesson, report = made.described(self.root), made.reporting(report)
        lesson = replace(lesson, watch=watch)
        self.ids.forget(lesson.file)  # a preview makes a page again
        page = Page(lesson, first_line, self.ids, report, late={})
        page.prepares = self.audience != "preview" and bool(watch or path.name == "index.md")
        try:
            page.language = of_page(stated, lesson.file, theme)
        except UnknownLanguageError:
            for finding in language_findings(whole, lesson):
                self.report(finding)
        return page

    def rendered(self, name: str, page: Page, html: str) -> None:
        """Note what the page `name` needs, now that it is rendered."""
        lesson = name.rpartition(".")[0].rpartition("/")[2]
        outline = page.items.outline(lesson) if page.items.answers else None
        scenes, foot = page.scenes > 0, self._has_foot(name)
        self.needs[name] = needs_of(
            html, scenes=scenes, outline=outline, language=page.language, hosted=foot
        )
        for finding in ids_twice(html, page.lesson.file, self.ids):
            (page.report or self.report)(finding)
        self.doors.note(name, page.lesson.file, page.language)
        if key := practice_key(self.site_id, lesson, page):
            self.keys[name] = key
        self.prepared |= page.prepared
        self.asked[name] = frozenset(page.packages) | _own_packages(self.needs[name])

    def finished(self, html: str, assets: str, name: str | None = None) -> str:
        """The page with its policy and scripts; `assets` leads from it to assets/carts/."""
        html = html if name else with_help(html, assets.removesuffix(site_files.ASSETS))
        needs = self.needs.get(name, Needs()) if name else Needs()
        html = self.formulas.drawn(html) if needs.formulas else html
        if any(other.scenes for other in self.needs.values()):  # else there is no Python to do it
            html = self.doors.with_door(html, name, assets, self.ids.used)
        if name and self.hosting and needs.hosted:
            lesson = name if self._is_lesson(name) else ""
            html = to_download.with_place(html, assets, lesson=lesson, kept=self.hosting.offline)
        page = finish(
            html,
            audience=self.audience,
            site_id=self.site_id,
            page_id=(name or "").rpartition(".")[0],
            teacher_word=self.teacher_word,
            assets=assets,
            needs=needs,
            trusted=self.trusted,
        )
        return self.hosting.head(page, name, assets) if self.hosting and name else page

    def refuse_links(self, *folders: Path) -> None:
        """Raises `SiteError` where a link leads out of a folder of the site."""
        for path in strangers(folders):
            raise SiteError(
                f"{shown(path, self.root)} is a link that leads out of this site or to nothing. "
                "Put a copy of the file in its place."
            )

    def strangers(self, html: str) -> list[str]:
        """Inline scripts in a page that are not the theme's: its policy will not let them run."""
        return [text for text in inline_scripts(html) if not is_trusted(text, self.trusted)]

    def assets(self) -> dict[str, bytes]:
        """The files beside the pages, by their address in the site; raises `SiteError`."""
        try:
            return site_files.site_files(node_modules(self.root))
        except site_files.MissingFilesError as error:
            raise SiteError(str(error)) from error

    def complete(self, site: Path, report: Callable[[str], None]) -> None:
        """Write what can only be written when all pages are known; raises `SiteError`."""
        index = site / "search" / "search_index.json"
        if index.is_file():
            text = site_files.search_words(index.read_text(encoding="utf-8"))
            index.with_suffix(".js").write_text(text, encoding="utf-8")
        for language in {needs.language for needs in self.needs.values()} - {ENGLISH}:
            script = site / site_files.ASSETS / f"words.{language}.js"
            script.write_text(words_script(language), encoding="utf-8")
        for element, language in {
            (e, n.language) for n in self.needs.values() for e in n.own_words
        }:
            script = site / site_files.ASSETS / f"words-{element}.{language}.js"
            script.write_text(own_words_script(element, language), encoding="utf-8")
        self.formulas.write(site / site_files.ASSETS)
        for address, text in self.prepared.items():
            script = site / site_files.ASSETS / PREPARED / address
            script.parent.mkdir(parents=True, exist_ok=True)
            script.write_text(text, encoding="ascii", newline="\n")
        scenes = any(n.scenes or n.classroom or n.measured or n.law for n in self.needs.values())
        before = self.done
        if scenes:
            self._add_runtime(site, report)
        if before is not None and before == self.done:
            return  # a preview after an edit: all the rest is there
        modules = node_modules(self.root)
        packages = {*self.packages, *(["teacher"] if self.doors.made else [])}
        works = licences.notices(modules, scenes=scenes, packages=packages)
        (site / licences.FILE_NAME).write_text(licences.licence_file(works), encoding="utf-8")
        if self.hosting:
            lessons = {n: self.asked[n] for n in self.needs if self._is_lesson(n)}
            to_download.write_shells(site, lessons, self.root, report, self.report)
            self.hosting.write(site, self.site_id)  # the last: it lists all files

    def _keys_in_order(self) -> list[str]:
        """Pages with keys, translations first: reports take their texts from the last."""
        return sorted(self.keys, key=lambda name: (not language_folder(name), name))

    def _is_lesson(self, name: str) -> bool:
        """Whether the page can be had as one file: a lesson, but no translation of one, whose files
        would make a site twice as large."""
        return self._among_lessons(name) and name not in self.languages.made

    def _among_lessons(self, name: str) -> bool:
        return self.lessons is not None and name.startswith(f"{self.lessons.name}/")

    def _has_foot(self, name: str) -> bool:
        """Whether a reader on a web server is told at the page's foot how to take it home."""
        return self.hosting is not None and (self._among_lessons(name) or name == "index.md")

    def _add_runtime(self, site: Path, report: Callable[[str], None]) -> None:
        from sim.pages import runtime  # only where a page has a scene

        try:
            assets = site / site_files.ASSETS
            (assets / "carts.js").write_bytes(site_files.scene_script())
            packages = {*self.packages, runtime.PROOF}
            if any(needs.classroom for needs in self.needs.values()):
                (assets / "class.js").write_bytes(site_files.class_script())
                (assets / practice_keys.FILE).write_bytes(
                    practice_keys.keys_script(self.keys[name] for name in self._keys_in_order())
                )
            asked = ("challenge", "worlds", "law", "hosted", "tools")
            needed = [n for n in asked if any(getattr(needs, n) for needs in self.needs.values())]
            for name in ("tour", "proof", *needed):
                (assets / f"{name}.js").write_bytes(site_files.own_script(name))
            if any(needs.measured for needs in self.needs.values()):
                (assets / "measured.js").write_bytes(site_files.measured_script())
                (assets / site_files.FILM).write_bytes(site_files.film_script())
            if self.doors.made:
                self.doors.write(assets, *site_files.teacher_files())
                packages.add(runtime.TEACHER)
            cache = runtime.default_cache(self.root)
            if self.done is None or not packages <= self.done:
                runtime.pack(site, packages=frozenset(packages), cache=cache, report=report)
                self.done = frozenset(packages)
        except (site_files.MissingFilesError, *runtime.ERRORS) as error:
            raise SiteError(str(error)) from error


def _own_packages(needs: Needs) -> frozenset[str]:
    """What the elements of a page load, beside what its scenes call for."""
    if not needs.classroom and not needs.measured:
        return frozenset()
    from sim.pages import runtime  # only where a page has such an element

    own = {runtime.CLASSROOM: needs.classroom, runtime.MEASURED: needs.measured}
    return frozenset({*_STATISTICS, *(name for name, asked in own.items() if asked)})
