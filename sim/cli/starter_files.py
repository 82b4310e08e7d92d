"""The files that `carts new` writes, from the folder starter/, and the lessons to begin with."""

from __future__ import annotations

import json
import re
import secrets
import unicodedata
from pathlib import Path

from sim import __version__
from sim.scene.said import capital
from sim.scene.schema import scene_schema

STARTER = Path(__file__).parent / "starter"

SITE = {
    "mkdocs.yml": "mkdocs.yml",
    "README.md": "README.md",
    "gitignore": ".gitignore",
    "lessons.yml": ".github/workflows/lessons.yml",
}
"""Name in the starter -> name in a new site. Its lessons come on top."""

EDITOR_SETTINGS, EDITOR_SCHEMA = ".vscode/settings.json", ".vscode/scene.schema.json"


def site_files(title: str, site_id: str) -> dict[str, str]:
    """The texts of a new site by path, without lessons."""
    words = {"SITE_ID": site_id, "VERSION": __version__, "SERIES": series()}
    filled = {
        path: _filled(name, title if name == "README.md" else quoted(title), words)
        for name, path in SITE.items()
    }
    return filled | editor_files()


def series() -> str:
    """The first two numbers of the version: what is later in them a site takes by itself."""
    return ".".join(__version__.split(".")[:2])


def editor_files() -> dict[str, str]:
    """What lets an editor complete and check scene files as somebody types."""
    settings = {"yaml.schemas": {EDITOR_SCHEMA: ["worksheets/scenes/*.yml", "*.scene.yml"]}}
    made = {EDITOR_SETTINGS: settings, EDITOR_SCHEMA: scene_schema()}
    return {path: json.dumps(of, ensure_ascii=False, indent=1) + "\n" for path, of in made.items()}


def lesson_text(name: str, title: str, order: int) -> str:
    """A lesson to begin with."""
    text = _filled("lesson.md", title, {"NAME": name, "ORDER": str(order)})
    return text.replace(f"title: {title}", f"title: {quoted(title)}", 1)


def bank_text(name: str, title: str) -> str:
    """A bank of questions to begin with."""
    return _filled("bank.yml", quoted(title), {"NAME": name})


def copied(text: str, title: str | None, order: int) -> str:
    """One of this project's lessons as a lesson of another site: its place, perhaps its title.

    Links to pages that only this project has become words.
    """
    text = re.sub(r"(?<!!)\[([^\]\n]+)\]\(\.\./[^)\s]*\)", r"\1", text)
    text = re.sub(r"^order: .*$", f"order: {order}", text, count=1, flags=re.MULTILINE)
    if title:
        text = re.sub(
            r"^title: .*$", lambda _: f"title: {quoted(title)}", text, count=1, flags=re.M
        )
        text = re.sub(r"^# .*$", lambda _: f"# {title}", text, count=1, flags=re.MULTILINE)
    return text


def files_of(text: str) -> list[str]:
    """The banks and the readings that a lesson names, by their paths beside it."""
    named = re.findall(r"^ *(bank|data): *([\w.-]+\.\w+) *$", text, re.MULTILINE)
    return sorted({f"{'banks' if kind == 'bank' else 'data'}/{name}" for kind, name in named})


def title_of(name: str) -> str:
    """A title made from a name: two-trains becomes Two trains."""
    return capital(re.sub(r"[-_]+", " ", name).strip())


def site_id_of(name: str) -> str:
    """An identifier for storage made from the name of a folder, 3 to 40 letters."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode().lower()
    slug = re.sub(r"[^a-z0-9]+", "-", plain).strip("-")[:40].strip("-")
    return slug if len(slug) >= 3 else "my-lessons"


def new_site_id(name: str) -> str:
    """The same with an ending of its own: on one computer two sites never share their answers."""
    return f"{site_id_of(name)[:33].strip('-')}-{secrets.token_hex(3)}"


def quoted(text: str) -> str:
    """The text as YAML reads it back."""
    plain = re.fullmatch(r"[^\W\d_][\w ().!?-]*[\w).!?]", text)
    if plain and text.lower() not in ("yes", "no", "on", "off", "true", "false", "null"):
        return text
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _filled(name: str, title: str, words: dict[str, str]) -> str:
    text = (STARTER / name).read_text(encoding="utf-8")
    for word, value in {"TITLE": title, **words}.items():
        text = text.replace(f"@@{word}@@", value)
    return text
