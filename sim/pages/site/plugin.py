"""The MkDocs plugin: a thin shell around `SiteBuild` and the Markdown extension.

Which events are used, and why: `config` (settings, the Markdown extension), `files` (lessons and
assets join the site), `env` (which scripts are the theme's), `page_markdown` and `page_content`
(tell the extension which page is made), `post_page` and `post_template` (policy and scripts),
`post_build` (runtime, search, licences).
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

from jinja2 import Environment
from mkdocs.config import config_options as c
from mkdocs.config.base import Config
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.plugins import BasePlugin, event_priority
from mkdocs.structure.files import File, Files
from mkdocs.structure.nav import Navigation
from mkdocs.structure.pages import Page as MkDocsPage
from mkdocs.utils import get_relative_url

from sim.pages.blocks.extension import CartsExtension, Page, set_page, with_late
from sim.pages.head.policy import Audience, trusted_scripts
from sim.pages.language import ENGLISH
from sim.pages.offline import Hosting, nowhere
from sim.pages.site import effect_pages, lessons_only, usual_settings
from sim.pages.site.build import SiteBuild
from sim.pages.site.files import ASSETS, SEARCH_FROM_DISK
from sim.pages.site.joined_files import (
    add_effect_pages,
    add_translations,
    leave_out,
    put_ready_pages,
)
from sim.pages.site.last_build import COMPILED, Preview, text_box
from sim.pages.site.messages import do_not_count_warnings, report, stopping
from sim.pages.site.site_id import facts_of
from sim.pages.teach.doors import Doors
from sim.pages.text.blocked import blocked
from sim.pages.text.lesson_list import lessons_in, with_lessons
from sim.pages.text.lesson_places import JOINING, check_folder, is_hidden
from sim.pages.text.page_meta import tell_theme
from sim.pages.text.theme_words import speak
from sim.pages.translate.languages import Languages
from sim.pages.translate.page_turns import own_lessons_first, turn_in_one_language

log = logging.getLogger("mkdocs.plugins.carts")


class CartsConfig(Config):  # type: ignore[no-untyped-call]
    """Settings in mkdocs.yml under `plugins: - carts:`."""

    lessons = c.Type(str, default="worksheets")  # their folder, and no other
    hosted = c.Type(bool, default=False)  # for a web server (true) or for double click (false)
    teacher_word = c.Type(str, default="")  # that opens it, and all questions; empty: a click does
    teacher_mode = c.Type(bool, default=True)  # “Change this lesson” at the foot of lessons
    class_results = c.Type(bool, default=True)  # the ready page, where the menu names it
    offline = c.Type(bool, default=True)  # hosted: readers' browsers keep the site for later


class CartsPlugin(BasePlugin[CartsConfig]):  # type: ignore[no-untyped-call]
    """One instance serves a whole `mkdocs serve`; what belongs to one build starts in `config`."""

    serving = False
    partial = False  # a preview after an edit: only what changed is made again
    progress: Callable[[int, int], None] | None = None  # steps done, steps in all
    build: SiteBuild
    page: Page
    preview: Preview

    def on_startup(self, *, command: Literal["build", "gh-deploy", "serve"], dirty: bool) -> None:
        """A preview shows an author's mistakes in the page instead of stopping at them."""
        self.serving = command == "serve"
        self.partial, self.preview = False, Preview()

    def on_config(self, config: MkDocsConfig) -> MkDocsConfig:
        """Settings that the site needs, and a fresh start for what this build collects."""
        root = Path(config.config_file_path).resolve().parent
        audience: Audience = "hosted" if self.config.hosted else "offline"
        if self.serving:
            audience = "preview"
            do_not_count_warnings()
        if self.partial:
            config.theme.static_templates.clear()
        else:
            with stopping():
                check_folder(self.config.lessons)
                site_id = str(facts_of(config.extra).get("site_id"))
                self.build = SiteBuild(root, audience, site_id, report)
        self.late: dict[str, dict[str, str]] = {}
        self.folder = root / self.config.lessons
        self.build.lessons = self.folder
        self.lessons_only = Path(config.docs_dir).resolve() == self.folder.resolve()
        usual_settings.fill_in(config, links=self.lessons_only)
        if self.lessons_only and not self.config.class_results and config.nav is not None:
            config.nav = lessons_only.without_class_results(config.nav)
        self.named = set(lessons_only.named_pages(config.nav))
        self.lessons = lessons_in(self.folder)
        self.build.languages = Languages.of(self.folder, root, self.lessons, report)
        if config.nav is not None:
            all_ = [*self.lessons, *self.build.languages.paths]
            config.nav = effect_pages.with_effects(with_lessons(config.nav, self.folder, all_))
        if audience == "hosted":
            with stopping():
                config.site_url = config.site_url or nowhere.address_told()
            about, address = config.site_description or "", config.site_url or ""
            self.build.hosting = Hosting(config.site_name, about, address, self.config.offline)
        self.build.teacher_word = self.config.teacher_word.strip()
        if self.config.teacher_mode:
            names, settings = config.markdown_extensions, config.mdx_configs
            alone = self.serving and config.dev_addr.host in ("127.0.0.1", "localhost")
            self.build.doors = Doors(root, self.folder, names, settings, whole=alone)
        config.use_directory_urls = False
        config.markdown_extensions.append(CartsExtension())  # type: ignore[arg-type]
        config.watch.append(str(self.folder))
        if audience == "offline":
            config.extra.setdefault("polyfills", []).append(SEARCH_FROM_DISK)
        if not config.site_url:
            config.theme.static_templates.discard("sitemap.xml")
        return config

    def on_files(self, files: Files, *, config: MkDocsConfig) -> Files:
        """Lessons and their pictures join the site; what only developers use is left out."""
        with stopping():
            self.build.refuse_links(Path(config.docs_dir), self.folder)
        if self.lessons_only:
            names = self.named | {lessons_only.HOME}
            put_ready_pages(files, config, self.folder, self.lessons, names)
        pictures = (p for p in sorted(self.folder.rglob("*")) if p.suffix.lower() in JOINING)
        shown = (p for p in pictures if not is_hidden(p.relative_to(self.folder)))
        for path in (*self.lessons, *shown):
            uri = f"{self.config.lessons}/{path.relative_to(self.folder).as_posix()}"
            file = File.generated(config, uri, abs_src_path=str(path))
            file.edit_uri = f"../{uri}"  # from docs/, where the generator believes it to be
            files.append(file)
        add_translations(files, config, self.build.root, self.build.languages.made)
        add_effect_pages(files, config)
        with stopping():
            for uri, content in self.build.assets().items():
                files.append(File.generated(config, uri, content=content))
        leave_out(files, config, from_disk=self.build.audience == "offline")
        return files

    def on_nav(self, nav: Navigation, *, config: MkDocsConfig, files: Files) -> Navigation:
        """Pages that are not made again keep their names in the menu; one turns in one language."""
        turn_in_one_language(nav.pages)
        if self.partial:
            self.preview.name_pages(nav)
        self.steps, self.step = 2 * len(files.documentation_pages()), 0
        return nav

    def _progress(self) -> None:
        self.step += 1
        if self.progress:
            self.progress(self.step, self.steps)

    def on_page_markdown(
        self, markdown: str, *, page: MkDocsPage, config: MkDocsConfig, files: Files
    ) -> str:
        """Tell the extension which page comes now, and on which line of its file it begins."""
        path = Path(page.file.abs_src_path or self.folder.parent / page.file.src_uri)
        tell_theme(page.meta, lesson=page.file.src_uri.startswith(f"{self.config.lessons}/"))
        self.page = self.build.page(
            path,
            whole=page.file.content_string,
            markdown=markdown,
            stated=page.meta.get("language"),
            theme=str(config.theme.get("language") or ENGLISH),
        )
        set_page(self.page)
        return markdown

    def on_page_content(
        self, html: str, *, page: MkDocsPage, config: MkDocsConfig, files: Files
    ) -> str:
        """Note what the rendered page needs, and warn of what its policy will block."""
        set_page(None)
        self._progress()
        name = page.file.src_uri
        html = self.build.languages.with_lines(html, name, self.page)
        self.late[name] = self.page.late or {}
        self.build.rendered(name, self.page, with_late(html, self.late[name]))
        for what in dict.fromkeys(blocked(html)):
            log.warning("%s: the page's policy blocks %s", self.page.lesson.file, what)
        if self.serving:
            self.preview.names[name] = str(page.title or "")
            if page.file.abs_src_path:  # written by somebody
                html = text_box(page.file.content_string, html, self.page.lesson, report) + html
        return html

    def on_env(self, env: Environment, *, config: MkDocsConfig, files: Files) -> Environment:
        """Only the scripts in the theme's templates are trusted; its words are in each language."""
        names = env.list_templates(extensions=["html"])
        speak(env, str(config.theme.get("language") or ENGLISH), frozenset(names))
        env.bytecode_cache = COMPILED
        if not self.build.trusted:
            sources = (env.loader.get_source(env, name)[0] for name in names if env.loader)
            self.build.trusted = trusted_scripts(sources)
        return env

    def on_page_context(
        self, context: Any, *, page: MkDocsPage, config: MkDocsConfig, nav: Navigation
    ) -> Any:
        """The menu of a page in another language begins with the lessons in it."""
        own_lessons_first(nav.items, page.file.src_uri)
        return context

    def on_post_page(self, output: str, *, page: MkDocsPage, config: MkDocsConfig) -> str:
        """Policy and scripts of one page."""
        self._progress()
        name = page.file.src_uri
        for script in self.build.strangers(output):
            log.warning("%s: the page's policy blocks a script in it: %.60s", name, script)
        assets = get_relative_url(ASSETS, page.url)
        return self.build.finished(with_late(output, self.late.get(name)), assets, name)

    def on_template_context(self, context: Any, *, template_name: str, config: MkDocsConfig) -> Any:
        """On a disk there is no root address: the page for missing pages stands beside the home."""
        if template_name == "404.html" and self.build.audience == "offline":
            context["base_url"] = "."
        return context

    def on_post_template(
        self, output_content: str, *, template_name: str, config: MkDocsConfig
    ) -> str:
        """Policy of the pages that no Markdown file stands behind."""
        if not template_name.endswith(".html"):
            return output_content
        return nowhere.finished(self.build, output_content, config.site_url or "")

    @event_priority(-100)  # after the search index has been written
    def on_post_build(self, *, config: MkDocsConfig) -> None:
        """What can only be made when all pages are known."""
        with stopping():
            self.build.complete(Path(config.site_dir), log.getChild("runtime").info)
