"""Our commands as they are called in a terminal."""

from __future__ import annotations

import json
from typing import Any

from click.testing import CliRunner, Result

from sim.cli import main


def carts(*words: object, **more: Any) -> Result:
    return CliRunner().invoke(main, [*map(str, words)], **more)


def carts_class(*words: object) -> Result:
    return carts("class", *words)


def as_json(*words: object) -> dict[str, Any]:
    """The report that `carts class` prints."""
    result = carts_class(*words, "--json")
    assert result.exit_code == 0, result.output
    report: dict[str, Any] = json.loads(result.stdout)
    return report
