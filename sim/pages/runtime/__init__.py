"""The runtime: Pyodide, our package and, where asked for, numpy and scipy, as files of a site.

`pack` fetches, verifies, compiles, takes the memory snapshot and writes the scripts of a page.
How and why: docs/developers/runtime.md.
"""

from .cache import default_cache
from .node import RuntimePackError
from .ours import CLASSROOM, MEASURED, OWN_LAW, PROOF, TEACHER, WORLDS
from .pack import RuntimeFacts, pack
from .ready import DamagedError, write_ready
from .sources import MissingSourceError

ERRORS = (RuntimePackError, MissingSourceError)
"""What `pack` raises; the message is for the person who builds."""

__all__ = [
    "CLASSROOM",
    "ERRORS",
    "MEASURED",
    "OWN_LAW",
    "PROOF",
    "TEACHER",
    "WORLDS",
    "DamagedError",
    "MissingSourceError",
    "RuntimeFacts",
    "RuntimePackError",
    "default_cache",
    "pack",
    "write_ready",
]
