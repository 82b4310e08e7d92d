"""What a page shows as it is typed may have no formula in it: an author is told where."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.pages.checks.lessons import check_paths

CARTS = """carts:
  A: {mass: 1 kg, position: 0.3 m, velocity: 0.6 m/s}
  B: {mass: 1 kg, position: 1.2 m}
"""
START = "start: |\n  def force(overlap, rate):\n      return 100 * overlap\n"
TOLD = "no formula, picture or bold word is shown here, only what is typed"


@pytest.mark.parametrize(
    ("keys", "where"),
    [
        ("title: 'How large is \\(F\\)?'\n", "4:8: error: title"),
        ("predict: {ask: 'Is \\(F\\) alike?', arrows: [A-B]}\n", "4:16: error: predict.ask"),
        ("predict: {ask: x, choice: [up, '**down**']}\n", "4:32: error: predict.choice.1"),
        ("predict: {text: 'Say \\(v\\).'}\n", "4:17: error: predict.text"),
    ],
)
def test_a_formula_in_a_text_of_a_scene_is_a_mistake(tmp_path: Path, keys: str, where: str) -> None:
    assert _found(tmp_path, f"```scene\nid: one\n{keys}{CARTS}```\n") == f"{where}: {TOLD}"


def test_a_formula_in_what_a_law_asks_is_a_mistake(tmp_path: Path) -> None:
    text = f"```law\nid: one\nask: 'What is \\(F\\)?'\n{START}{CARTS}```\n"
    assert _found(tmp_path, text) == f"4:6: error: ask: {TOLD}"


def _found(folder: Path, block: str) -> str:
    path = folder / "a.md"
    path.write_text(f"\n{block}", encoding="utf-8")
    (found,) = check_paths([path], folder)
    return str(found).splitlines()[0].removeprefix("a.md:")
