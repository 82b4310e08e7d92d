"""A small site of three lessons, and the catalogue of one of them."""

from __future__ import annotations

from pathlib import Path

from sim.pages.translate.catalogues import source_of
from sim.pages.translate.po_file import DRAFT, updated
from sim.pages.translate.put_in import bank_units, lesson_units
from tests.pages.given.small_site import MakeSite, lesson

TEXT = lesson().replace(
    "Words to search: galumphing.",
    "# A lesson\n\nWords to search: galumphing.\n\nA [friend](second.md), a [stranger](third.md).",
)
SAID = {
    "A lesson": "Satu pelajaran",
    "Words to search: galumphing.": "Kata untuk dicari: brillig.",
    "A [friend](second.md), a [stranger](third.md).": "[Kawan](second.md), [orang](third.md).",
}


def write_words(
    root: Path, name: str, said: dict[str, str], *, language: str = "ms", draft: bool = True
) -> Path:
    """The catalogue of `worksheets/NAME` as `carts words` writes it, with some of it translated."""
    folder = root / "worksheets"
    path = folder / name
    text = path.read_text(encoding="utf-8")
    units = bank_units(text) if path.suffix == ".yml" else lesson_units(text)
    target = source_of(path, folder, language).catalogue
    made = updated(target, "", units, language, name)
    for one, ours in said.items():
        assert f'msgid "{one}"\nmsgstr ""\n' in made, one
        made = made.replace(f'msgid "{one}"\nmsgstr ""', f'msgid "{one}"\nmsgstr "{ours}"')
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(made if draft else made.replace(DRAFT, ""), encoding="utf-8")
    return target


def three(make_site: MakeSite, first: str = TEXT) -> Path:
    second, third = (
        lesson(identity=name).replace("A lesson", f"Lesson {name}") for name in ("two", "three")
    )
    return make_site(first=first, second=second, third=third)
