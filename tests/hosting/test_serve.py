"""`carts serve`: an edit costs one page, and the page is the one that a whole build would make."""

from __future__ import annotations

import base64
import gzip
import json
import os
import re
import socket
import threading
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.cli.site.build import build_site
from sim.cli.site.serve import Previewer
from sim.pages import runtime
from sim.pages.site import files as site_files
from sim.pages.teach.withheld import WORDS
from tests.hosting.saving import edit, saved_again

Edit = Callable[[str, str, str], None]


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A new site with three lessons; its pages carry no runtime."""
    monkeypatch.setattr(runtime, "pack", lambda *_, **__: None)
    monkeypatch.setattr(site_files, "scene_script", lambda: b"")
    monkeypatch.chdir(tmp_path)
    for command in ("mine", "two", "three", "questions --bank"):
        result = CliRunner().invoke(main, ["new", *command.split()])
        assert result.exit_code == 0, result.output
        monkeypatch.chdir(tmp_path / "mine")
    quiz = "id: before\nform: pre\nmode: practice\nbank: questions.yml\nuse: short"
    with (tmp_path / "mine/worksheets/three.md").open("a", encoding="utf-8") as lesson:
        lesson.write(f"\n```quiz\n{quiz}\n```\n")
    return tmp_path / "mine"


@pytest.fixture
def preview(root: Path, tmp_path: Path) -> Iterator[Previewer]:
    made = Previewer(root, tmp_path / "preview")
    made.url = "http://127.0.0.1:8000/"
    made.make()
    assert not made.trouble
    assert not any("carts-author-error" in page for page in pages(made.site).values())
    yield made
    made.close()


def pages(site: Path) -> dict[str, str]:
    return {
        path.relative_to(site).as_posix(): path.read_text(encoding="utf-8")
        for path in site.rglob("*.html")
    }


def test_after_an_edit_the_pages_are_those_of_a_whole_build(
    preview: Previewer, root: Path, tmp_path: Path
) -> None:
    before = pages(preview.site)
    edit(root / "worksheets" / "two.md", "mass: 0.5 kg", "mass: 0.7 kg")
    preview.make()
    after = pages(preview.site)
    assert {name for name in after if after[name] != before[name]} == {"worksheets/two.html"}
    whole = Previewer(root, tmp_path / "whole")
    whole.url = preview.url
    whole.make()
    whole.close()
    assert pages(whole.site) == after


def test_its_teacher_mode_has_notes_and_marking_guides_which_a_built_site_has_not(
    root: Path, preview: Previewer, tmp_path: Path
) -> None:
    lesson = root / "worksheets" / "two.md"
    with lesson.open("a", encoding="utf-8") as text:
        text.write("\n```question\nid: why\ntype: long\nask: Why?\n")
        text.write("rubric: {1: a reason, 0: none}\n```\n")
    preview.make()
    assert shipped(preview.site)["text"] == lesson.read_text(encoding="utf-8")
    built = build_site(root, hosted=False, strict=True, site_dir=tmp_path / "built")
    assert built is not None
    assert WORDS in shipped(built)["text"]
    assert "a reason" not in shipped(built)["text"]


def shipped(site: Path) -> dict[str, Any]:
    """What teacher mode gets of the lesson `two`."""
    scripts = (site / "assets" / "carts" / "lessons").glob("two.*.js")
    script = max(scripts, key=lambda path: path.stat().st_mtime_ns)  # those before it stay
    packed = re.search(r'"([A-Za-z0-9+/=]{40,})"', script.read_text(encoding="utf-8"))
    assert packed
    return dict(json.loads(gzip.decompress(base64.b64decode(packed[1]))))


def test_a_changed_bank_changes_the_lesson_that_draws_from_it(
    preview: Previewer, root: Path
) -> None:
    edit(root / "worksheets/banks/questions.yml", "It keeps its velocity.", "Galumphing.")
    preview.make()
    made = pages(preview.site)
    assert {name for name in made if "Galumphing." in made[name]} == {"worksheets/three.html"}


def test_a_new_lesson_is_in_every_menu(preview: Previewer, root: Path) -> None:
    assert CliRunner().invoke(main, ["new", "four"]).exit_code == 0
    preview.make()
    made = pages(preview.site)
    assert all("four.html" in text for name, text in made.items() if name != "404.html")


def test_a_mistake_is_on_the_page_and_in_the_terminal_and_goes_again(
    preview: Previewer, root: Path, caplog: pytest.LogCaptureFixture
) -> None:
    lesson, page = root / "worksheets" / "two.md", preview.site / "worksheets" / "two.html"
    for old, bad, place in (
        ("mass: 0.5 kg", "mass: -1 kg", "worksheets/two.md:17:13: error: carts.A.mass"),
        ("# Two", "# Two\n\n![](cart.png)", "worksheets/two.md:9:1: error: this picture"),
    ):
        edit(lesson, old, bad)
        preview.make()
        assert place in page.read_text(encoding="utf-8")
        assert place in caplog.text
        edit(lesson, bad, old)
        preview.make()
        assert "carts-author-error" not in page.read_text(encoding="utf-8")


def test_a_folder_that_cannot_be_written_is_told_in_a_sentence(
    preview: Previewer, monkeypatch: pytest.MonkeyPatch
) -> None:
    def no(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied", "/school/.cache")

    monkeypatch.setattr(preview, "_build", no)
    preview.make()
    assert preview.trouble.startswith("/school/.cache: Permission denied. The site needs a folder")


def test_what_a_page_gave_up_another_may_take(preview: Previewer, root: Path) -> None:
    edit(root / "worksheets" / "two.md", "id: two-first", "id: renamed")
    preview.make()
    edit(root / "worksheets" / "three.md", "id: three-first", "id: two-first")
    preview.make()
    assert "carts-author-error" not in "".join(pages(preview.site).values())


def test_broken_settings_are_sentences_as_of_a_build_until_they_are_mended(
    preview: Previewer, root: Path
) -> None:
    settings = root / "mkdocs.yml"
    good = settings.read_text(encoding="utf-8")
    for bad, said in (
        (
            good.replace("plugins:", "plugins: [", 1),
            r"mkdocs\.yml:\d+:\d+: error: this is not YAML",
        ),
        ("", r"mkdocs\.yml:1:1: error: this is no list of settings"),
    ):
        settings.write_text(bad, encoding="utf-8")
        preview.make()
        assert re.match(said, preview.trouble)
        settings.write_text(good, encoding="utf-8")
        preview.make()
        assert preview.trouble == ""


def status_of(address: str, host: str | None) -> int:
    """What the server answers to one that came under the name of another host."""
    request = urllib.request.Request(address, headers={"Host": host} if host else {})
    try:
        with urllib.request.urlopen(request, timeout=30) as answer:
            return int(answer.status)
    except urllib.error.HTTPError as error:
        return error.code


def test_a_saved_file_reloads_the_page_in_the_browser(root: Path, tmp_path: Path) -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    previewer = Previewer(root, tmp_path / "preview")
    server = previewer.server(port)
    with pytest.raises(OSError, match="in use"):
        previewer.server(port)
    previewer.make()
    thread = threading.Thread(target=server.serve, daemon=True)
    thread.start()
    try:

        def get(path: str) -> str:
            with urllib.request.urlopen(f"{server.url}{path}", timeout=30) as answer:
                return str(answer.read(), "utf-8")

        page = "worksheets/two.html"
        assert status_of(server.url + page, "elsewhere.example") == 403
        assert status_of(server.url + "%00", None) == 404
        (epoch,) = re.findall(r"livereload\((\d+), ", get(page))
        two = root / "worksheets" / "two.md"
        edit(two, "# Two", "# Two galumphing")
        with saved_again(two):
            assert int(get(f"livereload/{epoch}/1")) > int(epoch)
        assert "Two galumphing" in get(page)
        edit(root / "mkdocs.yml", "plugins:", "plugins: [")
        late = time.monotonic() + 60
        while "cannot be built" not in (text := get(page)) and time.monotonic() < late:
            time.sleep(0.05)
        assert "cannot be built" in text
        assert "this is not YAML" in text and "livereload(" in text
    finally:
        server.shutdown()
        previewer.close()
        thread.join()


def test_a_changed_scene_file_changes_the_translated_page_too(root: Path, tmp_path: Path) -> None:
    scene = root / "worksheets" / "scenes" / "named.yml"
    scene.parent.mkdir()
    scene.write_text("carts: {A: {mass: 0.5 kg, position: 0.2 m}}\n", encoding="utf-8")
    with (root / "worksheets" / "two.md").open("a", encoding="utf-8") as lesson:
        lesson.write("\n```scene\nid: named\nfile: named.yml\n```\n")
    assert CliRunner().invoke(main, ["words", "worksheets/two.md", "--language", "ms"]).output
    words = root / "worksheets" / "words" / "ms" / "two.po"
    first = 'msgid "Two"\nmsgstr "'
    edit(words, first, f"{first}Dua")
    made = Previewer(root, tmp_path / "preview")
    made.url = "http://127.0.0.1:8000/"
    made.make()
    own = {"worksheets/two.html", "worksheets/ms/two.html"}
    assert own <= set(pages(made.site)) and not made.trouble
    edit(scene, "0.5 kg", "0.7 kg")
    later = max(path.stat().st_mtime for path in made.site.rglob("*.html")) + 1
    os.utime(scene, (later, later))  # a file is newer than the page that was made of it
    made.make()
    made.close()
    assert {name for name, text in pages(made.site).items() if "0.7 kg" in text} == own
