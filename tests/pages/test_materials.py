"""The bill of materials of a release names all that is given away; equal contents, equal bills."""

from __future__ import annotations

import json
import re
import tomllib
from typing import Any

import pytest
from cyclonedx.model.bom import Bom
from cyclonedx.output.json import JsonV1Dot6

from sim.pages.licences import npm_packages
from sim.pages.licences.materials import bill
from tests.conftest import ROOT


def written() -> dict[str, Any]:
    return dict(json.loads(JsonV1Dot6(bill(ROOT)).output_as_string()))


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    return written()


def test_every_requirement_of_the_wheel_is_named_with_the_version_of_the_lock(
    found: dict[str, Any],
) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    lock = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    named = {part["name"]: part["version"] for part in found["components"] if "version" in part}
    for line in project["dependencies"]:
        name = re.split(r"[<>=]", line)[0]
        assert f"{name}=={named[name]} " in lock


def test_every_package_of_npm_that_a_site_carries_is_named(found: dict[str, Any]) -> None:
    addresses = " ".join(part.get("purl", "") for part in found["components"])
    for name in npm_packages():
        assert f"pkg:npm/{name.replace('@', '%40')}@" in addresses


def test_nothing_stands_in_it_without_terms_but_what_names_none(found: dict[str, Any]) -> None:
    sites = [part for part in found["components"] if part["bom-ref"].startswith("site:")]
    assert len(sites) > 30
    assert all(part["licenses"] for part in sites)


def test_two_bills_are_equal_and_the_librarys_own_reader_takes_one(found: dict[str, Any]) -> None:
    assert written() == found
    read = Bom.from_json(found)  # type: ignore[attr-defined]
    assert len(read.components) == len(found["components"])
