"""The documentation names everything there is, and what it shows works."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sim.cli import COMMANDS
from sim.cli.measured.fit import command as fit_command
from sim.dynamics.loop.run import run
from sim.dynamics.report.document import report
from sim.measured.model.contact import LAWS as LAWS_FITTED
from sim.pages.measured.block import KEYS as MEASURED_KEYS
from sim.pages.text.plain_lines import without_code
from sim.pages.text.yaml.source import load
from sim.scene import fields, read_fence
from sim.scene.effects import EffectKind, kinds
from sim.scene.fence.map import MAP_KEYS
from sim.scene.fence.predict import KINDS as PREDICTIONS
from sim.scene.fence.presentation import FENCE_KEYS, PACKAGES, SHOWS, TOOLS, VIEWS
from sim.scene.laws import laws
from sim.scene.read import SCENE_KEYS
from tests import registry

ROOT = Path(__file__).parents[1]
REFERENCE = (ROOT / "docs" / "reference" / "scene.md").read_text(encoding="utf-8")
TEXTS = sorted(
    [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md"), *ROOT.glob("sim/effects/*/page.md")]
)

CART_KEYS = [field.key for field in fields.CART]
OTHER_KEYS = [*SCENE_KEYS, *FENCE_KEYS, "file", *laws(), *PREDICTIONS]
VALUES = [
    (key, value)
    for key, values in {"show": SHOWS, "with": (*VIEWS, *TOOLS), "packages": PACKAGES}.items()
    for value in values
]


def test_the_readme_tells_every_folder_of_the_package() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    rooms = {file.parent.name for file in ROOT.glob("sim/*/__init__.py")} | {"view", "web"}
    assert rooms == set(re.findall(r"^\| \[`sim/(\w+)`\]", readme, re.M))


def test_every_room_of_the_generator_is_told() -> None:
    pages = ROOT / "sim" / "pages"
    text = (ROOT / "docs" / "developers" / "generator.md").read_text(encoding="utf-8")
    told = {name for row in re.findall(r"^\| (`.*?) \|", text, re.M) for name in row.split(", ")}
    assert told == {f"`{init.parent.name}`" for init in pages.glob("*/__init__.py")}


@pytest.mark.parametrize("key", [*CART_KEYS, *OTHER_KEYS])
def test_the_reference_has_a_row_for_every_key(key: str) -> None:
    """Its first cell has the key in code: as a word, `until` stands in any English sentence."""
    assert re.search(rf"^\| [^|]*`{re.escape(key)}`[^|]*\|", REFERENCE, re.M), key


@pytest.mark.parametrize(("key", "value"), VALUES)
def test_the_reference_names_every_value_in_the_row_of_its_key(key: str, value: str) -> None:
    (row,) = re.findall(rf"^\| `{key}` \|.*$", REFERENCE, re.M)
    assert re.search(rf"[`[]{re.escape(value)}[`\]]", row), value


@pytest.mark.parametrize("key", [*MAP_KEYS, "file", "v.A", "F.A-B", "warmed"])
def test_the_reference_of_maps_names_every_key(key: str) -> None:
    text = (ROOT / "docs" / "reference" / "map.md").read_text(encoding="utf-8")
    assert re.search(rf"^\| `{re.escape(key)}` \|", text, re.M), key


@pytest.mark.parametrize("key", [*MEASURED_KEYS, "length", "time", "force", *LAWS_FITTED])
def test_the_reference_of_readings_names_every_key(key: str) -> None:
    text = (ROOT / "docs" / "reference" / "measured.md").read_text(encoding="utf-8")
    assert f"`{key}`" in text, key


def test_the_reference_of_readings_names_every_option() -> None:
    text = (ROOT / "docs" / "reference" / "measured.md").read_text(encoding="utf-8")
    for parameter in fit_command.params:
        for option in parameter.opts:
            assert f"`{option}" in text or not option.startswith("--"), option


@pytest.mark.parametrize("field", fields.CART, ids=lambda field: field.key)
def test_the_reference_names_every_unit_of_a_cart(field: fields.Field) -> None:
    (line,) = re.findall(rf"^\| `{field.key}` .*$", REFERENCE, re.M)
    for unit in field.dimension.units:
        assert unit in line, (field.key, unit)
    if field.default is not None:
        assert field.default in line


EFFECT_FIELDS = [(kind, field) for kind in kinds().values() for field in kind.fields]


@pytest.mark.parametrize(("kind", "field"), EFFECT_FIELDS, ids=lambda one: getattr(one, "key", ""))
def test_the_reference_names_every_key_of_an_effect(kind: EffectKind, field: fields.Field) -> None:
    (line,) = re.findall(rf"^\| `{kind.name}\.{field.key}` .*$", REFERENCE, re.M)
    for unit in field.dimension.units if field.dimension.si else ():
        assert unit in line, (kind.name, field.key, unit)
    if field.default is None and not field.optional:
        assert "| required |" in line
    elif field.default is not None:
        assert f"| {field.default} |" in line
    page = (ROOT / "sim/effects" / kind.name / "page.md").read_text(encoding="utf-8")
    assert re.search(rf"^\| `{field.key}` \|", page, re.M), (kind.name, field.key)


@pytest.mark.parametrize("kind", kinds().values(), ids=lambda kind: kind.name)
def test_the_reference_names_the_bodies_of_an_effect(kind: EffectKind) -> None:
    for key in (kind.needs or "carts", *(["by"] if kind.by else [])):
        assert re.search(rf"^\| `{kind.name}\.{key}` \|", REFERENCE, re.M), (kind.name, key)


def test_the_reference_names_every_key_of_a_report() -> None:
    document = report(run(registry.scene("incline-bounce")))
    for key, value in document.items():
        (line,) = re.findall(rf"^\| `{key}` \|.*$", REFERENCE, re.M)
        for inner in value if isinstance(value, dict) else ():
            assert f"`{inner}`" in line, (key, inner)


@pytest.mark.parametrize("command", sorted(COMMANDS))
def test_every_command_is_documented(command: str) -> None:
    assert any(f"carts {command}" in text.read_text(encoding="utf-8") for text in TEXTS)


def scene_blocks() -> list[tuple[str, str]]:
    found = []
    for text in TEXTS:
        shown = re.sub(r"^````.*?^````$", "", text.read_text(encoding="utf-8"), flags=re.M | re.S)
        for block in re.findall(r"^```scene\n(.*?)^```", shown, re.M | re.S):
            found.append((text.relative_to(ROOT).as_posix(), block))
    return found


@pytest.mark.parametrize(("where", "block"), scene_blocks())
def test_every_scene_in_the_texts_is_a_good_one(where: str, block: str) -> None:
    plain = dict(load(block).plain)
    if name := plain.pop("file", None):
        plain |= registry.plain(str(name).removesuffix(".yml"))
    read_fence(plain)


@pytest.mark.parametrize("path", TEXTS, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_no_text_links_to_a_file_that_is_not_there(path: Path) -> None:
    text = without_code(path.read_text(encoding="utf-8"))
    for target in re.findall(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)", text):
        if "worksheets/" in target:  # the site puts docs/ and worksheets/ into one folder
            assert (ROOT / target[target.index("worksheets/") :]).exists(), target
            continue
        home = ROOT / "docs/physics/effects" if path.name == "page.md" else path.parent
        file = (home / target).resolve()
        if file.parent == ROOT / "docs/physics/effects" and file.stem in kinds():
            file = ROOT / "sim/effects" / file.stem / "page.md"  # it joins the docs there
        assert file.exists(), (path.name, target)
