"""The committed script of the pages is what its sources give, and it can be read."""

from __future__ import annotations

from pathlib import Path

from tests.web.boot_site import ROOT, bundle

DIST = ROOT / "sim" / "web" / "dist" / "carts.js"


def test_the_committed_bundle_is_fresh(tmp_path: Path) -> None:
    again = tmp_path / "carts.js"
    bundle(ROOT / "sim" / "web" / "src" / "main.js", again)
    assert again.read_text(encoding="utf-8") == DIST.read_text(encoding="utf-8"), (
        "sim/web/dist/carts.js is older than its sources: run `make bundle`"
    )


def test_the_bundle_is_one_classic_script_that_can_be_read() -> None:
    text = DIST.read_text(encoding="utf-8")
    lines = text.splitlines()
    assert not [line for line in lines if line.startswith(("import ", "export "))]
    own = [line for line in lines if not line.lstrip().startswith("var worker_default")]
    assert max(map(len, own)) < 1000  # nothing but the worker's text is squeezed into a line
    assert "sourceMappingURL" not in text
