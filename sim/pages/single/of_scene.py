"""One scene as one HTML file, for a learning platform or a message: Python and all, no folder.

The runtime's scripts, which a page otherwise loads one by one, stand in the file itself; the page's
script finds them there. The policy names each script by its hash and allows no other.
"""

from __future__ import annotations

import html
from collections.abc import Callable
from pathlib import Path

from sim.pages import licences
from sim.pages.blocks.bake import bake
from sim.pages.blocks.scene_block import SceneBlock
from sim.pages.findings import AuthorError, SiteError
from sim.pages.head.policy import policy_of_file
from sim.pages.single.all_inside import INSIDE, runtime_scripts
from sim.pages.site import files as site_files
from sim.pages.site.carried import node_modules
from sim.pages.widget import render
from sim.pages.widget.worlds import WORLDS
from sim.scene.fence.presentation import TOOLS

LOOK = """\
body { margin: 1rem auto; padding: 0 0.6rem; max-width: 62rem; line-height: 1.5;
  font-family: system-ui, "Segoe UI", Roboto, Arial, sans-serif; background: #fff; color: #1a1a1a; }
pre { white-space: pre-wrap; font-size: 0.8rem; }
@media (prefers-color-scheme: dark) { body { background: #1e2129; color: #e6e6e6; } }
"""

PAGE = """\
<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="carts-site" content="{site_id}"><meta name="carts-page" content="{id}">
<title>{title}</title><link rel="icon" href="data:,">
<style>{style}</style></head>
<body><main>{element}</main>
<details><summary>Made with Newton's Carts. Licences</summary><pre>{licences}</pre></details>
{scripts}
</body></html>
"""


def single_file(
    block: SceneBlock, root: Path, *, site_id: str, report: Callable[[str], None]
) -> str:
    """The file's text; raises `AuthorError` where the scene cannot run, `SiteError` where parts of
    the page cannot be had. `site_id`: the name that a prediction is kept under."""
    fence, modules = block.fence, node_modules(root)
    run = bake(fence.plain)
    if isinstance(run, list):
        raise AuthorError(map(block.places.finding, run))
    packages = run.packages | set(fence.packages) | ({WORLDS} if fence.worlds else set())
    try:
        css = site_files.site_files(modules)[site_files.ASSETS + "carts.css"].decode()
        carts = site_files.scene_script().decode()
        scripts = [INSIDE, *runtime_scripts(packages, root, report), carts]
        if set(fence.opened) & set(TOOLS):
            scripts.append(site_files.own_script("tools").decode())
        if fence.worlds:
            scripts.append(site_files.own_script("worlds").decode())
    except site_files.MissingFilesError as error:
        raise SiteError(str(error)) from error
    works = licences.notices(modules, scenes=True, packages=packages)
    style = LOOK + css
    return PAGE.format(
        policy=policy_of_file([style], scripts, images="data: blob:", python=True),
        site_id=html.escape(site_id),
        id=fence.id,
        title=html.escape(fence.scene.title or "Carts"),
        style=style,
        element=render(fence, run.header, run.numbers),
        licences=html.escape(licences.licence_file(works)),
        scripts="\n".join(f"<script>{script}</script>" for script in scripts),
    )
