"""The page “Class results”: files in, tables out, in both browsers, from a folder on the disk."""

from __future__ import annotations

import html
import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import FilePayload, Page, expect

from sim.classroom.files.reading import Source
from sim.pages.classroom.practice_keys import keys_script
from sim.pages.runtime import CLASSROOM, default_cache, pack
from tests.classroom.everything import Blanked, a_class, left_in_english
from tests.classroom.makers import answers, bank, form, keys, random_class, sources, zipped
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import ROOT, STRICT, bundle

pytestmark = pytest.mark.browser

BANK = bank(8, words=1)
KEY = Source("carts.key.json", keys(BANK).encode())
PAGE = f"""<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{html.escape(STRICT)}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Class results</title><link rel="icon" href="data:,">
<link rel="stylesheet" href="assets/carts/carts.css"></head>
<body><main><h1>Class results</h1><carts-class></carts-class></main>
<script src="assets/carts/class-keys.js"></script>
<script src="assets/carts/class.js"></script></body></html>
"""


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    site = tmp_path_factory.mktemp("class")
    assets = site / "assets" / "carts"
    assets.mkdir(parents=True)
    packages = frozenset({"numpy", "scipy", CLASSROOM})
    pack(site, packages=packages, cache=default_cache(ROOT), report=lambda _: None)
    web = ROOT / "sim" / "web"
    sheets = [web / "css" / "carts.css", web / "css" / "class.css"]
    sheets.append(ROOT / "sim" / "classroom" / "show" / "report.css")
    sheets.append(ROOT / "sim" / "classroom" / "handouts" / "paper.css")
    (assets / "class-keys.js").write_bytes(keys_script([]))
    (assets / "carts.css").write_bytes(b"\n".join(sheet.read_bytes() for sheet in sheets))
    bundle(web / "src" / "class-main.js", assets / "class.js")
    (site / "class.html").write_text(PAGE, encoding="utf-8")
    blanked = json.dumps(Blanked())
    (assets / "blanked.js").write_text(
        f"globalThis.cartsWords = {blanked};\n"
        f'globalThis.__cartsPapers = {{"ms": {{"name": "·", "words": {blanked}}}}};\n',
        encoding="utf-8",
    )
    (site / "blanked.html").write_text(
        PAGE.replace('lang="en"', 'lang="ms"').replace("class-keys.js", "blanked.js"),
        encoding="utf-8",
    )
    return site / "class.html"


@pytest.fixture
def page(place: Path, open_page: OpenPage) -> Iterator[Page]:
    opened = open_page(place)
    errors: list[str] = []
    opened.on("pageerror", lambda error: errors.append(str(error)))
    expect(opened.locator("carts-class[data-state=ready]")).to_have_count(1)
    yield opened
    assert not errors


# Firefox's driver tells of no download: what is handed to the browser is caught instead.
CATCH = """() => {
  window.caught = [];
  const make = URL.createObjectURL;
  URL.createObjectURL = (blob) => { window.caught.push(blob); return make.call(URL, blob); };
}"""
LAST = """async () => {
  while (!window.caught.length) await new Promise((resolve) => setTimeout(resolve, 50));
  const bytes = new Uint8Array(await window.caught.pop().arrayBuffer());
  return Array.from(bytes);
}"""


def saved(page: Page, button: str) -> bytes:
    """What a button hands to the browser to be saved."""
    page.evaluate(CATCH)
    page.locator(button).click()
    return bytes(page.evaluate(LAST))


def choose(page: Page, files: list[Source], group: int = 0) -> None:
    payloads: list[FilePayload] = [
        {"name": f.name, "mimeType": "application/octet-stream", "buffer": f.content} for f in files
    ]
    page.locator(".carts-class-drop").nth(group).locator(
        ".carts-class-files"
    ).first.set_input_files(payloads)


def complete(page: Page) -> None:
    expect(page.locator("carts-class")).to_have_attribute("data-state", "complete", timeout=60_000)


def test_a_class_and_its_key_give_means_and_then_intervals(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 12)), KEY])
    means = page.locator(".carts-class-table.means")
    expect(means).to_contain_text("before (pre)", timeout=60_000)
    complete(page)
    expect(means).to_contain_text(" to ")
    expect(page.locator(".carts-class-report")).to_contain_text("Hake's gain")
    assert page.locator(".carts-class-plot circle").count() == 24


@pytest.mark.one_browser
def test_a_bad_file_in_a_zip_is_named_and_the_others_are_counted(page: Page) -> None:
    packed = zipped([*sources(random_class(BANK, 6)), Source("bad.json", b"{"), KEY])
    choose(page, [Source("class.zip", packed), Source("picture.png", b"\x89PNG\r\n\xff")])
    report = page.locator(".carts-class-report")
    expect(report).to_contain_text("12 of 12 files of answers", timeout=60_000)
    expect(report).to_contain_text("class.zip/bad.json: this file is damaged")
    expect(report).to_contain_text("picture.png: this is no text file")


@pytest.mark.one_browser
def test_slips_are_printed_alone_and_in_the_language_that_was_chosen(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    expect(page.locator(".carts-class-table.means")).to_be_visible(timeout=60_000)
    page.evaluate("() => { window.print = () => { window.printed = true; }; }")
    page.locator(".carts-class-language").select_option("ms")
    page.get_by_role("button", name="Print slips for students").click()
    slips = page.locator(".carts-slip")
    expect(slips).to_have_count(6)
    expect(page.locator("html.carts-class-paper-only")).to_have_count(1)
    assert page.evaluate("window.printed")
    assert "Sebelum pelajaran" in (slips.first.text_content() or "")
    assert not slips.first.is_visible()
    page.emulate_media(media="print")
    expect(slips.first).to_be_visible()
    expect(page.locator(".carts-class-table.means")).to_be_hidden()
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    expect(slips.first).to_be_hidden()
    expect(page.locator(".carts-class-table.means")).to_be_visible()


SPOKEN = """() => {
  const all = [...document.querySelectorAll("carts-class *")];
  const own = (node) => [...node.childNodes].filter((n) => n.nodeType === 3).map((n) => n.data);
  const labels = ["aria-label", "placeholder", "title"].flatMap(
    (name) => all.map((node) => node.getAttribute(name) ?? ""));
  return [...all.flatMap(own), ...labels];
}"""


@pytest.mark.one_browser
def test_nothing_on_the_page_is_said_outside_the_catalogues(
    place: Path, open_page: OpenPage
) -> None:
    """In a language of blanks only names are left: of buttons, messages and of the report."""
    page = open_page(place.with_name("blanked.html"))
    expect(page.locator("carts-class[data-state=ready]")).to_have_count(1)
    said = set(page.evaluate(SPOKEN))
    page.locator(".carts-class-two").check()
    choose(page, [*a_class(), Source("t1.csv", b"student,pre,post\nA-1,2,z\n")])
    complete(page)
    page.locator(".carts-class-list > summary").click()
    page.locator(".carts-class-list li").first.wait_for()
    page.locator(".carts-class-reader > summary").click()
    said |= set(page.evaluate(SPOKEN))
    page.locator(".carts-class-clear").first.click()
    said |= set(page.evaluate(SPOKEN))
    said -= {BLANK_EXAMPLE}
    assert len(said) > 300
    assert left_in_english("\n".join(said)) == set()


BLANK_EXAMPLE = "BLUE-FOX-27 pre 7K2M-Q9ZD-03HX"


@pytest.mark.one_browser
def test_hostile_names_are_shown_and_never_run(page: Page) -> None:
    hostile = '<img src="x" onerror="window.hacked=1"><script>window.hacked=1</script>'
    file = answers(BANK, hostile, "pre", {"item-0": "a"}, lesson=hostile)
    choose(page, [Source(f"{hostile}.json", json.dumps(file).encode())])
    report = page.locator(".carts-class-report")
    expect(report.locator("h2", has_text="<img src=")).to_have_count(1, timeout=60_000)
    assert page.evaluate("window.hacked") is None
    assert report.locator("img, script").count() == 0


@pytest.mark.one_browser
def test_two_groups_stand_side_by_side(page: Page) -> None:
    page.locator(".carts-class-two").check()
    choose(page, [*sources(random_class(BANK, 8, seed=1, prefix="FOX")), KEY], group=0)
    choose(page, sources(random_class(BANK, 9, seed=2, prefix="OWL")), group=1)
    report = page.locator(".carts-class-report")
    expect(report).to_contain_text("Before teaching: experimental minus control", timeout=60_000)
    complete(page)
    expect(report).to_contain_text("Adjusted for the start")
    expect(report).to_contain_text("no p-value for the teaching is given")
    page.locator(".carts-class-name input").first.fill("new")
    expect(report).to_contain_text("Before teaching: new minus control")


@pytest.mark.one_browser
def test_a_file_that_is_left_out_does_not_count(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    report = page.locator(".carts-class-report")
    expect(report).to_contain_text("12 of 12 files", timeout=60_000)
    page.locator(".carts-class-list > summary").click()
    page.locator(".carts-class-list input").first.uncheck()
    expect(report).to_contain_text("11 of 11 files")
    expect(page.locator(".carts-class-list > summary")).to_contain_text("1 left out")


@pytest.mark.one_browser
def test_the_key_that_was_dropped_is_printed_without_any_answers(page: Page) -> None:
    expect(page.locator(".carts-class-print-key")).to_be_hidden()
    choose(page, [KEY])
    page.evaluate("() => { window.print = () => { window.printed = true; }; }")
    page.locator(".carts-class-print-key").click()
    expect(page.locator(".carts-class-paper .carts-sheet")).to_have_count(2, timeout=60_000)
    assert page.evaluate("window.printed")
    assert "both forces" in (page.locator(".carts-class-paper").text_content() or "")


@pytest.mark.one_browser
def test_typed_codes_are_counted_beside_files(page: Page) -> None:
    from sim.lesson.handin import encode

    choices = bank(8)
    code = encode([4] * 8, [1, 2, 3, 4, 1, 2, 3, 4], form("pre", choices).hash)
    choose(page, [Source("key.json", keys(choices).encode())])
    expect(page.locator(".carts-class-list > summary")).to_contain_text("key for 2", timeout=60_000)
    page.locator(".carts-class-codes > summary").click()
    box = page.locator(".carts-class-codes textarea")
    box.fill(f"BLUE-FOX pre {code}\nRED-OWL pre {code[:-1]}")
    report = page.locator(".carts-class-report")
    expect(report).to_contain_text("1 of 1 files")
    expect(report).to_contain_text("typed: RED-OWL")


@pytest.mark.one_browser
def test_one_question_is_read_and_marked_by_keys_and_the_marks_are_saved(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    reader = page.locator(".carts-class-reader")
    expect(reader).to_be_visible(timeout=60_000)
    complete(page)
    reader.locator("summary").click()
    count = int((reader.locator(".carts-class-quiet").last.inner_text()).split()[2])
    reader.locator(".carts-class-answer").focus()
    for key in "21" * (count // 2) + "0" * (count % 2):
        page.keyboard.press(key)
    expect(reader.locator(".carts-class-quiet").last).to_have_text(f"{count} of {count} marked.")
    expect(page.locator(".carts-class-table.means")).to_contain_text("10")
    marks = json.loads(saved(page, ".carts-class-save-marks"))
    assert marks["kind"] == "newtons-carts-marks"
    assert [row["marks"] for row in marks["marks"]][:2] in ([2, 1], [1, 2])
    assert len(marks["marks"]) == count


SAVED = {
    "html": "<!doctype html>",
    "csv": "lesson,form,group,student",
    "items": "lesson,form,item",
}


@pytest.mark.one_browser
def test_reports_and_tables_are_saved(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    complete(page)
    for name, begins in SAVED.items():
        text = saved(page, f".carts-class-save-{name}").decode("utf-8-sig")
        assert text.startswith(begins)
        assert "FOX-1" in text or name == "items"
    assert saved(page, ".carts-class-save-png").startswith(b"\x89PNG")


@pytest.mark.one_browser
def test_a_table_of_marks_is_dropped_told_apart_and_left_out(page: Page) -> None:
    before = "student,total\n" + "".join(f"S{k},{5 + k % 4}\n" for k in range(12))
    after = "student,total\n" + "".join(f"S{k},{9 + k % 5}\n" for k in range(12))
    choose(page, [Source("one.csv", before.encode()), Source("two.csv", after.encode())])
    tables = page.locator(".carts-class-tables")
    expect(tables.locator("li")).to_have_count(2, timeout=60_000)
    tables.locator("select").nth(0).select_option("pre")
    tables.locator("select").nth(1).select_option("post")
    tables.locator("input").fill("15")
    report = page.locator(".carts-class-report")
    expect(report).to_contain_text("Hake's gain", timeout=60_000)
    tables.get_by_role("button", name="Leave out").first.click()
    expect(tables.locator("li")).to_have_count(1)
    expect(report).not_to_contain_text("Hake's gain")


@pytest.mark.one_browser
def test_everything_can_be_deleted(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    complete(page)
    page.get_by_role("button", name="Delete everything").click()
    page.get_by_role("button", name="Delete", exact=True).click()
    expect(page.locator(".carts-class-report")).to_be_empty()
    expect(page.locator(".carts-class-list > summary")).to_have_text("Files: 0, no key file")
    choose(page, [sources(random_class(BANK, 1))[0]])
    expect(page.locator(".carts-class-report")).to_contain_text("1 of 1 files")


@pytest.mark.one_browser
def test_it_prints_without_its_controls_and_fits_a_phone(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    complete(page)
    page.set_viewport_size({"width": 360, "height": 700})
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    if page.context.browser and page.context.browser.browser_type.name == "chromium":
        page.emulate_media(media="print")  # Firefox's driver cannot
        expect(page.locator(".carts-class-controls")).to_be_hidden()
        expect(page.locator(".carts-class-table.means")).to_be_visible()


def test_on_the_real_page_a_worksheet_needs_no_key_and_the_report_is_what_prints(
    site: Path, open_page: OpenPage
) -> None:
    from tests.classroom.test_practice_keys import keys_of

    key = [k for k in keys_of(site) if k["lesson"] == "newtons-third-law"][-1]  # the original
    item = next(i for i in key["forms"][0]["items"] if i["type"] == "single")
    number = 1 + key["forms"][0]["items"].index(item)
    right = item["key"]["correct"][0]
    time = "2026-09-01T08:00:00.000Z"
    files = [
        {
            "format": 1, "kind": "newtons-carts-answers", "site": key["site"],
            "lesson": key["lesson"], "lessonHash": "", "student": f"FOX-{k}", "form": "worksheet",
            "created": time, "saved": time, "items": [
                {"id": item["id"], "hash": item["hash"], "type": "single", "tries": 1,
                 "value": right if k < 4 else "", "first": time, "last": time}
            ],
        }
        for k in range(6)
    ]  # fmt: skip
    page = open_page(site / "teachers" / "class-results.html", folder=site)
    expect(page.locator("carts-class[data-state=ready]")).to_have_count(1)
    choose(page, sources(files))
    cell = page.get_by_role("cell", name=f"Question {number}", exact=True)
    row = page.locator(".carts-class-table.overview tr").filter(has=cell)
    expect(row).to_contain_text("4 of 6", timeout=60_000)
    complete(page)
    if page.context.browser and page.context.browser.browser_type.name == "chromium":
        page.emulate_media(media="print")
        expect(page.locator("h1")).to_be_visible()
        expect(row).to_be_visible()
        expect(page.locator(".carts-class-controls")).to_be_hidden()
        expect(page.locator("#five-minutes")).to_be_hidden()
