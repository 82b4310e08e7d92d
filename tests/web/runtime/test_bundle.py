"""The committed script of the pages is what its sources give, and it can be read."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.web.runtime.boot_site import ROOT, bundle

DIST = ROOT / "sim" / "web" / "dist"
ENTRIES = {"carts.js": "main.js", "answers.js": "answers-main.js", "class.js": "class-main.js"}
ENTRIES |= {"measured.js": "measured-main.js", "teacher.js": "teacher-main.js"}
ENTRIES |= {
    "challenge.js": "challenge-main.js",
    "film.js": "film-main.js",
    "hosted.js": "hosted-main.js",
    "tools.js": "tools-main.js",
    "tour.js": "tour-main.js",
}
ENTRIES |= {"draw.js": "draw-main.js", "worlds.js": "worlds-main.js"}


@pytest.mark.parametrize("name", ENTRIES)
def test_the_committed_bundle_is_fresh(tmp_path: Path, name: str) -> None:
    again = tmp_path / name
    bundle(ROOT / "sim" / "web" / "src" / ENTRIES[name], again)
    assert again.read_text(encoding="utf-8") == (DIST / name).read_text(encoding="utf-8"), (
        f"sim/web/dist/{name} is older than its sources: run `make bundle`"
    )


@pytest.mark.parametrize("name", sorted({*ENTRIES} - {"draw.js"}))  # no page reads that one
def test_the_bundle_is_one_classic_script_that_can_be_read(name: str) -> None:
    text = (DIST / name).read_text(encoding="utf-8")
    lines = text.splitlines()
    assert not [line for line in lines if line.startswith(("import ", "export "))]
    texts = ("var worker_default", "var film_default")  # of a worker, of a style
    own = [line for line in lines if not line.lstrip().startswith(texts)]
    assert max(map(len, own)) < 1000  # nothing but those is squeezed into a line
    assert "sourceMappingURL" not in text
