"""What is wrong with the mkdocs.yml of a site, with its place, before anything is built.

MkDocs says much of this too, but by its own names and without a line; of some it breaks off. What
is not ours to know (settings of other plugins) stays with it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from sim.pages.findings import Finding, SiteError
from sim.pages.site.menu_names import named_in_vain, theme_templates
from sim.pages.site.plugin_names import CARTS, misnamed, plugin_names
from sim.pages.site.site_id import check_site_id
from sim.scene.problem import did_you_mean, meant, nearest

SETTINGS = "mkdocs.yml"
_LANGUAGES = Path("partials") / "languages"
_FACTS = ("site_id", "made_with")
Pairs = list[tuple[yaml.Node, yaml.Node]]


def settings_findings(root: Path, own: Mapping[str, Any]) -> list[Finding]:
    """Everything that is wrong with mkdocs.yml in `root`, in the order of its lines.

    `own`: what may stand under `plugins: - carts:`, by name.
    """
    file = root / SETTINGS
    try:
        text = file.read_text(encoding="utf-8-sig")
        tree = yaml.compose(text, yaml.SafeLoader)
    except UnicodeDecodeError:
        return [
            Finding(SETTINGS, 1, 1, "not-utf-8", "this is no text in UTF-8", "save it as UTF-8")
        ]
    except yaml.YAMLError as error:
        return [not_yaml(error, text)]
    if not isinstance(tree, yaml.MappingNode):
        hint = "for example site_name: My lessons"
        return [Finding(SETTINGS, 1, 1, "not-a-table", "this is no list of settings", hint)]
    parts = {key.value: value for key, value in tree.value if isinstance(key, yaml.ScalarNode)}
    found = [*_names(tree.value), *_theme(parts.get("theme"))]
    found += [*_plugins(parts.get("plugins"), own), *_facts(parts.get("extra"))]
    found += _ours(tree, parts, found)
    found += [_at(node, "no-such-page", *told) for node, *told in named_in_vain(root, parts)]
    return sorted(found)


def not_yaml(error: yaml.YAMLError, text: str) -> Finding:
    """What cannot be read at all, where it stands."""
    hint = "two spaces in front of what belongs to the line above; a space behind each colon"
    line, col = 1, 1
    reason = str(error)
    if isinstance(error, yaml.reader.ReaderError):
        before = text[: error.position]
        line, col = before.count("\n") + 1, len(before) - before.rfind("\n")
        reason = "a character that nobody sees stands here"
    elif isinstance(error, yaml.MarkedYAMLError):
        reason = str(error.problem)
        if mark := error.problem_mark:
            line, col = mark.line + 1, mark.column + 1
        if "mapping values" in reason:
            hint = (
                'a text with a colon in it goes in quotes: site_name: "Physics: 9b"; what belongs '
                "together begins in the same column"
            )
        if "\\t" in reason:
            reason, hint = "a tab character", "use spaces"
    return Finding(SETTINGS, line, col, "yaml", f"this is not YAML: {reason}", hint)


def _names(settings: Pairs) -> Iterator[Finding]:
    """Settings that nobody knows: the site would be built without them."""
    from mkdocs.config.defaults import MkDocsConfig

    known = [name for name, _ in MkDocsConfig()._schema]
    for key, _ in settings:
        if key.value not in known:
            hint = did_you_mean(key.value, known, "site_name, theme, plugins, extra, nav …")
            if str(key.value).replace("_", "").lower() == "siteid":
                hint = "extra: {carts: {site_id: my-school-physics}}"
            yield _at(key, "unknown-key", f"“{key.value}” is no setting of a site", hint)


def _theme(theme: yaml.Node | None) -> Iterator[Finding]:
    """A language that the theme has no words in."""
    for key, value in theme.value if isinstance(theme, yaml.MappingNode) else ():
        speaks = languages()
        if key.value == "language" and speaks and value.value not in speaks:
            hint = did_you_mean(value.value, speaks, "the short name of a language: de, fr, ms")
            told = f"the theme does not speak “{value.value}”"
            yield _at(value, "unknown-language", told, hint)


@cache
def languages() -> tuple[str, ...]:
    """Those that the theme has words in; none where it is not there."""
    return tuple(sorted(file.stem for file in (theme_templates() / _LANGUAGES).glob("*.html")))


def _plugins(plugins: yaml.Node | None, own: Mapping[str, Any]) -> Iterator[Finding]:
    """A setting that is not under its plugin, and settings of ours that nobody knows."""
    listed = plugins.value if isinstance(plugins, yaml.SequenceNode) else []
    for entry in listed:
        if not isinstance(entry, yaml.MappingNode):
            continue
        (name, settings), *others = entry.value
        for key, _ in others:
            column = name.start_mark.column + 2
            told = f"“{key.value}” stands beside its plugin “{name.value}”, not under it"
            yield _at(key, "indent", told, f"begin this line with {column} spaces")
        if name.value != "carts" or not isinstance(settings, yaml.MappingNode):
            continue
        for key, _ in settings.value:
            if key.value not in own:
                hint = did_you_mean(key.value, own, ", ".join(own))
                yield _at(key, "unknown-key", f"“{key.value}” is no setting of carts", hint)


def _ours(
    tree: yaml.MappingNode, parts: Mapping[str, yaml.Node], found: Iterable[Finding]
) -> Iterator[Finding]:
    """Names of plugins that are misspelt, and that ours is not named. `found`: what is told."""
    plugins = parts.get("plugins")
    wrong = [*misnamed(plugins)]
    for node, name in wrong:
        yield _at(node, "unknown-plugin", f"no plugin is called “{node.value}”", meant(name))
    named = {node.value for node in plugin_names(plugins)} | {name for _, name in wrong}
    elsewhere = {"INHERIT", "<<"} & parts.keys()
    if CARTS in named or elsewhere or any(one.hint == meant("plugins") for one in found):
        return
    told = f"the plugin “{CARTS}” is not listed under plugins: no lesson would be built"
    mark, hint = tree.end_mark, f"plugins: [search, {CARTS}]"
    for key, _ in tree.value:
        if key.value == "plugins":
            mark, hint = key.start_mark, f"in a line of its own below it: - {CARTS}"
    yield Finding(SETTINGS, mark.line + 1, mark.column + 1, "no-carts", told, hint)


def _facts(extra: yaml.Node | None) -> Iterator[Finding]:
    """The name that answers are stored under, and what is nearly its key."""
    for key, carts in extra.value if isinstance(extra, yaml.MappingNode) else ():
        if key.value != "carts" or not isinstance(carts, yaml.MappingNode):
            continue
        for name, value in carts.value:
            if name.value == "site_id":
                try:
                    check_site_id(str(value.value))
                except SiteError:
                    hint = "3 to 40 small letters, digits and hyphens: site_id: my-school-physics"
                    yield _at(value, "bad-name", "extra.carts.site_id is not allowed", hint)
            elif name.value not in _FACTS and nearest(name.value, _FACTS):
                hint = did_you_mean(name.value, _FACTS, "")
                yield _at(name, "unknown-key", f"“{name.value}” says nothing here", hint)


def _at(node: yaml.Node, code: str, message: str, hint: str) -> Finding:
    mark = node.start_mark
    return Finding(SETTINGS, mark.line + 1, mark.column + 1, code, message, hint)
