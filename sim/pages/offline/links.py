"""What a page says of itself to whom it is sent: title, description, picture (Open Graph)."""

from __future__ import annotations

import re
from html import escape, unescape

_TITLE = re.compile(r"<title>(.*?)</title>", re.DOTALL)
_DESCRIPTION = re.compile(r'<meta name="description" content="([^"]*)">')
_ARTICLE = re.compile(r"<article\b.*?</article>", re.DOTALL)
_PARAGRAPH = re.compile(r"<p>(.*?)</p>", re.DOTALL)
_TAG = re.compile(r"<[^>]+>")
LONGEST = 200  # characters; what messengers show


def with_preview(page: str, *, site_name: str, about: str, address: str, picture: str) -> str:
    """The page with what a messenger shows of it. `about`: what the whole site says of itself;
    `address` and `picture` are whole addresses, or empty where the site does not know its own."""
    found = _TITLE.search(page)
    title = unescape(found[1]).removesuffix(f" - {site_name}").strip() if found else site_name
    stated = _DESCRIPTION.search(page)
    words = unescape(stated[1]) if stated else ""
    if not words or words == about:
        words = first_words(page) or words
    facts = {
        "og:type": "website",
        "og:site_name": site_name,
        "og:title": title,
        "og:description": words,
        "og:url": address,
        "og:image": picture,
    }
    rows = [f'<meta property="{n}" content="{escape(v)}">' for n, v in facts.items() if v]
    if picture:
        rows.append('<meta name="twitter:card" content="summary_large_image">')
    if words:
        described = f'<meta name="description" content="{escape(words)}">'
        if stated:
            page = page.replace(stated[0], described, 1)
        else:
            rows.append(described)
    return page.replace("</head>", "".join(f"{row}\n" for row in rows) + "</head>", 1)


def first_words(page: str) -> str:
    """The first paragraph of the text that says something."""
    article = _ARTICLE.search(page)
    for paragraph in _PARAGRAPH.finditer(article[0] if article else ""):
        words = " ".join(unescape(_TAG.sub("", paragraph[1])).split())
        if len(words) > 20:
            return words if len(words) <= LONGEST else words[:LONGEST].rsplit(" ", 1)[0] + " …"
    return ""
