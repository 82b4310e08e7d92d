"""The mark of texts that readers read, in the schemas of everything that an author writes.

Lessons in other languages are made by it: what bears the mark is translated; numbers, names and
keys are not. It is a word of our own in the published schemas, which editors pass over.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

MARK = "x-prose"
PROSE: Mapping[str, Any] = {"type": "string", "minLength": 1, MARK: True}
PROSES: Mapping[str, Any] = {"anyOf": [PROSE, {"type": "array", "items": PROSE}]}
NAMED: Mapping[str, Any] = {"type": "object", "propertyNames": {MARK: True}}
"""A table whose keys are read."""
