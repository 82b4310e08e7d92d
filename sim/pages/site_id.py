"""The name of a site, under which a browser keeps the answers of its readers."""

from __future__ import annotations

import re

from sim.pages.findings import SiteError

_SITE_ID = re.compile(r"[a-z0-9][a-z0-9-]{2,39}")
_SITE_ID_HELP = """\
mkdocs.yml: error: extra.carts.site_id is missing or not allowed
  hint: a name for your site, 3 to 40 small letters, digits and hyphens; answers are stored under it
    extra:
      carts:
        site_id: my-school-physics"""


def check_site_id(site_id: str) -> None:
    """Raises `SiteError` with what to write where there is no such name."""
    if not _SITE_ID.fullmatch(site_id):
        raise SiteError(_SITE_ID_HELP)
