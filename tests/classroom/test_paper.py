"""The paper's tables come out of our code, from the files beside the evidence page."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.classroom.paper import same_sums, sizes, whole_total
from sim.pages.blocks.extension import CartsExtension, Page, set_page
from sim.pages.blocks.scene_block import Lesson
from tests.classroom.given.paper_tables import EVIDENCE, TABLE_2, TABLE_3, text


def test_the_columns_of_table_i_add_up_to_what_is_printed() -> None:
    parts, printed = sizes(text("table-1.csv"))
    assert printed == (62, 67)
    assert same_sums(list(parts.values()), printed)


@pytest.mark.parametrize(
    ("law", "z", "p"), [("first", "2.23", "0.974"), ("third", "-0.76", "0.551")]
)
def test_z_and_p_come_out_of_the_printed_means(law: str, z: str, p: str) -> None:
    found = TABLE_2[law].z
    assert f"{found.z:.2f}" == z == f"{TABLE_2[law].printed_z:.2f}"
    assert f"{found.inside:.3f}" == p


@pytest.mark.parametrize(
    ("law", "baseline", "difference", "se", "p", "gains", "d"),
    [
        ("first", -2.26, 0.28, 0.26, 0.28, (0.27, 0.04), 0.40),
        ("third", 0.03, -0.15, 0.17, 0.37, (0.39, 0.47), -0.13),
    ],
)
def test_our_additions_are_those_on_the_page(
    law: str,
    baseline: float,
    difference: float,
    se: float,
    p: float,
    gains: tuple[float, float],
    d: float,
) -> None:
    found = TABLE_2[law]
    assert round(found.baseline.z, 2) == baseline
    assert round(found.adjusted.test.difference, 2) == difference
    assert round(found.adjusted.test.se, 2) == se
    assert found.adjusted.test.df == 126
    assert round(found.adjusted.test.p, 2) == p
    assert (round(found.experimental.hake, 2), round(found.control.hake, 2)) == gains
    assert round(found.d, 2) == d


def test_table_iii_has_the_z_that_the_paper_does_not_give() -> None:
    assert [round(TABLE_3[law].z.z, 2) for law in ("first", "third")] == [1.32, -1.75]


def test_every_mean_fits_a_whole_number_of_marks() -> None:
    for law in TABLE_2.values():
        for group in (law.experimental, law.control):
            for spread in (group.before, group.after):
                assert whole_total(spread.mean, spread.n) is not None
    for table in TABLE_3.values():
        for spread in (table.experimental, table.control):
            assert whole_total(spread.mean, spread.n) is not None


def test_the_page_shows_what_was_computed() -> None:
    from markdown import Markdown

    page = Path(EVIDENCE / "index.md")
    set_page(Page(Lesson("docs/evidence/index.md", (EVIDENCE,))))
    try:
        made = Markdown(extensions=[CartsExtension(), "tables"]).convert(
            page.read_text(encoding="utf-8").split("---", 2)[2]
        )
    finally:
        set_page(None)
    for said in ("2.23, 0.974", "−0.76, 0.551", "−2.26", "+0.28 ± 0.26", "−0.23 to +0.79",
                 "−0.15 ± 0.17", "−0.48 to +0.18", "<b>1.32</b>", "<b>−1.75</b>",
                 "0.554: <b>exceeded</b>", "add up to 62 and 67: as printed"):  # fmt: skip
        assert said in made, said


@pytest.mark.parametrize("body", ["show: nothing", "table: gains", "show: gains\nid: x"])
def test_an_evidence_block_that_shows_no_table_is_an_error_with_a_hint(body: str) -> None:
    from sim.pages.blocks.scene_block import SiteIds
    from sim.pages.checks.lessons import check_lesson

    lesson = Lesson("docs/evidence/index.md", (EVIDENCE,))
    (finding,) = check_lesson(f"# Title\n\n```evidence\n{body}\n```\n", lesson, SiteIds())
    assert finding.hint == "show: one of sizes, gains, ours, later"
    assert finding.line >= 3


def test_the_printed_numbers_must_lie_beside_the_page() -> None:
    from sim.pages.blocks.scene_block import SiteIds
    from sim.pages.checks.lessons import check_lesson

    (finding,) = check_lesson("```evidence\nshow: gains\n```\n", Lesson("x.md"), SiteIds())
    assert "table-1.csv" in finding.message


def test_what_the_text_says_of_the_adjusted_difference_is_what_is_computed() -> None:
    test = TABLE_2["first"].adjusted.test
    said = f"from {test.low:.2f} to +{test.high:.2f} would fit".replace("-", "−")
    assert said in " ".join(text("index.md").split())
