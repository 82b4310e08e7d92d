"""Whether an address in a lesson leads away from the files of its site.

A scheme is a scheme in any letters: the keyboard of a phone begins a line with Https.
"""

from __future__ import annotations

import re

_ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:|//", re.IGNORECASE)


def leads_elsewhere(address: str) -> bool:
    """To another server, or to what is no file at all: mail, data in the address itself."""
    return _ELSEWHERE.match(address.strip()) is not None
