"""A small site of a teacher, for tests that build it with MkDocs through our plugin."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from sim.pages import runtime
from sim.pages.site import files as site_files

ROOT = Path(__file__).parents[3]
CONFIG = """\
site_name: A site
extra: {carts: {site_id: a-site}}
nav: [{Home: index.md}, {Lessons: worksheets/}]
theme: {name: material, font: false}
plugins: [search, carts]
strict: true
"""
SCENE = """\
```scene
id: ID
carts:
  A: {mass: MASS, position: 0.4 m, velocity: 0.5 m/s}
until: 2 s
```
"""
LESSON = f"---\ntitle: A lesson\n---\n\nWords to search: galumphing.\n\n{SCENE}"

MakeSite = Callable[..., Path]


@pytest.fixture
def make_site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> MakeSite:
    """Return `make_site(config, **lessons)`: a folder with a home page and these lessons.

    The Python runtime is not packed and the page's script is empty: other tests look at those.
    """
    monkeypatch.setattr(
        runtime, "pack", lambda *_, **__: runtime.RuntimeFacts(Path(), {}, {}, "not here")
    )
    monkeypatch.setattr(site_files, "scene_script", lambda: b"")
    monkeypatch.chdir(tmp_path)

    def make(config: str = CONFIG, **lessons: str) -> Path:
        (tmp_path / "mkdocs.yml").write_text(config, encoding="utf-8")
        for folder in ("docs", "worksheets"):
            (tmp_path / folder).mkdir(exist_ok=True)
        (tmp_path / "docs" / "index.md").write_text("# Home\n\nNo scene.\n", encoding="utf-8")
        for name, text in lessons.items():
            (tmp_path / "worksheets" / f"{name}.md").write_text(text, encoding="utf-8")
        if not (tmp_path / "node_modules").exists():
            (tmp_path / "node_modules").symlink_to(ROOT / "node_modules")
        return tmp_path

    return make


def lesson(*, identity: str = "one", mass: str = "1 kg") -> str:
    return LESSON.replace("ID", identity).replace("MASS", mass)
