"""One question as a QTI item: what is asked, what may be answered, how it is marked."""

from __future__ import annotations

from sim.pages.classroom.portable import Portable
from sim.pages.classroom.qti.marking import processing
from sim.pages.classroom.qti.xhtml import blocks, flow, xml_attribute, xml_text

NAMESPACE = "http://www.imsglobal.org/xsd/imsqtiasi_v3p0"
SCHEMA = "https://purl.imsglobal.org/spec/qti/v3p0/schema/xsd/imsqti_asiv3p0_v1p0.xsd"
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
HEAD = (
    f'xmlns="{NAMESPACE}" xmlns:xsi="{INSTANCE}" xsi:schemaLocation="{NAMESPACE} {SCHEMA}"'
)  # fmt: skip
RESPONSES = {
    "choice": ("single", "identifier"), "choices": ("multiple", "identifier"),
    "number": ("single", "float"), "short": ("single", "string"),
    "essay": ("single", "string"), "pairs": ("multiple", "directedPair"),
    "order": ("ordered", "identifier"),
}  # fmt: skip


def qti_item(q: Portable, language: str) -> str:
    """The file of an item; a screen reader speaks it in `language`, where that is known."""
    spoken = f' xml:lang="{language}"' if language else ""
    made = processing(q)
    return "\n".join([
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<qti-assessment-item {HEAD} identifier={xml_attribute(q.id)} '
        f'title={xml_attribute(q.id)}{spoken} adaptive="false" '
        'time-dependent="false">',
        _response(q),
        *_outcomes(q, made.feedback),
        "<qti-item-body>",
        blocks(q.ask),
        *_interaction(q),
        *_rubric(q),
        "</qti-item-body>",
        made.rules,
        *made.shown,
        "</qti-assessment-item>",
        "",
    ])  # fmt: skip


def kind_of(q: Portable) -> str:
    """The shape; lines in an order have an interaction of their own."""
    return "order" if q.order else q.shape


def _response(q: Portable) -> str:
    cardinality, base = RESPONSES[kind_of(q)]
    right = "".join(f"<qti-value>{xml_text(value)}</qti-value>" for value in _right(q))
    correct = f"<qti-correct-response>{right}</qti-correct-response>" if right else ""
    mapping = _mapping(q) if q.shape == "short" else ""
    return (
        f'<qti-response-declaration identifier="RESPONSE" cardinality="{cardinality}" '
        f'base-type="{base}">{correct}{mapping}</qti-response-declaration>'
    )


def _right(q: Portable) -> list[str]:
    if q.order:
        return [f"L{k}" for k in range(1, len(q.order) + 1)]
    if q.shape in ("choice", "choices"):
        return [f"C{k}" for k, (_, percent, _) in enumerate(q.answers, 1) if percent > 0]
    if q.shape == "number":
        return [repr(q.number[0])]
    if q.shape == "short":
        return [q.answers[0][0]]
    return [f"L{k} R{k}" for k in range(1, len(q.pairs) + 1)]


def _mapping(q: Portable) -> str:
    entries = "".join(
        f'<qti-map-entry map-key={xml_attribute(text)} mapped-value="{q.marks}" '
        'case-sensitive="false"/>'
        for text, percent, _ in q.answers
        if percent == 100
    )
    return f'<qti-mapping default-value="0">{entries}</qti-mapping>'


def _outcomes(q: Portable, feedback: str) -> list[str]:
    by_hand = ' external-scored="human"' if q.shape == "essay" else ""
    found = [
        f'<qti-outcome-declaration identifier="SCORE" cardinality="single" base-type="float" '
        f'normal-minimum="0" normal-maximum="{q.marks}"{by_hand}>'
        "<qti-default-value><qti-value>0</qti-value></qti-default-value></qti-outcome-declaration>"
    ]
    if feedback:
        found.append(
            f'<qti-outcome-declaration identifier="FEEDBACK" cardinality="{feedback}" '
            'base-type="identifier"/>'
        )
    if q.explain:
        found.append(
            '<qti-outcome-declaration identifier="EXPLAIN" cardinality="single" '
            'base-type="identifier"/>'
        )
    return found


def _interaction(q: Portable) -> list[str]:
    response = 'response-identifier="RESPONSE"'
    if q.order:
        lines = [_choice(f"L{k}", text) for k, text in enumerate(q.order, 1)]
        return [f'<qti-order-interaction {response} shuffle="true">', *lines,
                "</qti-order-interaction>"]  # fmt: skip
    if q.shape in ("choice", "choices"):
        most = 1 if q.shape == "choice" else 0
        options = [_choice(f"C{k}", text) for k, (text, _, _) in enumerate(q.answers, 1)]
        return [f'<qti-choice-interaction {response} shuffle="true" max-choices="{most}">',
                *options, "</qti-choice-interaction>"]  # fmt: skip
    if q.shape == "essay":
        return [f'<qti-extended-text-interaction {response} expected-lines="6"/>']
    if q.shape == "pairs":
        left = [_part(f"L{k}", text) for k, (text, _) in enumerate(q.pairs, 1)]
        right = [*(text for _, text in q.pairs), *q.others]
        return [
            f'<qti-match-interaction {response} shuffle="true" max-associations="{len(left)}">',
            "<qti-simple-match-set>", *left, "</qti-simple-match-set>",
            "<qti-simple-match-set>", *(_part(f"R{k}", text) for k, text in enumerate(right, 1)),
            "</qti-simple-match-set>", "</qti-match-interaction>",
        ]  # fmt: skip
    return [f'<p><qti-text-entry-interaction {response} expected-length="15"/></p>']


def _choice(name: str, html: str) -> str:
    return f'<qti-simple-choice identifier="{name}">{flow(html)}</qti-simple-choice>'


def _part(name: str, html: str) -> str:
    return (
        f'<qti-simple-associable-choice identifier="{name}" match-max="1">{flow(html)}'
        "</qti-simple-associable-choice>"
    )


def _rubric(q: Portable) -> list[str]:
    if not q.rubric:
        return []
    lines = "".join(f"<p>{marks}: {xml_text(text)}</p>" for marks, text in q.rubric.items())
    return [
        '<qti-rubric-block use="scoring" view="scorer">'
        f"<qti-content-body>{lines}</qti-content-body></qti-rubric-block>"
    ]
