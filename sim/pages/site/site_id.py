"""The name of a site, under which a browser keeps the answers of its readers."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from sim.pages.findings import SiteError

_SITE_ID = re.compile(r"[a-z0-9][a-z0-9-]{2,39}")
_SITE_ID_HELP = """\
mkdocs.yml: error: extra.carts.site_id is missing or not allowed
  hint: a name for your site, 3 to 40 small letters, digits and hyphens; answers are stored under it
    extra:
      carts:
        site_id: my-school-physics"""

_NO_TABLE = """\
mkdocs.yml: error: extra: carts: is no table
  hint: write what belongs to it below, indented
    extra:
      carts:
        site_id: my-school-physics"""


def facts_of(extra: object) -> Mapping[str, Any]:
    """What `extra:` of mkdocs.yml says under `carts:`; raises `SiteError` for no table."""
    carts = extra.get("carts") if isinstance(extra, Mapping) else extra
    if carts is None:
        return {}
    if not isinstance(carts, Mapping):
        raise SiteError(_NO_TABLE)
    return carts


def check_site_id(site_id: str) -> None:
    """Raises `SiteError` with what to write where there is no such name."""
    if not _SITE_ID.fullmatch(site_id):
        raise SiteError(_SITE_ID_HELP)
