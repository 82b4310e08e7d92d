"""What may stand in a QTI package: elements, attributes and values.

The published schemas are in no package that this project could install, so these rules are
kept by hand: of every element that is written, its attributes and what may stand in it, in order.
Read beside 1EdTech's own schema files: of items and tests the profile
`imsqti_asiv3p0_sbacv1p0_v1p0.xsd`, of the manifest `imsqtiv3p0_imscpv1p2_v1p0.xsd`, both in the
public repository oat-sa/qti-sdk. Compared type by type: AssessmentItem, -ItemRef, -Section, -Test,
ResponseDeclaration, OutcomeDeclaration, DefaultValue, Mapping, OutcomeProcessing,
ResponseCondition, ResponseIf, NumericLogic1toMany, OrderInteraction, MatchInteraction,
SimpleMatchSet, SimpleChoice, SimpleAssociableChoice, ModalFeedback with its content body, content
of a rubric, lists, breaks, Equal, StringMatch, ExtendedTextInteraction, TextEntryInteraction,
TestPart, and every type of the manifest. The others follow the model's document
and its examples.
"""

from __future__ import annotations

import re
from xml.etree.ElementTree import Element

ITEM = "http://www.imsglobal.org/xsd/imsqtiasi_v3p0"
PACKAGE = "http://www.imsglobal.org/xsd/qti/qtiv3p0/imscp_v1p1"
MATH = "{http://www.w3.org/1998/Math/MathML}math"  # has rules of its own
FLOW = ("p|div|ul|ol|blockquote|pre|table|h[1-6]|hr|em|strong|b|i|code|sub|sup|span|br|a|img"
        "|math|qti-text-entry-interaction")  # fmt: skip
STATIC = FLOW.replace("|qti-text-entry-interaction", "")  # choices, feedback: no interaction
EXPRESSION = ("qti-variable|qti-correct|qti-base-value|qti-map-response|qti-match|qti-equal"
              "|qti-string-match|qti-not|qti-is-null|qti-sum|qti-test-variables")  # fmt: skip
BLOCK = (r"p|div|ul|ol|blockquote|pre|table|h[1-6]|hr|qti-choice-interaction"
         r"|qti-order-interaction|qti-match-interaction|qti-extended-text-interaction"
         r"|qti-rubric-block")  # fmt: skip

LANG = "{http://www.w3.org/XML/1998/namespace}lang"

# element: (attributes it must have, others it may have, what stands in it in order, text allowed)
RULES: dict[str, tuple[str, str, str, bool]] = {
    "qti-assessment-item": (
        "identifier title adaptive time-dependent", LANG,
        "(qti-response-declaration )*(qti-outcome-declaration )*(qti-item-body )?"
        "(qti-response-processing )?(qti-modal-feedback )*", False),
    "qti-response-declaration": ("identifier cardinality base-type", "",
                                 "(qti-correct-response )?(qti-mapping )?", False),
    "qti-correct-response": ("", "", "(qti-value )+", False),
    "qti-value": ("", "", "", True),
    "qti-mapping": ("default-value", "", "(qti-map-entry )+", False),
    "qti-map-entry": ("map-key mapped-value", "case-sensitive", "", False),
    "qti-outcome-declaration": ("identifier cardinality base-type",
                                "normal-minimum normal-maximum external-scored",
                                "(qti-default-value )?", False),
    "qti-default-value": ("", "", "(qti-value )+", False),
    "qti-item-body": ("", "", f"(({BLOCK}) )+", False),
    "qti-choice-interaction": ("response-identifier shuffle max-choices", "",
                               "(qti-simple-choice )+", False),
    "qti-order-interaction": ("response-identifier shuffle", "", "(qti-simple-choice )+", False),
    "qti-simple-choice": ("identifier", "", f"(({STATIC}) )*", True),
    "qti-match-interaction": ("response-identifier shuffle max-associations", "",
                              "qti-simple-match-set qti-simple-match-set ", False),
    "qti-simple-match-set": ("", "", "(qti-simple-associable-choice )+", False),
    "qti-simple-associable-choice": ("identifier match-max", "", f"(({STATIC}) )*", True),
    "qti-text-entry-interaction": ("response-identifier", "expected-length", "", False),
    "qti-extended-text-interaction": ("response-identifier", "expected-lines", "", False),
    "qti-rubric-block": ("use view", "", "qti-content-body ", False),
    "qti-content-body": ("", "", f"(({STATIC}) )*", True),
    "qti-response-processing": ("", "", "(qti-response-condition )+", False),
    "qti-response-condition": ("", "", "qti-response-if (qti-response-else-if )*", False),
    "qti-response-if": ("", "", f"({EXPRESSION}) (qti-set-outcome-value )+", False),
    "qti-response-else-if": ("", "", f"({EXPRESSION}) (qti-set-outcome-value )+", False),
    "qti-set-outcome-value": ("identifier", "", f"({EXPRESSION}) ", False),
    "qti-match": ("", "", f"(({EXPRESSION}) ){{2}}", False),
    "qti-equal": ("tolerance-mode tolerance", "", f"(({EXPRESSION}) ){{2}}", False),
    "qti-string-match": ("case-sensitive", "", f"(({EXPRESSION}) ){{2}}", False),
    "qti-not": ("", "", f"({EXPRESSION}) ", False),
    "qti-is-null": ("", "", f"({EXPRESSION}) ", False),
    "qti-sum": ("", "", f"(({EXPRESSION}) )+", False),
    "qti-variable": ("identifier", "", "", False),
    "qti-correct": ("identifier", "", "", False),
    "qti-map-response": ("identifier", "", "", False),
    "qti-test-variables": ("variable-identifier", "", "", False),
    "qti-base-value": ("base-type", "", "", True),
    "qti-modal-feedback": ("outcome-identifier identifier show-hide", "", "qti-content-body ",
                           False),
    "qti-assessment-test": (
        "identifier title", "",
        "(qti-outcome-declaration )*(qti-test-part )+(qti-outcome-processing )?", False),
    "qti-test-part": ("identifier navigation-mode submission-mode", "",
                      "(qti-item-session-control )?(qti-assessment-section )+", False),
    "qti-item-session-control": ("", "max-attempts show-feedback", "", False),
    "qti-assessment-section": ("identifier title visible", "", "(qti-assessment-item-ref )*",
                               False),
    "qti-assessment-item-ref": ("identifier href", "", "", False),
    "qti-outcome-processing": ("", "", "(qti-set-outcome-value )+", False),
    "p": ("", "", f"(({FLOW}) )*", True), "div": ("", "", f"(({FLOW}) )*", True),
    "ul": ("", "", "(li )+", False), "ol": ("", "", "(li )+", False),
    "li": ("", "", f"(({FLOW}) )*", True),
    "table": ("", "", "(thead )?(tbody )+", False), "thead": ("", "", "(tr )+", False),
    "tbody": ("", "", "(tr )+", False), "tr": ("", "", "((th|td) )+", False),
    "th": ("", "colspan rowspan", f"(({FLOW}) )*", True),
    "td": ("", "colspan rowspan", f"(({FLOW}) )*", True),
    **dict.fromkeys(("em", "strong", "b", "i", "code", "sub", "sup", "span", "pre", "blockquote"),
                    ("", "", f"(({FLOW}) )*", True)),
    "a": ("href", "", f"(({FLOW}) )*", True), "img": ("src alt", "", "", False),
    "br": ("", "", "", False), "hr": ("", "", "", False),
}  # fmt: skip


COUNT, YES_NO, DOUBLE = r"\d+", "true|false", r"-?\d+(\.\d+)?(e[+-]?\d+)?"


BASE = "directedPair|float|identifier|string"


# What an attribute may say, where the schema lists it.
VALUES: dict[str, str] = {
    "cardinality": "single|multiple|ordered", "base-type": BASE, "shuffle": YES_NO,
    "adaptive": YES_NO, "time-dependent": YES_NO, "visible": YES_NO, "case-sensitive": YES_NO,
    "show-feedback": YES_NO, "max-attempts": COUNT,
    "max-choices": COUNT, "max-associations": COUNT, "match-max": COUNT, "expected-lines": COUNT,
    "expected-length": COUNT, "default-value": DOUBLE, "mapped-value": DOUBLE,
    "normal-minimum": DOUBLE, "normal-maximum": DOUBLE.removeprefix("-?"),
    "external-scored": "human|externalMachine", "show-hide": "show|hide", "view": "scorer",
    "use": "scoring", "navigation-mode": "linear|nonlinear",
    "submission-mode": "individual|simultaneous", "tolerance-mode": "exact|absolute|relative",
    "tolerance": f"{DOUBLE} {DOUBLE}",
}  # fmt: skip


NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.\-]*")


XSI = "{http://www.w3.org/2001/XMLSchema-instance}"


def local(node: Element) -> str:
    return node.tag.rpartition("}")[2]


def mistakes(node: Element) -> list[str]:
    """What of the rules an element and all in it break."""
    name = local(node)
    if node.tag == MATH:
        return []
    if name not in RULES:
        return [f"{name}: no such element"]
    must, may, inside, text = RULES[name]
    given = {a for a in node.attrib if not a.startswith(XSI)}
    found = [f"{name}: {a} is missing" for a in set(must.split()) - given]
    found += [f"{name}: {a} is not known" for a in given - {*must.split(), *may.split()}]
    found += [f"{name}: {a} says {value}" for a, value in node.attrib.items()
              if a in VALUES and not re.fullmatch(VALUES[a], value)]  # fmt: skip
    children = "".join(f"{local(child)} " for child in node)
    if not re.fullmatch(inside, children):
        found.append(f"{name}: {children} in it")
    texts = [node.text, *(child.tail for child in node)]
    if not text and any(t and t.strip() for t in texts):
        found.append(f"{name}: text in it")
    if "identifier" in node.attrib and not NAME.fullmatch(node.attrib["identifier"]):
        found.append(f"{name}: {node.attrib['identifier']} is no name")
    return found + [one for child in node for one in mistakes(child)]
