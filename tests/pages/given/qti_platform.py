"""A small reader of response processing: a platform that gives marks and feedback."""

from __future__ import annotations

from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from tests.pages.given.qti_rules import ITEM, local


class Platform:
    """Marks an answer by the rules of an item, as the model of QTI says; what it shows, the test
    says that the item stands in."""

    def __init__(self, content: bytes, test: bytes) -> None:
        (part,) = ElementTree.fromstring(test).findall(f"{{{ITEM}}}qti-test-part")
        control = part.find(f"{{{ITEM}}}qti-item-session-control")
        allowed = control is not None and control.get("show-feedback") == "true"
        self.shows = allowed and part.get("submission-mode") == "individual"
        self.root = ElementTree.fromstring(content)
        declared = self.root.find(f"{{{ITEM}}}qti-response-declaration")
        assert declared is not None
        self.declared = declared
        self.base = declared.get("base-type")
        self.cardinality = declared.get("cardinality")

    def typed(self, text: str) -> Any:
        return float(text) if self.base == "float" else text

    @property
    def correct(self) -> Any:
        values = [self.typed(v.text or "") for v in self.declared.findall(
            f"{{{ITEM}}}qti-correct-response/{{{ITEM}}}qti-value")]  # fmt: skip
        return values[0] if self.cardinality == "single" else values

    def answer(self, response: Any) -> tuple[float, list[str]]:
        """The score and the feedback shown."""
        self.values: dict[str, Any] = {"RESPONSE": response, "SCORE": 0.0}
        for condition in self.root.iter(f"{{{ITEM}}}qti-response-condition"):
            for case in condition:
                test, *done = case
                if self.value(test):
                    for one in done:
                        self.values[str(one.get("identifier"))] = self.value(one[0])
                    break
        shown = []
        for text in self.root.iter(f"{{{ITEM}}}qti-modal-feedback"):
            value = self.values.get(str(text.get("outcome-identifier")))
            names = value if isinstance(value, list) else [value]
            if self.shows and text.get("identifier") in names:
                shown.append("".join(text.itertext()))
        return float(self.values["SCORE"]), shown

    def value(self, node: Element) -> Any:
        kind, parts = local(node), list(node)
        if kind == "qti-variable":
            return self.values.get(str(node.get("identifier")))
        if kind == "qti-correct":
            return self.correct
        if kind == "qti-base-value":
            text = node.text or ""
            return float(text) if node.get("base-type") in ("float", "integer") else text
        if kind == "qti-not":
            return not self.value(parts[0])
        if kind == "qti-is-null":
            return self.value(parts[0]) in (None, "", [])
        if kind == "qti-map-response":
            return self.mapped()
        one, other = map(self.value, parts)
        if one in (None, "", []):
            return False
        if kind == "qti-match":
            return sorted(one) == sorted(other) if self.cardinality == "multiple" else one == other
        if kind == "qti-string-match":
            assert node.get("case-sensitive") == "false"
            return one.lower() == other.lower()
        assert kind == "qti-equal", kind
        below, above = map(float, str(node.get("tolerance")).split())
        return isinstance(one, float) and other - below <= one <= other + above

    def mapped(self) -> float:
        mapping = self.declared.find(f"{{{ITEM}}}qti-mapping")
        assert mapping is not None
        for entry in mapping:
            assert entry.get("case-sensitive") == "false"
            if str(entry.get("map-key")).lower() == str(self.values["RESPONSE"]).lower():
                return float(str(entry.get("mapped-value")))
        return float(str(mapping.get("default-value")))
