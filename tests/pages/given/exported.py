"""What another program reads out of Moodle XML and GIFT, written without our writers."""

from __future__ import annotations

import re
from xml.etree import ElementTree

from sim.pages.classroom.portable import Portable


def facts(q: Portable) -> dict[str, object]:
    """What a reader must find again."""
    found: dict[str, object] = {"id": q.id, "ask": q.ask}
    if q.shape == "number":
        found["number"] = q.number
    elif q.shape == "pairs":
        found["pairs"] = [*q.pairs, *(("", other) for other in q.others)]
    elif q.shape != "essay":
        found["answers"] = [(t, round(p, 3), said) for t, p, said in q.answers]
    return found


def from_moodle(text: str) -> list[dict[str, object]]:
    """Moodle XML, as its documentation describes it."""

    def inner(node: ElementTree.Element, path: str) -> str:
        return node.findtext(path) or ""

    found = []
    for node in ElementTree.fromstring(text):
        kind = node.get("type")
        if kind == "category":
            continue
        fact: dict[str, object] = {
            "id": inner(node, "name/text"), "ask": inner(node, "questiontext/text"),
        }  # fmt: skip
        answers = node.findall("answer")
        if kind == "numerical":
            numbers = (inner(answers[0], "text"), inner(answers[0], "tolerance"))
            fact["number"] = tuple(map(float, numbers))
        elif kind == "matching":
            fact["pairs"] = [
                (inner(s, "text"), inner(s, "answer/text")) for s in node.findall("subquestion")
            ]
        elif kind in ("multichoice", "shortanswer"):
            fact["answers"] = [
                (inner(a, "text"), round(float(a.get("fraction") or 0), 3),
                 inner(a, "feedback/text"))
                for a in answers
            ]  # fmt: skip
        found.append(fact)
    return found


def plain(text: str) -> str:
    """GIFT's escapes taken out."""
    return re.sub(
        r"\\(.)", lambda m: "\n" if m[1] == "n" else m[1], text
    ).replace("-&gt;", "->")  # fmt: skip


def from_gift(text: str) -> list[dict[str, object]]:
    """GIFT: blocks between empty lines; an answer begins with an unescaped = or ~."""
    found = []
    for whole in re.split(r"\n\n+", text.strip()):
        block = "\n".join(line for line in whole.splitlines() if not line.startswith("//"))
        if block.startswith("$CATEGORY"):
            continue
        match = re.fullmatch(r"::((?:\\.|[^\\:])*)::\[html\]((?:\\.|[^\\{])*)\{(.*)\}", block, re.S)
        assert match, block
        fact: dict[str, object] = {"id": plain(match[1]), "ask": plain(match[2])}
        body = re.split(r"(?<!\\)####", match[3])[0].strip()
        if body.startswith("#"):
            value, tolerance = body[1:].split(":")
            fact["number"] = (float(value), float(tolerance))
        elif body:
            parts = re.findall(r"([=~])((?:\\.|[^\\=~])*)", body)
            if " -> " in parts[0][1]:
                pairs = (p.strip("\n").split(" -> ") for _, p in parts)
                fact["pairs"] = [(plain(left), plain(right.strip())) for left, right in pairs]
            else:
                fact["answers"] = [_answer(sign, part.strip()) for sign, part in parts]
        found.append(fact)
    return found


def _answer(sign: str, part: str) -> tuple[str, float, str]:
    weight = re.match(r"%(-?[\d.]+)%", part)
    percent = float(weight[1]) if weight else (100.0 if sign == "=" else 0.0)
    text, _, said = (
        re.sub(r"^%-?[\d.]+%", "", part).partition("#")
        if not re.search(r"\\#", part)
        else (
            *re.split(r"(?<!\\)#", re.sub(r"^%-?[\d.]+%", "", part) + "#", maxsplit=2)[:1],
            "",
            "",
        )
    )
    return plain(text), round(percent, 3), plain(said)
