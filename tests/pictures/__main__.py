"""The loop at the top of the README: predict, lock, the arrows grow, the light cart flies.

Taken frame by frame from the built lesson, each at its own time of the cart, so that a slow
computer gives the same film. Needs `make site`, and ffmpeg from Debian's packages.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

from tests.conftest import ROOT
from tests.web.conftest import LAUNCH, LIGHT

PAGE = ROOT / "site" / "worksheets" / "newtons-third-law.html"
SCENE = "third-heavy-into-light"
OUT = ROOT / "docs" / "assets" / "loop.gif"
STILL = ROOT / "docs" / "assets" / "loop-still.png"
RATE = 12  # frames per second
MOST_BYTES = 2_000_000
SIZE = (1076, 560)  # px of the page; the film is WIDTH wide
WIDTH = 760
GUESS = {"A": 0.25, "B": 0.8}  # of the longest arrow: what most people expect
TOUCH, APART, END = 1.25, 1.429, 2.05  # s, of this scene


def main() -> int:
    """Write both pictures; 1 and a sentence where something is missing."""
    program = shutil.which("ffmpeg")
    if not PAGE.exists() or program is None:
        print("This needs `make site`, and ffmpeg (apt-get install ffmpeg).", file=sys.stderr)
        return 1
    with tempfile.TemporaryDirectory() as folder:
        count = film(Path(folder))
        colours = "split[a][b];[a]palettegen=max_colors=96[p];[b][p]paletteuse=dither=none"
        subprocess.run(
            [program, "-y", "-loglevel", "error", "-framerate", str(RATE), "-i",
             f"{folder}/%04d.png", "-vf", f"scale={WIDTH}:-1:flags=lanczos,{colours}", str(OUT)],
            check=True,
        )  # fmt: skip
        shutil.copy(Path(folder) / f"{count * 3 // 4:04d}.png", STILL)
    size = OUT.stat().st_size
    print(f"{OUT.relative_to(ROOT)}: {size / 1e6:.2f} MB, {count / RATE:.1f} s")
    return 0 if size <= MOST_BYTES else 1


def film(folder: Path) -> int:
    """Write the frames; how many there are."""
    light = {"executable_path": LIGHT} if LIGHT.exists() else {}
    count = 0
    with sync_playwright() as driver:
        browser = driver.chromium.launch(**LAUNCH["chromium"] | light)
        page = browser.new_page(viewport={"width": 1366, "height": 900})
        page.goto(PAGE.as_uri())
        page.wait_for_selector(f"#{SCENE}[data-state=live]", timeout=60_000)
        for times in story(page):
            box = page.locator(f"#{SCENE}").bounding_box()
            assert box
            clip = {"x": box["x"], "y": box["y"], "width": SIZE[0], "height": SIZE[1]}
            picture = page.screenshot(clip=clip)  # type: ignore[arg-type]
            for _ in range(times):
                (folder / f"{count:04d}.png").write_bytes(picture)
                count += 1
        browser.close()
    return count


def story(page: Page) -> Iterator[int]:
    """Brings the page from one frame to the next; yields how often each is shown."""
    scene = page.locator(f"#{SCENE}")
    scene.evaluate("one => scrollTo(0, one.getBoundingClientRect().top + scrollY - 60)")
    yield 4
    for part in range(1, 7):
        for on, length in GUESS.items():
            slider = scene.locator(f'.carts-guess[data-on="{on}"] [type=range]')
            slider.evaluate(
                """(one, value) => { one.value = value;
                one.dispatchEvent(new Event("input", { bubbles: true })); }""",
                length * part / 6,
            )
        yield 1
    scene.get_by_label("I am sure").check()
    yield 5
    scene.locator(".carts-lock").click()
    scene.locator(".carts-talk-run").click()
    page.wait_for_selector(f"#{SCENE} .carts-play:enabled")
    for at in seconds():
        scene.evaluate("(one, t) => { one.time = t }", at)
        yield 1
    scene.locator(".carts-end").click()
    scene.evaluate(f"one => {{ one.time = {END} }}")
    yield 8


def seconds() -> Iterator[float]:
    """Times of the cart for each frame: slow while they touch."""
    approach, contact, flight = 9, 22, 10
    yield from (0.9 + (TOUCH - 0.9) * k / approach for k in range(approach))
    yield from (TOUCH + (APART - TOUCH) * k / contact for k in range(contact))
    yield from (APART + (END - APART) * k / flight for k in range(flight + 1))


if __name__ == "__main__":
    raise SystemExit(main())
