"""Which options somebody typed: a default is nobody's word, and is never refused."""

from __future__ import annotations

from collections.abc import Iterable

import click
from click.core import ParameterSource


def typed(ctx: click.Context, names: Iterable[str]) -> tuple[str, ...]:
    """Those of these parameters that stood on the command line."""
    line = ParameterSource.COMMANDLINE
    return tuple(name for name in names if ctx.get_parameter_source(name) == line)
