"""The package: a manifest, a test of one section, and the items. Equal banks give equal zips."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Iterable, Mapping, Sequence

from sim.pages.classroom.pictures import Pictures, no_pictures
from sim.pages.classroom.portable import Portable
from sim.pages.classroom.qti.item import HEAD, INSTANCE, NAMESPACE, SCHEMA, qti_item
from sim.pages.classroom.qti.mathml import Formulas, no_formulas, with_mathml
from sim.pages.classroom.qti.pictures import Packed
from sim.pages.classroom.qti.xhtml import xml_attribute, xml_text

PACKAGE = "http://www.imsglobal.org/xsd/qti/qtiv3p0/imscp_v1p1"
PACKAGE_SCHEMA = "https://purl.imsglobal.org/spec/qti/v3p0/schema/xsd/imsqtiv3p0_imscpv1p2_v1p0.xsd"
LOM = "http://ltsc.ieee.org/xsd/LOM"
LOM_SCHEMA = "https://purl.imsglobal.org/spec/md/v1p3/schema/xsd/imsmd_loose_v1p3p2.xsd"
TEST = "test.xml"
ITEMS = "items"
DATE = (1980, 1, 1, 0, 0, 0)


def qti_package(
    title: str,
    questions: Iterable[Portable],
    pictures: Pictures = no_pictures,
    formulas: Formulas = no_formulas,
    *,
    name: str,
    language: str = "",
    feedback: bool = True,
) -> bytes:
    """The zip; `title` names the test for people, `name` for programs; `language`: as in
    `xml:lang`, where it is known; `feedback`: shown after each answer, as no exam does."""
    items = list(questions)
    packed = Packed(pictures)
    made = {q.id: packed.item(with_mathml(qti_item(q, language), formulas)) for q in items}
    shown = {name: [f"{ITEMS}/{path}" for path in paths] for name, (_, paths) in made.items()}
    files = {
        "imsmanifest.xml": _manifest(title, _identifier(name), language, items, shown).encode(),
        TEST: _test(title, _identifier(name), items, feedback).encode(),
        **{_path(q): made[q.id][0].encode() for q in items},
        **{f"{ITEMS}/{path}": content for path, content in packed.files.items()},
    }
    zipped = io.BytesIO()
    with zipfile.ZipFile(zipped, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path, DATE)
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED)
    return zipped.getvalue()


def _path(q: Portable) -> str:
    return f"{ITEMS}/{q.id}.xml"


def _identifier(name: str) -> str:
    """A name for XML out of that of a file; letters that it may not have stand there as numbers."""
    plain = re.sub(r"[^\x00-\x7f]", lambda one: f"-{ord(one[0]):x}-", name.lower())
    return f"carts-{re.sub('[^a-z0-9]+', '-', plain).strip('-') or 'bank'}"


def _test(title: str, identifier: str, items: Sequence[Portable], feedback: bool) -> str:
    # Feedback is shown of what is handed in one by one, and only where a test says so.
    mode = "individual" if feedback else "simultaneous"
    shown = ['<qti-item-session-control max-attempts="1" show-feedback="true"/>'] * feedback
    refs = [
        f'<qti-assessment-item-ref identifier={xml_attribute(q.id)} '
        f"href={xml_attribute(_path(q))}/>"
        for q in items
    ]  # fmt: skip
    return "\n".join([
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<qti-assessment-test {HEAD} identifier="{identifier}" '
        f"title={xml_attribute(title)}>",
        '<qti-outcome-declaration identifier="SCORE" cardinality="single" base-type="float"/>',
        '<qti-test-part identifier="part-1" navigation-mode="nonlinear" '
        f'submission-mode="{mode}">',
        *shown,
        f'<qti-assessment-section identifier="section-1" title={xml_attribute(title)} '
        'visible="true">',
        *refs,
        "</qti-assessment-section>",
        "</qti-test-part>",
        "<qti-outcome-processing>",
        '<qti-set-outcome-value identifier="SCORE"><qti-sum>'
        '<qti-test-variables variable-identifier="SCORE"/></qti-sum></qti-set-outcome-value>',
        "</qti-outcome-processing>",
        "</qti-assessment-test>",
        "",
    ])  # fmt: skip


def _manifest(
    title: str,
    identifier: str,
    language: str,
    items: Sequence[Portable],
    shown: Mapping[str, Sequence[str]],
) -> str:
    return "\n".join([
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<manifest xmlns="{PACKAGE}" xmlns:imsmd="{LOM}" xmlns:xsi="{INSTANCE}" '
        f'xsi:schemaLocation="{PACKAGE} {PACKAGE_SCHEMA} {LOM} {LOM_SCHEMA} {NAMESPACE} {SCHEMA}" '
        f'identifier="manifest-{identifier}">',
        "<metadata>",
        "<schema>QTI Package</schema>",
        "<schemaversion>3.0.0</schemaversion>",
        _lom(f"<imsmd:title><imsmd:string>{xml_text(title)}</imsmd:string></imsmd:title>"
             + (f"<imsmd:language>{language}</imsmd:language>" if language else "")),
        "</metadata>",
        "<organizations/>",
        "<resources>",
        f'<resource identifier="test" type="imsqti_test_xmlv3p0" href="{TEST}">',
        f'<file href="{TEST}"/>',
        *(f"<dependency identifierref={xml_attribute(f'item-{q.id}')}/>" for q in items),
        "</resource>",
        *(line for q in items for line in _resource(q, shown[q.id])),
        "</resources>",
        "</manifest>",
        "",
    ])  # fmt: skip


def _resource(q: Portable, shown: Sequence[str]) -> list[str]:
    words = "".join(
        f"<imsmd:keyword><imsmd:string>{xml_text(topic)}</imsmd:string></imsmd:keyword>"
        for topic in q.topics
    )
    about = [f"<metadata>{_lom(words)}</metadata>"] if words else []
    path = xml_attribute(_path(q))
    return [
        f'<resource identifier={xml_attribute(f"item-{q.id}")} type="imsqti_item_xmlv3p0" '
        f"href={path}>",
        *about,
        f"<file href={path}/>",
        *(f"<file href={xml_attribute(picture)}/>" for picture in shown),
        "</resource>",
    ]


def _lom(inside: str) -> str:
    return f"<imsmd:lom><imsmd:general>{inside}</imsmd:general></imsmd:lom>"
