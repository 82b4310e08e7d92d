"""A cell of measured readings that is no number is told with its line and its column."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.pages.checks.lessons import check_paths

HEAD = "t (s){0}x_A (m){0}x_B (m)\n"
BLOCK = "# A\n\n```measured\nid: film\ndata: film.csv\n```\n"
CASES = [
    ("{k}{0}sechzig{0}0.9\n", 5),
    ("sechzig{0}0.9{0}0.8\n", 1),
    ("0.5{0}0.9{0}sechzig\n", 9),
    ('0.5{0}0.9{0}"sechzig"\n', 10),
]


@pytest.mark.parametrize("mark", ["", "\ufeff"])
@pytest.mark.parametrize("separator", [",", "\t", ";"])
@pytest.mark.parametrize(("row", "column"), CASES)
def test_a_cell_that_is_no_number_has_its_column(
    tmp_path: Path, row: str, column: int, separator: str, mark: str
) -> None:
    rows = "".join(f"0.{k}{separator}0.{k}{separator}0.9\n" for k in range(1, 6))
    text = mark + HEAD.format(separator) + rows + row.format(separator, k="0.6")
    table = tmp_path / "worksheets" / "data" / "film.csv"
    table.parent.mkdir(parents=True)
    table.write_text(text, encoding="utf-8")
    (table.parents[1] / "a.md").write_text(BLOCK, encoding="utf-8")
    (found,) = check_paths([tmp_path / "worksheets"], tmp_path)
    assert (found.line, found.col) == (7, column)
    assert "“sechzig” is not a number" in found.message
    fitted = CliRunner().invoke(main, ["fit", str(table)])
    assert f"film.csv:7:{column}: error: “sechzig” is not a number" in fitted.stderr
