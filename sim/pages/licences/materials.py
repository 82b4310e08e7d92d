"""The bill of materials of a release (CycloneDX 1.6, JSON): all works of others in it.

Two lists, from what the release itself is made by: what a site carries (`notices.yml`), and what
pip installs beside the wheel (the requirements of the installed package, all the way down).

    python -m sim.pages.licences.materials OUT.json
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path
from uuid import NAMESPACE_URL, uuid5

from cyclonedx.contrib.license.factories import LicenseFactory
from cyclonedx.model import ExternalReference, ExternalReferenceType, XsUri
from cyclonedx.model.bom import Bom
from cyclonedx.model.component import Component, ComponentType
from cyclonedx.output.json import JsonV1Dot6
from packageurl import PackageURL
from packaging.requirements import Requirement

from sim.pages.licences import all_notices
from sim.pages.site.carried import node_modules

PROJECT = "newtons-carts"
LONGEST_NAME = 60  # letters; what is longer is no name of a licence
_ROOT = Path(__file__).parents[3]


def bill(root: Path) -> Bom:
    """The bill of what `root`, a checkout of the project, gives away. Equal for equal contents."""
    parts = [*_of_sites(root), *_of_wheel(PROJECT)]
    own = Component(
        name=PROJECT,
        version=metadata.version(PROJECT),
        type=ComponentType.APPLICATION,
        licenses=[LicenseFactory().make_from_string("Apache-2.0")],
        bom_ref=PROJECT,
    )
    made = Bom(components=parts)
    made.metadata.component = own
    made.register_dependency(own, parts)
    names = " ".join(sorted(f"{part.name} {part.version}" for part in parts))
    made.serial_number = uuid5(NAMESPACE_URL, f"{PROJECT} {own.version} {names}")
    made.metadata.timestamp = None  # type: ignore[assignment]  # the release has one
    return made


def _of_sites(root: Path) -> Iterator[Component]:
    """What sites carry: with scenes, numpy, scipy, classroom, readings and teacher mode."""
    for work in all_notices(node_modules(root)):
        yield Component(
            name=work.name,
            version=work.version or None,
            type=ComponentType.LIBRARY,
            licenses=[_licence(work.licence)],
            purl=_purl(work.package, work.version),
            description=work.note or None,
            external_references=[
                ExternalReference(type=ExternalReferenceType.WEBSITE, url=XsUri(work.source))
            ],
            bom_ref=f"site:{work.name}",
        )


def _of_wheel(project: str) -> Iterator[Component]:
    """What pip installs with the wheel, as it is installed here: the versions of the lock."""
    seen = {project}
    waiting = [project]
    while waiting:
        for line in metadata.requires(waiting.pop()) or []:
            wanted = Requirement(line)
            name = wanted.name.lower().replace("_", "-")
            if name in seen or (wanted.marker and not wanted.marker.evaluate({"extra": ""})):
                continue
            seen.add(name)
            waiting.append(name)
            short = _stated(name)
            yield Component(
                name=name,
                version=metadata.version(name),
                type=ComponentType.LIBRARY,
                licenses=[_licence(short)] if short else [],
                purl=PackageURL("pypi", None, name, metadata.version(name)),
                bom_ref=f"pip:{name}",
            )


def _stated(package: str) -> str:
    """The licence that an installed package names; "" where it gives a text in place of a name."""
    about = metadata.metadata(package).json
    licence = str(about.get("license_expression") or about.get("license") or "")
    return licence if len(licence) < LONGEST_NAME else ""


def _licence(text: str):  # type: ignore[no-untyped-def]  # one of the library's three classes
    return LicenseFactory().make_from_string(text)


def _purl(package: str, version: str) -> PackageURL | None:
    """`npm:@scope/name`, or the name of a package of pip; none of neither."""
    if not package or package[0].isdigit():
        return None
    if package.startswith("npm:"):
        scope, _, name = package.removeprefix("npm:").rpartition("/")
        return PackageURL("npm", scope or None, name, version)
    return PackageURL("pypi", None, package, version)


if __name__ == "__main__":
    text = JsonV1Dot6(bill(_ROOT)).output_as_string(indent=1)
    Path(sys.argv[1]).write_text(text + "\n", encoding="utf-8")
