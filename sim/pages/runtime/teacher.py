"""What teacher mode has beside `read_ours`: the generator's own code, and what that stands on.

PyYAML, Jinja2, MarkupSafe, Markdown and pymdownx are taken from the Python that builds the site, as
source: the page then reads YAML and makes HTML with the very code that the build used. What they
have in compiled form (parsers in C) stays out; they run without it, and the generator never used
it.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path

from .node import RuntimePackError
from .ours import LAW_ENTRY, TEACHER, Ours, text_bytes

LAYERS = (
    *("lesson", "measured", "mine", "worlds"),
    *(f"pages/{n}" for n in ("question", "widget", "map", "measured", "language", "teach", "text")),
)
MODULES = (
    *("__init__", "findings", "templates"),
    *("blocks/__init__", "blocks/bake", "blocks/law_files", "blocks/scene_block"),
    *("checks/__init__", "checks/as_typed", "checks/no_forces", "checks/off_track"),
    *("site/__init__", "site/effect_pages"),
)
"""Of `sim/pages`."""
BUILD_ONLY = (
    *("pages/teach/publish.py", "pages/teach/doors.py"),
    *("pages/question/published.py", "pages/question/key_page.py"),
    *("pages/question/as_opened.py", "pages/question/of_lesson.py"),
    "pages/map/png.py",
    *("pages/language/catalogues/", "pages/language/extract.py"),
)
BEGINS = (
    *("sim.pages.teach.answer", "sim.pages.widget", "sim.pages.question.render"),
    *("sim.pages.measured.render", "sim.pages.measured.block", "sim.pages.map.render"),
    *("sim.pages.map.block", "sim.pages.map.bake"),
    *(
        f"markdown.extensions.{name}"
        for name in (
            *("abbr", "admonition", "attr_list", "def_list", "fenced_code", "footnotes"),
            *("legacy_attrs", "md_in_html", "meta", "nl2br", "sane_lists", "smarty", "tables"),
            *("toc", "wikilinks"),
        )
    ),
    *(f"pymdownx.{name}" for name in ("arithmatex", "details", "superfences")),
    *("encodings.unicode_escape", "encodings.utf_8_sig", "html.entities"),
)
"""What a look at a lesson imports, sooner or later."""

GROUP = "markdown.extensions"
CARRIED = ("yaml", "jinja2", "markupsafe", "markdown", "pymdownx")
TABLES = "_db.py"  # names of thousands of pictures, for extensions that no lesson uses


def read_teacher(package: Path, version: str) -> Ours:
    """Return the package for teacher mode; `package` is the folder of `sim`."""
    own = sorted(own_files(package), key=lambda p: p.as_posix())
    files = [(p.relative_to(package.parent).as_posix(), text_bytes(p)) for p in own]
    info = f"{TEACHER.replace('-', '_')}-{version}.dist-info"
    short = (f"{info}/entry_points.txt", short_names().encode())
    return Ours((*files, *carried_files(), short), version, TEACHER, BEGINS)


def short_names() -> str:
    """By which names Markdown knows its extensions: "tables" for markdown.extensions.tables."""
    found = metadata.distribution("markdown").entry_points.select(group=GROUP)
    rows = sorted(f"{entry.name} = {entry.value}" for entry in found)
    return "\n".join([f"[{GROUP}]", *rows, ""])


def own_files(package: Path) -> Iterator[Path]:
    """The files of ours among them."""
    yield from (package / "pages" / f"{name}.py" for name in MODULES)
    yield package / LAW_ENTRY  # a scene of a lesson may name a law in a file
    for layer in LAYERS:
        for path in (package / layer).rglob("*"):
            unwanted = path.relative_to(package).as_posix().startswith(BUILD_ONLY)
            if path.is_file() and "__pycache__" not in path.parts and not unwanted:
                yield path


def carried_files() -> Iterator[tuple[str, bytes]]:
    """Path in the wheel and source of every module of the packages that it stands on."""
    for name in CARRIED:
        spec = find_spec(name)
        places = spec.submodule_search_locations if spec else None
        if not places:
            raise RuntimePackError(f"{name} is not installed: pip install newtons-carts")
        folder = Path(places[0])
        for path in sorted(folder.rglob("*.py")):
            if not path.name.endswith(TABLES) and "tests" not in path.parts:
                yield f"{name}/{path.relative_to(folder).as_posix()}", text_bytes(path)
