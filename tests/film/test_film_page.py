"""From a film to a fit, in the page: from a folder on the disk, in both browsers."""

from __future__ import annotations

from base64 import b64encode
from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, expect

from sim.measured.tracks import Measured, read_measured
from tests.film.collision import Filmed, filmed
from tests.film.film_bench import AIMS, MADE, STARTS, benches, choose, click, film, set_up
from tests.film.maker import Stage, encoded, frames
from tests.web.classroom.class_site import CATCH, LAST
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import ROOT
from tests.web.site.accessibility import PALE, RUN_AXE
from tests.web.site.pages_of import listen

__all__ = ["benches", "film"]  # fixtures

pytestmark = pytest.mark.browser

DROP = """([text, name]) => {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([bytes], name, { type: "video/mp4" }));
  const event = new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true });
  document.querySelector("carts-measured").dispatchEvent(event);
}"""


@pytest.fixture(scope="module")
def broken_off() -> Filmed:
    """A film in which cart A is not to be seen for three frames."""
    stage = Stage()
    made = filmed(MADE, stage, 30, codec="libvpx")
    pictures = list(frames(stage, made.times, made.places))
    for picture in pictures[8:11]:
        picture[:, : stage.width // 2] = 128
    return Filmed(encoded(iter(pictures), made.times, stage), made.times, made.places, stage)


def test_a_dropped_film_is_followed_fitted_and_shown_with_the_model(
    benches: Path, open_page: OpenPage, film: Filmed, browser_name: str
) -> None:
    """In Firefox as far as browsers differ: its pictures, its times and its clock."""
    page = open_page(benches / "empty.html", viewport={"width": 1000, "height": 900})
    heard = listen(page)
    expect(page.locator("carts-measured[data-state=live]")).to_have_count(1, timeout=STARTS)
    assert page.evaluate("typeof globalThis.cartsFilm") == "undefined"  # nothing of it before
    expect(page.locator(".carts-measured-camera")).to_be_hidden()  # no page from a disk may film
    page.evaluate(DROP, [b64encode(film.content).decode(), "our carts.mp4"])
    said = page.locator(".carts-film-say")
    expect(said).to_have_text("Click on the mark of cart A.", timeout=STARTS)
    click(page, 10, 10)
    expect(said).to_contain_text("Nothing stands out there")
    # One mark holds for its own frame only, too.
    click(page, *film.clicks()[0])
    expect(page.locator("[data-aim=A].carts-film-set")).to_have_count(1)
    page.locator(".carts-film-time").focus()
    page.keyboard.press("End")
    expect(page.locator(".carts-film-set")).to_have_count(0)
    expect(said).to_have_text("Click on the mark of cart A.")
    clock = page.locator(".carts-film-clock")
    expect(clock).to_have_text(f"{film.times[-1]:.3f} s")
    page.keyboard.press("Home")
    expect(clock).to_have_text(f"{film.times[0]:.3f} s")
    set_up(page, film)
    page.locator(".carts-film-follow").click()
    count = len(film.times)
    expect(said).to_have_text(f"Followed through {count} frames. Nothing was lost.", timeout=STARTS)
    expect(page.locator(".carts-measured-said")).to_contain_text("our carts.csv", timeout=STARTS)
    if browser_name == "chromium":
        fitted(page)
    # What is saved is what was read, at the times of the film itself.
    page.evaluate(CATCH)
    page.locator(".carts-measured-save").click()
    read = read_measured([bytes(page.evaluate(LAST)).decode("utf-8")])
    assert list(read.tracks[0].t) == pytest.approx(film.times, abs=1e-6)
    if browser_name == "chromium":
        measured_anew(page, read)
        retype(page, "50")
    # The model and the film move together.
    page.locator(".carts-measured-scrub").focus()
    page.keyboard.press("End")
    expect(clock).to_have_text(f"{film.times[-1]:.3f} s")
    expect(page.locator(".carts-film-key")).to_be_visible()
    assert heard == []


def fitted(page: Page) -> None:
    """With the true ratio of the masses in its interval."""
    page.locator(".carts-measured-fit").click()
    expect(page.locator(".carts-measured-known")).to_be_visible(timeout=2 * STARTS)
    report = page.evaluate("document.querySelector('carts-measured').report")
    assert report["outcome"] == "bounce"
    (ratio,) = [one for one in report["known"] if one["key"] == "mass_ratio"]
    assert ratio["low"] <= MADE.ratio <= ratio["high"]


@pytest.mark.one_browser
def test_by_keys_on_a_dark_phone_lost_places_are_mended(
    benches: Path, open_page: OpenPage, broken_off: Filmed
) -> None:
    page = open_page(benches / "empty.html", viewport={"width": 360, "height": 740})
    page.evaluate(DARK)
    page.evaluate(MOVED)
    expect(page.locator("carts-measured[data-state=live]")).to_have_count(1, timeout=STARTS)
    choose(page, "lost.webm", broken_off.content)
    said = page.locator(".carts-film-say")
    expect(said).to_have_text("Click on the mark of cart A.", timeout=STARTS)
    view = page.locator(".carts-film-view")
    swipe(page, view)
    view.focus()
    at = (broken_off.stage.width // 2, broken_off.stage.height // 2)  # where the cross begins
    for aim, place in zip(AIMS, broken_off.clicks(), strict=True):
        expect(page.locator(f"[data-aim={aim}]")).to_have_attribute("aria-pressed", "true")
        at = move(page, at, place)
        page.keyboard.press("Enter")
    page.locator(".carts-film-length").fill("0.5")
    look(page)
    # Single frames by the slider's keys, though the film is short; marks hold for their frame only.
    clock, slider = page.locator(".carts-film-clock"), page.locator(".carts-film-time")
    for key, k in (("ArrowRight", 1), ("ArrowRight", 2), ("ArrowLeft", 1)):
        slider.press(key)
        expect(clock).to_have_text(f"{broken_off.times[k]:.3f} s")
    expect(page.locator("[data-aim=A].carts-film-set")).to_have_count(0)
    page.locator(".carts-film-back").click()
    expect(clock).to_have_text(f"{broken_off.times[0]:.3f} s")
    for place in broken_off.clicks()[:2]:
        click(page, *place)
    expect(said).to_contain_text("Type how long the ruler is")
    page.locator(".carts-film-follow").click()
    expect(said).to_contain_text("Lost places, left out for now: A: 3.", timeout=STARTS)
    page.locator(".carts-film-next").click()
    expect(view).to_be_in_viewport(ratio=0.99)  # where the click goes, and what is said of it
    expect(said).to_be_in_viewport(ratio=0.99)
    for k in (8, 9):  # two by a click each, the third is left out
        expect(said).to_have_text(
            f"Lost at {broken_off.times[k]:.3f} s. Click where the mark of cart A is."
        )
        expect(page.locator(".carts-film-clock")).to_have_text(f"{broken_off.times[k]:.3f} s")
        click(page, *broken_off.stage.place(float(broken_off.places[0][k])))
    expect(said).to_contain_text(f"{broken_off.times[10]:.3f} s")
    look(page)
    page.locator(".carts-film-leave").click()
    expect(said).to_have_text("No lost place is left.")
    page.evaluate("document.querySelector('carts-measured').complete")
    page.locator(".carts-measured-table summary").click()
    rows = page.locator(".carts-measured-table tbody tr td:nth-child(2)").all_inner_texts()
    assert [k for k, text in enumerate(rows) if not text] == [10]
    # Other readings take the place of the film.
    page.locator(".carts-film-again").click()
    expect(said).to_have_text("Click on the mark of cart A.")
    text = {"name": "t.txt", "mimeType": "text/plain", "buffer": b"t;x_A;x_B\n0;0;1\n"}
    page.locator(".carts-measured-file").set_input_files([text])  # type: ignore[list-item]
    expect(page.locator(".carts-film")).to_have_count(0)


def measured_anew(page: Page, read: Measured) -> None:
    """A ruler twice as long makes all places twice as far apart; the carts are the same."""
    mass = page.locator(".carts-measured-masses input").first
    bounce = page.locator("[data-hand=e] input[type=text]")
    for box, typed in ((mass, "0,25"), (bounce, "0.7")):
        box.fill(typed)
        box.dispatch_event("change")  # no keys: after a download Firefox's window has the focus
    page.evaluate("document.querySelector('carts-measured').complete")
    apart = read.tracks[1].value[0] - read.tracks[0].value[0]
    retype(page, "100")
    page.evaluate(CATCH)
    page.locator(".carts-measured-save").click()
    again = read_measured([bytes(page.evaluate(LAST)).decode("utf-8")])
    assert again.tracks[1].value[0] - again.tracks[0].value[0] == pytest.approx(2 * apart, abs=1e-3)
    expect(mass).to_have_value("0,25")
    expect(bounce).to_have_value("0.7")


def swipe(page: Page, view: Locator) -> None:
    """A finger that scrolls the page sets nothing."""
    view.scroll_into_view_if_needed()
    box = view.bounding_box()
    assert box is not None
    before = page.evaluate("scrollY")
    hand = page.context.new_cdp_session(page)
    hand.send("Emulation.setTouchEmulationEnabled", {"enabled": True})
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    for kind, moved in (("touchStart", 0), *(("touchMove", k) for k in range(10, 110, 10))):
        hand.send(
            "Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y - moved}]}
        )
    hand.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    page.wait_for_function("before => scrollY > before", arg=before)
    expect(page.locator(".carts-film-say")).to_have_text("Click on the mark of cart A.")
    expect(page.locator(".carts-film-set")).to_have_count(0)
    hand.send("Emulation.setTouchEmulationEnabled", {"enabled": False})


def retype(page: Page, length: str) -> None:
    """The places are read anew when no more keys come."""
    table = page.locator(".carts-measured-table table")
    before = table.text_content() or ""
    box = page.locator(".carts-film-length")
    box.fill("")  # no keys: after a download Firefox's window has the focus, and they mark nothing
    box.press_sequentially(length)
    expect(table).not_to_have_text(before, timeout=STARTS)


def move(page: Page, at: tuple[int, int], to: tuple[float, float]) -> tuple[int, int]:
    """Move the cross with the arrow keys, first by eight pixels, then by one."""
    for axis, keys in enumerate((("ArrowRight", "ArrowLeft"), ("ArrowDown", "ArrowUp"))):
        left = round(to[axis]) - at[axis]
        key = keys[0] if left > 0 else keys[1]
        for _ in range(abs(left) // 8):
            page.keyboard.press(key)
        for _ in range(abs(left) % 8):
            page.keyboard.press(f"Shift+{key}")
    return round(to[0]), round(to[1])


def look(page: Page) -> None:
    """Nothing is too wide, too pale, or without a name."""
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    assert page.evaluate(PALE) == []
    page.evaluate((ROOT / "node_modules" / "axe-core" / "axe.min.js").read_text("utf-8"))
    found = page.evaluate(RUN_AXE.replace('whole ? document : "article"', "'.carts-film'"))
    assert found == []


# Whoever moves a bench in its page takes it out and puts it in again.
MOVED = """() => {
  const bench = document.querySelector("carts-measured");
  bench.parentElement.append(bench);
}"""
DARK = """() => {
  document.body.dataset.mdColorScheme = "slate";
  const theme = { "default-bg-color": "#1e2129", "default-fg-color": "#e7e9ee",
    "typeset-a-color": "#8fc7f2" };
  for (const [name, colour] of Object.entries(theme)) {
    document.body.style.setProperty(`--md-${name}`, colour);
  }
}"""
