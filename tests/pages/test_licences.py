"""Whatever ships in a site is named in third-party-licenses.txt, with its terms in full."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
import yaml

from sim.pages import licences
from sim.pages.licences import licence_file, notices

ROOT = Path(__file__).parents[2]
MODULES = ROOT / "node_modules"


def text(**what: object) -> str:
    return licence_file(notices(MODULES, **what))  # type: ignore[arg-type]


def test_every_npm_package_that_ships_has_a_notice() -> None:
    packages = json.loads((ROOT / "package.json").read_text(encoding="utf-8"))["dependencies"]
    rows = (Path(licences.__file__).parent / "notices.yml").read_text(encoding="utf-8")
    for name in packages:
        assert f"npm:{name}" in rows, f"{name} ships without a notice"


def test_every_notice_with_a_version_names_the_one_that_ships() -> None:
    version = json.loads((ROOT / "package.json").read_text(encoding="utf-8"))["dependencies"]
    for notice in notices(MODULES, scenes=True):
        if notice.name in ("KaTeX", "Pyodide"):
            assert notice.version == version[notice.name.lower()]


def test_every_licence_that_is_named_stands_there_in_full() -> None:
    everything = text(scenes=True, packages=("numpy", "scipy"))
    for phrase in (
        "Mozilla Public License Version 2.0",
        "PYTHON SOFTWARE FOUNDATION LICENSE VERSION 2",
        "SIL OPEN FONT LICENSE",
        "Apache License",
        "LLVM Exceptions to the Apache 2.0 License",
        "Permission is hereby granted, free of charge",
        "Redistributions in binary form must reproduce",
        "Khan Academy",
    ):
        assert re.search(phrase, everything, re.IGNORECASE), phrase


def test_a_notice_without_text_is_in_the_public_domain() -> None:
    for notice in notices(MODULES, scenes=True, packages=("numpy", "scipy")):
        assert notice.texts or notice.licence == "public domain", notice.name


def test_pyodide_says_where_its_source_is() -> None:
    version = json.loads((ROOT / "package.json").read_text(encoding="utf-8"))["dependencies"]
    assert f"https://github.com/pyodide/pyodide/tree/{version['pyodide']}" in text(scenes=True)


def test_a_site_without_scenes_does_not_list_the_runtime() -> None:
    assert "Pyodide" not in text(scenes=False)
    assert "NumPy" not in text(scenes=True)
    assert "NumPy" in text(scenes=True, packages=("numpy",))


@pytest.mark.parametrize("work", ["clipboard", "escape-html", "focus-visible", "rxjs", "tslib"])
def test_the_libraries_inside_the_themes_script_are_listed(work: str) -> None:
    assert work.lower() in text(scenes=False).lower()


def test_the_theme_holds_no_library_that_is_not_listed() -> None:
    import material

    maps = Path(material.__file__).parent.glob("templates/assets/javascripts/**/*.map")
    sources = [source for path in maps for source in json.loads(path.read_text("utf-8"))["sources"]]
    found = {match[1] for s in sources if (match := re.search(r"node_modules/([^/]+)/", s))}
    listed = text(scenes=False).lower()
    assert {name for name in found if name.lower().removesuffix(".js") not in listed} == set()


def test_the_notices_have_no_unknown_keys() -> None:
    rows = yaml.safe_load((Path(licences.__file__).parent / "notices.yml").read_text("utf-8"))
    keys = {"name", "version", "in", "licence", "text", "from", "copyright", "source", "note"}
    assert all(set(row) <= keys for row in rows)


def test_our_own_licences_are_complete() -> None:
    code = (ROOT / "LICENSE").read_text(encoding="utf-8")
    assert "Apache License" in code
    assert "END OF TERMS AND CONDITIONS" in code
    lessons = (ROOT / "LICENSE-content").read_text(encoding="utf-8")
    assert lessons.startswith("Attribution 4.0 International")
    assert [f"Section {n} --" in lessons for n in range(1, 9)] == [True] * 8


def test_what_draws_when_a_site_is_built_ships_with_its_licences() -> None:
    """linkedom is one file that holds what it stands on: draw.js is in the wheel, in no site."""
    text = (ROOT / "sim/web/dist/draw-licences.txt").read_text(encoding="utf-8")
    packages = json.loads((ROOT / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    wanted = ["linkedom"]
    for name in wanted:
        package = packages[f"node_modules/{name}"]
        assert f"{name} {package['version']} ({package['license']})" in text
        wanted += [one for one in package.get("dependencies", ()) if one not in wanted]
    assert len(wanted) > 10
    assert "linkedom" not in (ROOT / "sim/web/dist/carts.js").read_text(encoding="utf-8")
