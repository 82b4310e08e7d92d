"""What a web server gets beside the pages: link previews, manifest, icons, stamps, the worker."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import quote

import sim
from sim.pages.offline import files, shapes
from sim.pages.offline.links import with_preview
from sim.pages.offline.stamps import stamp_pages
from sim.pages.text.lesson_places import page_of

MANIFEST = "manifest.webmanifest"
ICONS = "assets/carts/icons/"
PREVIEW = ICONS + "preview.png"
_SITE = Path(sim.__file__).parent / "web" / "site"


@dataclass(frozen=True, slots=True)
class Hosting:
    """`site_url`: where the site will be, empty if it is not known. `offline`: whether it shall be
    kept on the readers' computers."""

    site_name: str
    about: str = ""
    site_url: str = ""
    offline: bool = True

    def head(self, page: str, name: str | None, assets: str) -> str:
        """The page `name` (its Markdown file) with what it says of itself; `assets` leads from it
        to assets/carts/."""
        base = self.site_url.rstrip("/") + "/" if self.site_url else ""
        address = base + quote(page_of(name or "index.md")) if base else ""
        page = with_preview(
            page,
            site_name=self.site_name,
            about=self.about,
            address=address.removesuffix("index.html"),
            picture=base + PREVIEW if base else "",
        )
        if not self.offline:
            return page
        root = assets.removesuffix("assets/carts/")
        rows = [
            f'<link rel="manifest" href="{root}{MANIFEST}">',
            f'<meta name="theme-color" content="{shapes.hexa(shapes.BLUE)}">',
            f'<link rel="apple-touch-icon" href="{root}{ICONS}icon-180.png">',
            f'<script src="{assets}offline.js" async></script>',
        ]
        return page.replace("</head>", "".join(f"{row}\n" for row in rows) + "</head>", 1)

    def manifest(self) -> dict[str, Any]:
        """The facts of the app. All addresses are relative: the site may lie anywhere."""
        icons = [
            {"src": f"{ICONS}icon.svg", "sizes": "any", "type": "image/svg+xml"},
            *(
                {"src": f"{ICONS}icon-{size}.png", "sizes": f"{size}x{size}", "type": "image/png"}
                for size in (192, 512)
            ),
            {
                "src": f"{ICONS}icon-full.png",
                "sizes": "512x512",
                "type": "image/png",
                "purpose": "maskable",
            },
        ]
        facts = {
            "name": self.site_name,
            "short_name": self.site_name[:12].rstrip(),
            "description": self.about,
            "id": "./",
            "start_url": "./index.html",
            "scope": "./",
            "display": "standalone",
            "background_color": shapes.hexa(shapes.PAPER),
            "theme_color": shapes.hexa(shapes.BLUE),
            "icons": icons,
        }
        return {key: value for key, value in facts.items() if value}

    def write(self, site: Path, site_id: str) -> None:
        """The files; must come last, the service worker lists all others with their hashes."""
        if self.offline:
            script = (_SITE / "offline.js").read_bytes()
            (site / "assets" / "carts" / "offline.js").write_bytes(script)
        stamp_pages(site)
        sign = shapes.sign()
        (site / ICONS).mkdir(parents=True, exist_ok=True)
        (site / PREVIEW).write_bytes(shapes.png(sign, 1200, 630))
        if not self.offline:  # a browser that kept an earlier version forgets it
            gone = (_SITE / "sw-gone.js").read_text(encoding="utf-8")
            (site / files.WORKER).write_text(files.worker(gone, site_id, {}), encoding="utf-8")
            return
        (site / ICONS / "icon.svg").write_text(shapes.svg(sign), encoding="utf-8")
        for size in (180, 192, 512):
            (site / ICONS / f"icon-{size}.png").write_bytes(shapes.png(sign, size, size))
        (site / ICONS / "icon-full.png").write_bytes(shapes.png(sign, 512, 512, 0.8))
        text = json.dumps(self.manifest(), ensure_ascii=False, indent=1)
        (site / MANIFEST).write_text(text + "\n", encoding="utf-8")
        template = (_SITE / "sw.js").read_text(encoding="utf-8")
        made = files.worker(template, site_id, files.listed(site))
        (site / files.WORKER).write_text(made, encoding="utf-8")
