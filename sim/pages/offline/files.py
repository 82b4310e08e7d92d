"""The service worker of a site: which files it keeps, and which version of them this is."""

from __future__ import annotations

import hashlib
import json
import re
from pathlib import Path
from typing import Any

from sim.pages.text.films import FILMS

WORKER = "sw.js"
LEFT_OUT = re.compile(
    r"sw\.js|sitemap\.xml(\.gz)?|.*\.map|CNAME|_headers|_redirects|_config\.yml|robots\.txt"
    r"|(?:.*/)?\..*"  # hidden files and folders: .nojekyll, .DS_Store, .git/
    rf"|(?i:.*(?:{'|'.join(map(re.escape, FILMS))}))"
)
"""What is for a server or nobody. Many servers answer 404 for it, and of a list with one such file
in it a browser keeps nothing at all. Films are too large to be kept, and asked for in pieces."""

FEW = re.compile(
    r"assets/carts/(?:runtime/(?:numpy|scipy|python-more|newtons_carts_)"
    r"|lessons/|prepared/|download/|teacher\.|class|film|measured)"
)
"""What few pages load: kept when a page loads it. The rest of the site is kept at once."""

DIGITS = 32  # of a sha256 in hexadecimal


def listed(site: Path) -> dict[str, list[Any]]:
    """Each file of the site: its hash, and whether it is kept at once."""
    rows: dict[str, list[Any]] = {}
    for path in sorted(site.rglob("*")):
        name = path.relative_to(site).as_posix()
        if path.is_file() and not LEFT_OUT.fullmatch(name):
            digest = hashlib.sha256(path.read_bytes()).hexdigest()[:DIGITS]
            rows[name] = [digest, 0 if FEW.match(name) else 1]
    return dict(sorted(rows.items()))


def worker(template: str, site_id: str, files: dict[str, list[Any]]) -> str:
    """The text of the service worker; equal sites have equal ones."""
    rows = json.dumps(files, ensure_ascii=False, separators=(",", ":"))
    version = hashlib.sha256((template + rows).encode("utf-8")).hexdigest()[:16]
    for place, value in (("@@VERSION@@", version), ("@@SITE@@", site_id)):
        template = template.replace(f'"{place}"', json.dumps(value))
    return template.replace('"@@FILES@@"', rows.replace("<", "\\u003c"))
