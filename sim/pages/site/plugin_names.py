"""The names under `plugins` in mkdocs.yml. Without ours no site is built; MkDocs tells of one that
is misspelt without a line.
"""

from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches

import yaml

CARTS = "carts"
_NEAR = 0.8  # a plugin that is not installed here may be where the site is built


def plugin_names(plugins: yaml.Node | None) -> Iterator[yaml.ScalarNode]:
    """Where each is named."""
    if isinstance(plugins, yaml.ScalarNode):
        if plugins.value:
            yield plugins
    elif isinstance(plugins, yaml.SequenceNode):
        for entry in plugins.value:
            yield from plugin_names(entry)
    elif isinstance(plugins, yaml.MappingNode):
        yield from (name for name, _ in plugins.value if isinstance(name, yaml.ScalarNode))


def misnamed(plugins: yaml.Node | None) -> Iterator[tuple[yaml.ScalarNode, str]]:
    """Names that are no plugin's and nearly one's, each with that one."""
    from mkdocs.plugins import get_plugins

    installed = {CARTS, *get_plugins()}
    listed = {node.value for node in plugin_names(plugins)}
    short = {name.rpartition("/")[2] for name in installed}
    for name in plugin_names(plugins):
        if name.value.removeprefix("/") not in installed | short:
            near = get_close_matches(name.value.lower(), short, n=1, cutoff=_NEAR)
            yield from ((name, meant) for meant in near if meant not in listed)
