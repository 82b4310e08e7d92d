"""The SCORM 1.2 package in a real run-time, scorm-again: opened, handed in, timed; nothing else."""

from __future__ import annotations

import re
import shutil
import zipfile
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest
from playwright.sync_api import Page, expect

from sim.cli.site.pack import pack_site
from sim.pages.classroom.scorm import scorm_files
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import ROOT
from tests.web.scene.given.widget_site import in_node

RUNTIME = ROOT / "node_modules" / "scorm-again" / "dist" / "scorm12.min.js"
NAMES = {"i": "http://www.imsproject.org/xsd/imscp_rootv1p1p2"}
PLATFORM = """<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Platform</title>
<link rel="icon" href="data:,"><script src="scorm12.min.js"></script>
<script>window.API = new Scorm12API({ autocommit: false, logLevel: 5 });</script></head>
<body><iframe src="package/HREF" title="package" width="900" height="500"></iframe></body></html>
"""
LESSON = """<!doctype html><h1>One</h1><button id="form">Hand in</button><button id="file">Save
</button><button id="other">Other</button><script>
const tell = (id, name) => document.getElementById(id).addEventListener("click", (event) =>
  event.target.dispatchEvent(new CustomEvent(name, { bubbles: true })));
tell("form", "carts-handed-in"); tell("file", "carts-file-saved"); tell("other", "carts-update");
</script>"""
LISTENED_TO = """() => {
  const lesson = document.querySelector("iframe").contentDocument.querySelector("iframe");
  return lesson.contentDocument.readyState === "complete"
    && Boolean(lesson.contentDocument.getElementById("form"));
}"""
STATUS = "window.API.cmi.core.lesson_status"


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A platform's folder with the unpacked zip of a small site in it."""
    site = tmp_path / "site"
    (site / "worksheets").mkdir(parents=True)
    link = '<a href="worksheets/one.html">One & only</a>'
    (site / "index.html").write_text(f"<!doctype html><title>Home</title>{link}", encoding="utf-8")
    (site / "worksheets" / "one.html").write_text(LESSON, encoding="utf-8")
    pack_site(site, tmp_path / "site.zip", scorm=("Carts & <springs>", "tests"))
    place = tmp_path / "platform"
    with zipfile.ZipFile(tmp_path / "site.zip") as archive:
        archive.extractall(place / "package")
    shutil.copy(RUNTIME, place)
    return place


def start_page(package: Path) -> str:
    """What the manifest says is to be opened."""
    manifest = ElementTree.parse(package / "package" / "imsmanifest.xml").getroot()
    resource = manifest.find("i:resources/i:resource", NAMES)
    assert resource is not None
    return str(resource.get("href"))


def test_the_manifest_lists_every_file_and_is_xml(package: Path) -> None:
    folder = package / "package"
    manifest = ElementTree.parse(folder / "imsmanifest.xml").getroot()
    assert manifest.findtext("i:metadata/i:schemaversion", "", NAMES) == "1.2"
    assert manifest.findtext("i:organizations/i:organization/i:title", "", NAMES) == (
        "Carts & <springs>"
    )
    listed = {str(f.get("href")) for f in manifest.iter(f"{{{NAMES['i']}}}file")}
    there = {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()}
    assert listed == there - {"imsmanifest.xml"}
    resource = manifest.find("i:resources/i:resource", NAMES)
    item = manifest.find("i:organizations/i:organization/i:item", NAMES)
    assert resource is not None
    assert item is not None
    assert resource.get("identifier") == item.get("identifierref")


def test_a_title_longer_than_the_schema_allows_is_cut_in_the_manifest() -> None:
    manifest = scorm_files("é" * 201, "tests", [])["imsmanifest.xml"].decode()
    assert set(re.findall("<title>(.*)</title>", manifest)) == {"é" * 200}


def test_equal_sites_give_equal_zips(package: Path, tmp_path: Path) -> None:
    again = tmp_path / "again.zip"
    pack_site(tmp_path / "site", again, scorm=("Carts & <springs>", "tests"))
    assert again.read_bytes() == (tmp_path / "site.zip").read_bytes()


@pytest.mark.one_browser
@pytest.mark.browser
def test_a_platform_is_told_that_the_lessons_were_opened_and_for_how_long(
    package: Path, site_server: Callable[[Path], str], open_page: OpenPage
) -> None:
    text = PLATFORM.replace("HREF", start_page(package))
    (package / "platform.html").write_text(text, encoding="utf-8")
    page: Page = open_page(f"{site_server(package)}/platform.html")
    lessons = page.frame_locator("iframe").frame_locator("iframe")
    expect(lessons.get_by_role("link")).to_have_text("One & only")
    assert page.evaluate(STATUS) == "incomplete"
    assert page.evaluate("window.API.isInitialized()") is True
    lessons.get_by_role("link").click()
    expect(lessons.get_by_role("heading")).to_have_text("One")
    page.evaluate("document.querySelector('iframe').src = 'about:blank'")
    page.wait_for_function("window.API.isTerminated()")
    time = page.evaluate("window.API.cmi.core.getCurrentTotalTime()")
    assert re.fullmatch(r"\d{2,4}:\d\d:\d\d(\.\d+)?", time), time
    assert page.evaluate("window.API.cmi.core.score.raw") == ""
    assert page.evaluate("window.API.cmi.suspend_data") == ""


def on_a_platform(
    package: Path, site_server: Callable[[Path], str], open_page: OpenPage, before: str = ""
) -> Page:
    """The platform with the lesson open; `before`: the status that it had."""
    text = PLATFORM.replace("HREF", start_page(package))
    begun = f"<script>window.API.cmi.core.lesson_status = '{before}';</script></head>"
    (package / "platform.html").write_text(
        text.replace("</head>", begun) if before else text, encoding="utf-8"
    )
    page: Page = open_page(f"{site_server(package)}/platform.html")
    page.frame_locator("iframe").frame_locator("iframe").get_by_role("link").click()
    page.wait_for_function(LISTENED_TO)
    return page


@pytest.mark.browser
@pytest.mark.parametrize("button", [pytest.param("#form", marks=pytest.mark.one_browser), "#file"])
def test_what_was_handed_in_makes_it_complete_and_nothing_else_does(
    button: str, package: Path, site_server: Callable[[Path], str], open_page: OpenPage
) -> None:
    page = on_a_platform(package, site_server, open_page)
    lesson = page.frame_locator("iframe").frame_locator("iframe")
    lesson.locator("#other").click()
    assert page.evaluate(STATUS) == "incomplete"
    lesson.locator(button).click()
    page.wait_for_function(f"{STATUS} === 'completed'")
    assert page.evaluate("window.API.cmi.core.score.raw") == ""


@pytest.mark.one_browser
@pytest.mark.browser
def test_who_comes_back_goes_on_and_what_was_handed_in_stays(
    package: Path, site_server: Callable[[Path], str], open_page: OpenPage
) -> None:
    """A platform may begin anew at the next visit, unless a visit ends as interrupted."""
    page = on_a_platform(package, site_server, open_page)
    page.frame_locator("iframe").frame_locator("iframe").locator("#form").click()
    page.evaluate("document.querySelector('iframe').src = 'about:blank'")
    page.wait_for_function("window.API.isTerminated()")
    kept = page.evaluate("window.API.cmi.core.toJSON()")
    assert (kept["exit"], kept["lesson_status"]) == ("suspend", "completed")


@pytest.mark.one_browser
@pytest.mark.browser
def test_what_the_platform_has_settled_is_not_taken_back(
    package: Path, site_server: Callable[[Path], str], open_page: OpenPage
) -> None:
    page = on_a_platform(package, site_server, open_page, "passed")
    page.frame_locator("iframe").frame_locator("iframe").locator("#form").click()
    page.evaluate("document.querySelector('iframe').src = 'about:blank'")
    page.wait_for_function("window.API.isTerminated()")
    assert page.evaluate(STATUS) == "passed"


BEGUN = {"": 2, "not attempted": 2, "incomplete": 2, "browsed": 2} | dict.fromkeys(
    ("passed", "failed", "completed"), 0
)
"""A status that a platform may have, and how often a lesson that is handed in changes it."""


@pytest.mark.parametrize("before", BEGUN)
def test_only_a_status_that_is_open_is_changed_and_all_else_goes_on(before: str) -> None:
    said = in_node(
        """const said = [], status = [data.before], lesson = new EventTarget();
        globalThis.window = globalThis.parent = globalThis;
        globalThis.API = {
          LMSInitialize: () => "true",
          LMSGetValue: () => status.at(-1),
          LMSSetValue: (name, value) => {
            said.push(name);
            if (name.endsWith("status")) status.push(value);
          },
          LMSCommit: () => said.push("commit"),
          LMSFinish: () => said.push("finish"),
        };
        const frame = Object.assign(new EventTarget(), { contentDocument: lesson });
        globalThis.document = { querySelector: () => frame };
        const page = new EventTarget();
        globalThis.addEventListener = page.addEventListener.bind(page);
        await import(data.script);
        lesson.dispatchEvent(new Event("carts-handed-in"));
        lesson.dispatchEvent(new Event("carts-file-saved"));
        page.dispatchEvent(new Event("pagehide"));
        give([status, said]);""",
        {"before": before, "script": (ROOT / "sim" / "web" / "site" / "scorm.js").as_uri()},
    )
    changes = ["incomplete", "completed"][: BEGUN[before]]
    status = ["cmi.core.lesson_status", "commit"] * len(changes)
    left = ["cmi.core.session_time", "commit", "finish"]
    assert said == [[before, *changes], ["cmi.core.exit", *status, *left]]


def test_the_package_listens_to_what_the_lessons_tell() -> None:
    """The two halves meet only in the names of these events."""
    script = (ROOT / "sim" / "web" / "site" / "scorm.js").read_text(encoding="utf-8")
    listed = re.search(r"HANDED_IN = \[(.*?)\]", script)
    assert listed
    names = re.findall(r'"([a-z-]+)"', listed[1])
    assert names == ["carts-handed-in", "carts-file-saved"]
    for name in names:
        sources = (ROOT / "sim" / "web" / "src").rglob("*.js")
        assert any(f'CustomEvent("{name}"' in path.read_text(encoding="utf-8") for path in sources)


@pytest.mark.one_browser
@pytest.mark.browser
def test_without_a_platform_the_lessons_open_all_the_same(
    package: Path, site_server: Callable[[Path], str], open_page: OpenPage
) -> None:
    page = open_page(f"{site_server(package / 'package')}/{start_page(package)}")
    expect(page.frame_locator("iframe").get_by_role("link")).to_be_visible()
