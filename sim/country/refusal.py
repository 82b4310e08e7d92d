"""Why a table of answers cannot be written or read."""

from __future__ import annotations

from sim.scene.said import template


class CountryError(ValueError):
    """This table cannot be used; the message is for people."""


MISSING = template('this needs more packages: pip install "newtons-carts[country]"')
"""Where the extra `country` is not installed."""

PACKAGES = frozenset({"ibis", "pyarrow", "duckdb", "pandas", "pyspark"})
"""What the extra brings, or a backend needs."""
