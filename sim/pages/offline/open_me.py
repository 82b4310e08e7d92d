"""`OPEN ME.html`, the start page in a zip of lessons: it must say something useful even alone.

Style and script stand in the page itself, each allowed by its hash: a zip viewer may show this one
file without its neighbours.
"""

from __future__ import annotations

import base64
import hashlib
import html
from pathlib import Path

import sim

NAME = "OPEN ME.html"
_SCRIPT = Path(sim.__file__).parent / "web" / "site" / "open-me.js"

_STYLE = """\
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

_PAGE = """\
<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title><link rel="icon" href="data:,">
<style>{style}</style></head>
<body data-state="checking"><main>
<h1>{title}</h1>
<p id="checking">Looking at this browser …</p>
<noscript><div class="note"><p>JavaScript is switched off. You can read the lessons and see the
pictures, but nothing moves. Switch JavaScript on for this page.</p></div>
<p><a class="go" href="index.html">Open the lessons</a></p></noscript>

<div id="alone" class="box" hidden>
<h2>Unpack first</h2>
<p>This page is alone: the files of the lessons are not beside it. You have opened it <b>inside the
zip</b>, or it was copied without its folder. Nothing is broken.</p></div>
<section id="unpack-windows" hidden><h2>On Windows</h2><ol>
<li>Close this page.</li><li>Click the zip file with the <b>right</b> mouse button.</li>
<li>Choose <b>Extract All…</b>, then <b>Extract</b>.</li>
<li>A folder opens. In it double-click <b>OPEN ME</b>.</li></ol></section>
<section id="unpack-chromeos" hidden><h2>On a Chromebook</h2><ol>
<li>Close this page. Open <b>Files</b>.</li>
<li>Click the zip with two fingers, choose <b>Extract all</b>. A folder appears beside it.</li>
<li>Open that folder and double-click <b>OPEN ME</b>.</li></ol>
<p>If nothing opens, your school may not allow pages from files. Ask for the address of the
lessons on the web.</p></section>
<section id="unpack-mac" hidden><h2>On a Mac</h2><ol>
<li>Close this page. In the Finder double-click the zip. A folder appears beside it.</li>
<li>Open the folder and double-click <b>OPEN ME</b>.</li></ol></section>
<section id="unpack-linux" hidden><h2>On Linux</h2><ol>
<li>Close this page. Click the zip with the right mouse button, choose <b>Extract here</b>.</li>
<li>Open the folder and double-click <b>OPEN ME</b>.</li></ol></section>
<section id="unpack-phone" hidden><h2>On a phone or tablet</h2>
<p>Phones and tablets seldom open a folder of pages. Ask for the address of the lessons on the
web, or use a computer.</p></section>

<div id="ready" hidden><p>This browser can run everything. No network is needed.</p></div>
<div id="old" class="note" hidden><h2>This browser is too old, or runs no programs in pages</h2>
<p>Texts, pictures and graphs work. Sliders do not. Take Chrome or Edge 103, Firefox 113,
Safari 16.4, or anything newer.</p></div>
<p id="open" hidden><a class="go" href="index.html">Open the lessons</a></p>
<div id="still-zip" class="note" hidden><p>This folder lies inside a zip. Copy it out
first: what you type may be lost otherwise.</p></div>
<div id="no-storage" class="note" hidden><p>This browser keeps nothing (a private window?).
Save your answers as a file before you close a page: <b>My answers</b>, <b>Save file</b>.</p></div>
<p class="small">What you type stays in this browser, on this computer. Nothing is sent.</p>
</main>
<script>{script}</script>
</body></html>
"""


def open_me(title: str) -> str:
    """The page for the lessons called `title`."""
    script = _SCRIPT.read_text(encoding="utf-8")
    return _PAGE.format(
        title=html.escape(title), style=_STYLE, script=script, policy=_policy(_STYLE, script)
    )


def _policy(style: str, script: str) -> str:
    def named(text: str) -> str:
        digest = hashlib.sha256(text.encode()).digest()
        return f"'sha256-{base64.b64encode(digest).decode()}'"

    rules = {
        "default-src": "'none'",
        "script-src": named(script),
        "style-src": named(style),
        "img-src": "'self' file: data:",
        "worker-src": "blob:",
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    return html.escape("; ".join(f"{key} {value}" for key, value in rules.items()), quote=True)
