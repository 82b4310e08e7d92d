"""`OPEN ME.html`, the start page in a zip of lessons: it must say something useful even alone.

Style and script stand in the page itself, each allowed by its hash: a zip viewer may show this one
file without its neighbours.
"""

from __future__ import annotations

import html
import re
from pathlib import Path

import sim
from sim.pages.head.policy import policy_of_file
from sim.pages.language import ENGLISH, mark, speaking, tr_html, words

NAME = "OPEN ME.html"
IMAGES = "'self' file: data:"  # a folder opened as file: is its own origin in no browser
_SCRIPT = Path(sim.__file__).parent / "web" / "site" / "open-me.js"

STYLE = """\
body { margin: 0 auto; padding: 1.5rem 1rem; max-width: 40rem; background: #fff; color: #1a1a1a;
  font: 1.1rem/1.55 system-ui, "Segoe UI", Roboto, Arial, sans-serif; }
h1 { font-size: 1.6rem; line-height: 1.25; }
h2 { font-size: 1.15rem; margin-bottom: 0.3rem; }
.go { display: inline-block; padding: 0.7rem 1.4rem; border-radius: 0.4rem; font-weight: 600;
  background: #1d4f8c; color: #fff; text-decoration: none; }
.go:focus-visible { outline: 3px solid #f0a30a; outline-offset: 2px; }
.box { border-left: 5px solid #b3261e; padding: 0.1rem 1rem; background: #fdf1f0; }
.note { border-left: 5px solid #b26a00; padding: 0.1rem 1rem; background: #fff6e5; }
.small { font-size: 0.9rem; color: #555; }
@media (prefers-color-scheme: dark) {
  body { background: #1e2129; color: #e6e6e6; }
  .go { background: #8ab8f5; color: #10243d; }
  .box { background: #3a2022; } .note { background: #372b14; } .small { color: #b5b5b5; }
}
"""

# Between two stars stands what is to be pressed or found on the screen.
_WORDS = {
    "looking": mark("Looking at this browser …"),
    "no_script": mark(
        "JavaScript is switched off. You can read the lessons and see the pictures, but nothing "
        "moves. Switch JavaScript on for this page."
    ),
    "open": mark("Open the lessons"),
    "unpack": mark("Unpack first"),
    "alone": mark(
        "This page is alone: the files of the lessons are not beside it. You have opened it "
        "**inside the zip**, or it was copied without its folder. Nothing is broken."
    ),
    "windows": mark("On Windows"),
    "close": mark("Close this page."),
    "windows_click": mark("Click the zip file with the **right** mouse button."),
    "windows_extract": mark("Choose **Extract All…**, then **Extract**."),
    "windows_open": mark("A folder opens. In it double-click **OPEN ME**."),
    "chromeos": mark("On a Chromebook"),
    "chromeos_close": mark("Close this page. Open **Files**."),
    "chromeos_extract": mark(
        "Click the zip with two fingers, choose **Extract all**. A folder appears beside it."
    ),
    "chromeos_open": mark("Open that folder and double-click **OPEN ME**."),
    "chromeos_nothing": mark(
        "If nothing opens, your school may not allow pages from files. Ask for the address of "
        "the lessons on the web."
    ),
    "mac": mark("On a Mac"),
    "mac_extract": mark(
        "Close this page. In the Finder double-click the zip. A folder appears beside it."
    ),
    "folder_open": mark("Open the folder and double-click **OPEN ME**."),
    "linux": mark("On Linux"),
    "linux_extract": mark(
        "Close this page. Click the zip with the right mouse button, choose **Extract here**."
    ),
    "phone": mark("On a phone or tablet"),
    "phone_ask": mark(
        "Phones and tablets seldom open a folder of pages. Ask for the address of the lessons on "
        "the web, or use a computer."
    ),
    "ready": mark("This browser can run everything. No network is needed."),
    "old": mark("This browser is too old, or runs no programs in pages"),
    "old_take": mark(
        "Texts, pictures and graphs work. Sliders do not. "
        "Take Chrome or Edge 103, Firefox 113, Safari 16.4, or anything newer."
    ),
    "still_zip": mark(
        "This folder lies inside a zip. Copy it out first: what you type may be lost otherwise."
    ),
    "no_storage": mark(
        "This browser keeps nothing (a private window?). Save your answers as a file before you "
        "close a page: **My answers**, **Save file**."
    ),
    "stays": mark("What you type stays in this browser, on this computer. Nothing is sent."),
}

_PAGE = """\
<!doctype html>
<html lang="{language}"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title><link rel="icon" href="data:,">
<style>{style}</style></head>
<body data-state="checking"><main>
<h1>{title}</h1>
<p id="checking">{looking}</p>
<noscript><div class="note"><p>{no_script}</p></div>
<p><a class="go" href="index.html">{open}</a></p></noscript>

<div id="alone" class="box" hidden><h2>{unpack}</h2>
<p>{alone}</p></div>
<section id="unpack-windows" hidden><h2>{windows}</h2><ol>
<li>{close}</li><li>{windows_click}</li>
<li>{windows_extract}</li>
<li>{windows_open}</li></ol></section>
<section id="unpack-chromeos" hidden><h2>{chromeos}</h2><ol>
<li>{chromeos_close}</li>
<li>{chromeos_extract}</li>
<li>{chromeos_open}</li></ol>
<p>{chromeos_nothing}</p></section>
<section id="unpack-mac" hidden><h2>{mac}</h2><ol>
<li>{mac_extract}</li>
<li>{folder_open}</li></ol></section>
<section id="unpack-linux" hidden><h2>{linux}</h2><ol>
<li>{linux_extract}</li>
<li>{folder_open}</li></ol></section>
<section id="unpack-phone" hidden><h2>{phone}</h2>
<p>{phone_ask}</p></section>

<div id="ready" hidden><p>{ready}</p></div>
<div id="old" class="note" hidden><h2>{old}</h2>
<p>{old_take}</p></div>
<p id="open" hidden><a class="go" href="index.html">{open}</a></p>
<div id="still-zip" class="note" hidden><p>{still_zip}</p></div>
<div id="no-storage" class="note" hidden><p>{no_storage}</p></div>
<p class="small">{stays}</p>
</main>
<script>{script}</script>
</body></html>
"""


def open_me(title: str, language: str = ENGLISH) -> str:
    """The page for the lessons called `title`, in one of our languages."""
    script = _SCRIPT.read_text(encoding="utf-8")
    with speaking(words(language)):
        told = {name: _bold(tr_html(text)) for name, text in _WORDS.items()}
    return _PAGE.format(
        language=language,
        title=html.escape(title),
        style=STYLE,
        script=script,
        policy=policy_of_file([STYLE], [script], images=IMAGES),
        **told,
    )


def _bold(text: str) -> str:
    return re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", str(text))
