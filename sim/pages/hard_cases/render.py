"""From a `hard-cases` block to the `<carts-hard>` element: it reads and prints without a script."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from typing import Any

import yaml
from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from sim.pages.hard_cases import GROUPS
from sim.pages.hard_cases.block import HardCasesBlock
from sim.pages.hard_cases.measured import measured, request
from sim.pages.hard_cases.row import HardCase
from sim.pages.hard_cases.words import METHODS, exact_cell, expected_lines, stepped_cell
from sim.pages.widget.numbers import short

UNSAFE = {ord(c): f"\\u{ord(c):04x}" for c in "<>&\u2028\u2029"}


def render_hard_cases(block: HardCasesBlock) -> str:
    """HTML of the element."""
    known = measured()
    facts = {case.name: _facts(case) for _, cases in GROUPS for case in cases}
    view = {
        "id": block.id,
        "title": block.title,
        "methods": list(METHODS.values()),
        "groups": [
            (name, [_row(case, known[case.name]) for case in cases]) for name, cases in GROUPS
        ],
        "count": len(facts),
        "baked": _script_json(facts),
    }
    return str(_templates().get_template("hard-cases.html.j2").render(view))


def _facts(case: HardCase) -> dict[str, Any]:
    """What the page needs to run a case: the request but for its kind."""
    asked = {key: value for key, value in request(case).items() if key != "kind"}
    packages = [] if _plain_python(case) else ["numpy", "scipy"]
    within = [one.tolerance for one in case.expected]
    return asked | {"within": within, "packages": packages}


def _plain_python(case: HardCase) -> bool:
    return bool(case.plain.get("contact", {}).get("law") != "hertz")


def _row(case: HardCase, known: Mapping[str, Any]) -> dict[str, Any]:
    wanted = request(case)["expected"]
    step = known["stepped"][0]["step"]
    return {
        "name": case.name,
        "sentence": case.sentence,
        "why": case.why,
        "expected": expected_lines(wanted),
        "exact": exact_cell(wanted, known["exact"]),
        "stepped": [(*stepped_cell(wanted, one), one["verdict"]) for one in known["stepped"]],
        "step": short(step, 3),
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


def _script_json(value: Mapping[str, Any]) -> Markup:
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return Markup(text.translate(UNSAFE))


@cache
def _templates() -> Environment:
    return Environment(
        loader=PackageLoader("sim.pages.hard_cases"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
