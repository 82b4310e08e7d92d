"""From a `hard-cases` block to the `<carts-hard>` element: it reads and prints without a script."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import yaml

from sim.pages.drawing import draw
from sim.pages.hard_cases import GROUPS
from sim.pages.hard_cases.block import TITLE, HardCasesBlock
from sim.pages.hard_cases.measured import measured, request
from sim.pages.hard_cases.row import HardCase
from sim.pages.language import told, told_if_ours
from sim.pages.templates import element


def render_hard_cases(block: HardCasesBlock) -> str:
    """HTML of the element."""
    known = measured()
    facts = {case.name: _facts(case) for _, cases in GROUPS for case in cases}
    groups = [
        {"name": told(name), "rows": [_row(case, known[case.name]) for case in cases]}
        for name, cases in GROUPS
    ]
    title = told_if_ours(block.title, TITLE)
    inside = draw("hard", {"id": block.id, "title": title, "groups": groups})
    return element("hard", block.id, inside, facts)


def _facts(case: HardCase) -> dict[str, Any]:
    """What the page needs to run a case: the request but for its kind."""
    asked = {key: value for key, value in request(case).items() if key != "kind"}
    packages = [] if case.has_formulas else ["numpy", "scipy"]
    within = [one.tolerance for one in case.expected]
    return asked | {"within": within, "packages": packages}


def _row(case: HardCase, known: Mapping[str, Any]) -> dict[str, Any]:
    step = known["stepped"][0]["step"]
    return {
        "name": case.name,
        "sentence": case.sentence,
        "why": case.why,
        "wanted": request(case)["expected"],
        "known": known,
        "yaml": yaml_text(case.plain),
        "commands": [
            f"carts run {case.name}.yml",
            f"carts run {case.name}.yml --method euler --step {step!r}",
        ],
    }


def yaml_text(plain: Mapping[str, Any]) -> str:
    """The scene as a file that `carts run` reads: one line per cart and effect."""
    return str(
        yaml.dump(
            _bare(plain), Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=1000,
            default_flow_style=None,
        )
    )  # fmt: skip


def _bare(value: Any) -> Any:
    """Without empty lists; numbers in text stay text, so that they keep their digits."""
    if isinstance(value, Mapping):
        return {key: _bare(item) for key, item in value.items() if item != []}
    return [_bare(item) for item in value] if isinstance(value, list | tuple) else value


class _Dumper(yaml.SafeDumper):
    """No anchors: a scene file may not have them."""

    def ignore_aliases(self, data: Any) -> bool:
        """Always."""
        return True
