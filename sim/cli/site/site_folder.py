"""The folder that a command works in: is it a site, whose, and made with which version?"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click
import yaml

from sim import __version__
from sim.pages.findings import Finding, SiteError
from sim.pages.site.lessons_only import CLASS_RESULTS, named_pages
from sim.pages.site.settings_file import SETTINGS, not_yaml, settings_findings
from sim.pages.site.site_id import facts_of


@dataclass(frozen=True, slots=True)
class SiteFolder:
    """A folder with a mkdocs.yml: title, identifier, and the version that `carts new` wrote.

    `language`: what the theme is told to speak, which may be a language that we have no words in.
    `handed_out`: the folders that students get, the built site and what is copied into it.
    `class_results`: whether its menu names that page, which its author did not write.
    """

    root: Path
    title: str
    site_id: str
    made_with: str
    handed_out: tuple[Path, ...]
    language: str = "en"
    class_results: bool = False


def here() -> SiteFolder:
    """The site of the current folder; a sentence and the end where there is none."""
    root = Path.cwd()
    if not (root / SETTINGS).is_file():
        above = nearest_site(root)
        help_ = (
            f"Go to {above} first."
            if above
            else "Go to the folder of your site first, or make one: carts new my-lessons"
        )
        raise click.UsageError(f"There is no mkdocs.yml here. {help_}")
    site = read(root)
    if newer(site.made_with, __version__):
        raise click.ClickException(
            f"This site was made with newtons-carts {site.made_with}, and {__version__} is"
            " installed. Take the newer one: pip install --upgrade newtons-carts"
        )
    return site


def nearest_site(folder: Path) -> Path | None:
    """The folder itself if it is a site, else the nearest above it that is one; None if none is."""
    return next((one for one in (folder, *folder.parents) if (one / SETTINGS).is_file()), None)


def read(root: Path) -> SiteFolder:
    """What mkdocs.yml says; a sentence with its line and the end where it is not readable."""
    try:
        text = (root / SETTINGS).read_text(encoding="utf-8")
        settings = yaml.load(text, _Settings) or {}  # a SafeLoader
        extra = facts_of(settings.get("extra"))
    except SiteError as error:
        raise click.ClickException(str(error)) from None
    except yaml.YAMLError as error:
        raise click.ClickException(str(not_yaml(error, text))) from None
    except (UnicodeDecodeError, AttributeError):
        text = f"{SETTINGS}: error: this is no list of settings in UTF-8"
        raise click.ClickException(f"{text}\n  hint: for example site_name: My lessons") from None
    except ValueError:  # 2026-02-30 is no text and no date
        text = f"{SETTINGS}: error: there is a day that no calendar has"
        hint = "a text that only looks like a date stands in quotes"
        raise click.ClickException(f"{text}\n  hint: {hint}") from None
    theme = settings.get("theme")  # its name alone, or a table
    return SiteFolder(
        root,
        str(settings.get("site_name", "Newton's Carts")),
        str(extra.get("site_id", "site")),
        str(extra.get("made_with", "")),
        tuple(
            (root / str(settings.get(name) or usual)).resolve()
            for name, usual in (("site_dir", "site"), ("docs_dir", "docs"))
        ),
        str(theme.get("language") or "en") if isinstance(theme, dict) else "en",
        _class_results(root, settings),
    )


def _class_results(root: Path, settings: dict[str, Any]) -> bool:
    named = CLASS_RESULTS in named_pages(settings.get("nav"))
    return named and not (root / str(settings.get("docs_dir") or "docs") / CLASS_RESULTS).is_file()


def findings(root: Path) -> list[Finding]:
    """What is wrong with mkdocs.yml, with its places; none where there is no such file."""
    if not (root / SETTINGS).is_file():
        return []
    from sim.pages.site.plugin import CartsConfig

    return settings_findings(root, dict(CartsConfig()._schema))


def newer(one: str, other: str) -> bool:
    """Whether version `one` is newer than `other`; what is no version is never newer."""
    first, second = ([int(n) for n in re.findall(r"\d+", v)[:3]] for v in (one, other))
    return first > second


class _Settings(yaml.SafeLoader):
    """Reads mkdocs.yml and runs none of the tags in it."""


def _nothing(*_: Any) -> None:
    """What a tag stands for here."""


_Settings.add_multi_constructor("", _nothing)
