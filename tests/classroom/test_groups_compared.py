"""Two groups, and the topics of a test: what a report says of their difference."""

from __future__ import annotations

import re
from typing import Any

import numpy
import pytest

from tests.classroom.given.class_reports import BANK, made, two
from tests.classroom.given.makers import bank, random_class


def test_topics_are_compared_before_and_after() -> None:
    source = bank(12, topics=("first-law", "third-law"))
    students = random_class(source, 12)
    rows = made(("class", students), source=source)["lessons"][0]["topics"]
    assert [(row["topic"], row["questions"], row["of"]) for row in rows] == [
        ("first-law", 6, 6), ("third-law", 6, 6),
    ]  # fmt: skip
    of_topic = [name for name, item in source.items.items() if "first-law" in item.common.topics]
    by_hand = [
        sum(i["value"] == source.items[i["id"]].key()["correct"][0]
            for i in f["items"] if i["id"] in of_topic)
        for f in students if f["form"] == "pre"
    ]  # fmt: skip
    assert rows[0]["pre"]["mean"] == pytest.approx(sum(by_hand) / 12, rel=1e-12)
    assert made(("class", random_class(BANK, 12)))["lessons"][0]["topics"] == []


def test_two_groups_are_compared_in_each_topic_as_in_a_test_of_its_questions_alone() -> None:
    """The paper's own question: an advantage on the first law, and none on the third."""
    source = bank(12, topics=("first-law", "third-law"))
    new = random_class(source, 25, seed=1, gain=0.4, prefix="FOX")
    usual = random_class(source, 22, seed=2, gain=0.1, prefix="OWL")
    rows = made(("new", new), ("usual", usual), source=source)["lessons"][0]["topic_differences"]
    assert [row["topic"] for row in rows] == ["first-law", "third-law"]
    assert all(row["groups"] == ["new", "usual"] for row in rows)

    def marks(students: list[dict[str, Any]], form: str) -> list[int]:
        return [
            sum(i["value"] == source.items[i["id"]].key()["correct"][0] for i in f["items"]
                if "third-law" in source.items[i["id"]].common.topics)
            for f in students if f["form"] == form
        ]  # fmt: skip

    before = [*marks(new, "pre"), *marks(usual, "pre")]
    after = [*marks(new, "post"), *marks(usual, "post")]
    design = [[1.0, float(k < 25), float(b)] for k, b in enumerate(before)]
    fitted, *_ = numpy.linalg.lstsq(numpy.array(design), numpy.array(after, float), rcond=None)
    assert rows[1]["difference"] == pytest.approx(fitted[1], rel=1e-9)
    assert rows[1]["low"] < rows[1]["difference"] < rows[1]["high"]
    assert "third-law" in rows[1]["sentence"]
    alone = made(("all", new), source=source)["lessons"][0]
    assert alone["topics"]
    assert alone["topic_differences"] == []


def test_the_baseline_stands_before_any_claim() -> None:
    sentences = two()["sentences"]
    assert sentences[0].startswith("Before teaching: new minus usual")
    assert sentences[1].startswith("Adjusted for the start")


def test_groups_that_start_apart_are_said_to() -> None:
    one = random_class(BANK, 25, seed=1, prefix="FOX")
    low = random_class(bank(10), 25, seed=3, gain=0.5, prefix="OWL")
    for file in low:
        if file["form"] == "pre":
            file["items"] = file["items"][:3]
    comparison = made(("new", one), ("usual", low))["lessons"][0]["comparison"]
    assert abs(comparison["baseline"]["z"]) > 1
    assert "A group that starts low tends to rise by itself" in comparison["sentences"][0]


def test_with_one_class_in_each_group_no_p_is_told() -> None:
    one_class = two()
    assert not one_class["p_shown"]
    told = " ".join(one_class["sentences"])
    assert "30 students in one room are not 30 independent experiments" in told
    assert "p =" not in told
    assert "p <" not in told
    several = two(classes={"new": 2, "usual": 2})
    assert several["p_shown"]
    assert "This is not the chance that teaching worked" in " ".join(several["sentences"])


def test_the_interval_stands_before_p() -> None:
    sentences = two(classes={"new": 2, "usual": 2})["sentences"]
    told = [(one, p.start()) for one in sentences if (p := re.search(r"p [=<]", one))]
    assert len(told) == 2  # adjusted for the start, and after teaching alone
    for sentence, p in told:
        assert 0 <= sentence.find("would fit") < p
