"""The page for an address that leads nowhere, on a web server.

A server shows it at any address, so it can name its files only from the site's address. Where that
is not known (`site_url`, or what a build on GitHub is told) the page needs no file: its style
and a script that looks for the way home stand in it, each allowed by its hash.
"""

from __future__ import annotations

import os
import re
from html import escape
from pathlib import Path
from urllib.parse import urlsplit

import sim
from sim.pages.findings import SiteError
from sim.pages.head.policy import policy_of_file
from sim.pages.language import speaking, tr_html, words
from sim.pages.offline.hosting import PREVIEW
from sim.pages.offline.open_me import IMAGES, STYLE
from sim.pages.site.build import SiteBuild
from sim.pages.site.files import ASSETS
from sim.pages.text.not_found import THEMES, language_in

ADDRESS = "CARTS_SITE_URL"
"""The environment variable with the site's address, for who builds without writing `site_url`."""
_SCRIPT = Path(sim.__file__).parent / "web" / "site" / "not-found.js"
_PAGE = """\
<!doctype html>
<html lang="{language}"><head>
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{heading} - {site}</title><link rel="icon" href="data:,">
<style>{style}</style></head>
<body><main>
<h1>{heading}</h1>
<p>{why}</p>
<p>{back}</p>
<p id="home" hidden><a class="go" href="index.html">{home}</a></p>
</main>
<script>{script}</script>
</body></html>
"""


def address_told() -> str:
    """The address in the environment, with a slash at its end; "" for none. Raises SiteError."""
    told = os.environ.get(ADDRESS, "").strip()
    if told and not re.match(r"https?://\w", told):
        raise SiteError(f"{ADDRESS} is no address of a site, as https://school.example/: {told}")
    return told and told.rstrip("/") + "/"


def finished(build: SiteBuild, html: str, address: str) -> str:
    """A page that no Markdown file stands behind, in a site at `address` ("": not known)."""
    if build.hosting and not address and THEMES in html:
        return _alone(build.hosting.site_name, language_in(html))
    root = "" if build.audience == "offline" else urlsplit(address or "/").path
    return build.finished(html, root + ASSETS)


def _alone(site: str, language: str) -> str:
    script = _SCRIPT.read_text(encoding="utf-8").replace("@@PICTURE@@", PREVIEW)
    with speaking(words(language)):
        return _PAGE.format(
            language=language,
            site=escape(site),
            heading=tr_html("This page is not here"),
            why=tr_html("It may have moved, or its address is not quite right."),
            home=tr_html("Home, with all lessons"),
            back=tr_html("Go back to where you came from, or ask for the address of the lessons."),
            style=STYLE,
            script=script,
            policy=policy_of_file([STYLE], [script], images=IMAGES),
        )
