"""Pictures in a QTI package: beside the items that show them, listed, and no others."""

from __future__ import annotations

import zipfile
from pathlib import Path
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner

from sim.cli import main
from tests.pages.given.qti_rules import PACKAGE


def test_a_picture_goes_along_beside_its_item_and_of_one_that_is_not_there_its_words(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A platform refuses a package whose items name a file that is not in it."""
    lesson = tmp_path / "worksheets" / "carts.md"
    for name in ("worksheets/one/cart.png", "worksheets/two/my cart.png"):
        (tmp_path / name).parent.mkdir(parents=True)
        (tmp_path / name).write_bytes(name.encode())
    (tmp_path.parent / "private.png").write_bytes(b"of another site")
    seen = "![A & B](one/cart.png) ![two](two/my%20cart.png) ![web](https://a.example/b.png)"
    lost = "![what is gone](gone.png) ![not ours](../../private.png)"
    lesson.write_text(
        f"# Carts\n\n```question\nid: seen\ntype: single\nask: '{seen}'\noptions:\n"
        "  - {text: '![one](one/cart.png)', correct: true}\n  - two\n```\n\n"
        f"```question\nid: lost\ntype: single\nask: '{lost}'\noptions:\n"
        '  - {text: "1", correct: true}\n  - "2"\n```\n',
        encoding="utf-8",
    )
    monkeypatch.chdir(tmp_path)
    words = ["export", "worksheets/carts.md", "--to", "qti", "--out", "a.zip"]
    result = CliRunner().invoke(main, words)
    assert result.exit_code == 0, result.output
    with zipfile.ZipFile("a.zip") as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    pictures = {name: content for name, content in files.items() if "pictures" in name}
    assert pictures == {
        "items/pictures/1-cart.png": b"worksheets/one/cart.png",
        "items/pictures/2-my-cart.png": b"worksheets/two/my cart.png",
    }
    item = files["items/seen.xml"].decode()
    assert '<img src="pictures/1-cart.png" alt="A &amp; B"/>' in item
    assert 'src="https://a.example/b.png"' in item
    assert "<p>what is gone not ours</p>" in files["items/lost.xml"].decode()
    manifest = ElementTree.fromstring(files["imsmanifest.xml"])
    resources = {r.get("identifier"): r for r in manifest.iter(f"{{{PACKAGE}}}resource")}
    assert [f.get("href") for f in resources["item-seen"].iter(f"{{{PACKAGE}}}file")] == [
        "items/seen.xml", *pictures,
    ]  # fmt: skip
    said = "its pictures are not in the file; add them on the platform"
    assert f"lost: {said}" in result.output
