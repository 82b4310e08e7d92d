"""A site as a SCORM 1.2 package: one learning object around all lessons.

A page of its own frames the site and speaks to the platform (sim/web/site/scorm.js). The lessons
know nothing of it; it hears their events when a form is handed in or a file of answers is saved.
Answers stay in the student's browser.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

import sim

PAGE = "scorm.html"
SCRIPT = "scorm.js"
MANIFEST = "imsmanifest.xml"
_LONGEST_TITLE = 200  # that the schema of a manifest allows
_POLICY = "default-src 'none'; script-src 'self'; style-src 'self'; frame-src 'self'"
_HTML = """<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title><link rel="stylesheet" href="scorm.css"></head>
<body><iframe src="index.html" title={quoted}></iframe>
<script src="scorm.js"></script></body></html>
"""
_STYLE = (
    "html, body { margin: 0; height: 100%; overflow: hidden; }\n"
    "iframe { display: block; border: 0; width: 100%; height: 100%; }\n"
)


def scorm_files(title: str, site_id: str, names: Iterable[str]) -> dict[str, bytes]:
    """What a package has beside the site, by path; `names`: the paths of the site's own files."""
    page = _HTML.format(policy=_POLICY, title=escape(title), quoted=quoteattr(title))
    script = Path(sim.__file__).parent / "web" / "site" / SCRIPT
    own = {
        PAGE: page.encode(),
        "scorm.css": _STYLE.encode(),
        SCRIPT: script.read_bytes(),
    }
    return {**own, MANIFEST: _manifest(title, site_id, [*own, *names]).encode()}


def _manifest(title: str, site_id: str, names: Iterable[str]) -> str:
    title = title[:_LONGEST_TITLE]
    files = "\n".join(f"      <file href={quoteattr(name)}/>" for name in sorted(names))
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier={quoteattr(f"carts-{site_id}")} version="1.0"
    xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
    xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2">
  <metadata><schema>ADL SCORM</schema><schemaversion>1.2</schemaversion></metadata>
  <organizations default="carts">
    <organization identifier="carts">
      <title>{escape(title)}</title>
      <item identifier="lessons" identifierref="site"><title>{escape(title)}</title></item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="site" type="webcontent" adlcp:scormtype="sco" href="{PAGE}">
{files}
    </resource>
  </resources>
</manifest>
"""
