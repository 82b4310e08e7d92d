"""An option that a call has no use for is refused or told in one line, never passed over."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.classroom.given.makers import bank, keys, random_class, sources
from tests.cli.called import carts

BANK = bank(6)
TOTALS = "student,pre (10),post (10)\n" + "\n".join(f"s{k},{k % 5},{k % 7}" for k in range(9))
SCENE = "carts: {A: {mass: 1, position: 0.5}}\n"


@pytest.fixture
def school(tmp_path: Path) -> Path:
    (tmp_path / "7a").mkdir()
    for source in sources(random_class(BANK, 6, seed=1, prefix="7a")):
        (tmp_path / "7a" / source.name).write_bytes(source.content)
    (tmp_path / "key.json").write_text(keys(BANK), encoding="utf-8")
    (tmp_path / "marks.csv").write_text(TOTALS, encoding="utf-8")
    (tmp_path / "groups.csv").write_text("student,group,pre,post\na,x,1,2\nb,x,2,3\n", "utf-8")
    return tmp_path


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("7a", "--answers"), "--answers belongs to --slips"),
        (("7a", "--separator", ";"), "--separator belongs to --csv and --items"),
        (("7a", "--student", "x.json=RED"), "--student x.json=RED: no file of this name was read"),
        (("--merge", "key.json", "--group", "a=*"), "the summaries name their groups"),
        (("--merge", "key.json", "--csv", "x.csv"), "a summary has none"),
        (("--merge", "key.json", "7a"), "“7a” is a folder. Name the summaries in it: 7a/*.json"),
        (("--table", "groups.csv", "--group", "a=*"), "a table has a column of groups already"),
    ],
)
def test_the_class_refuses_what_it_cannot_use(
    school: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...], reason: str
) -> None:
    monkeypatch.chdir(school)
    result = carts("class", *words)
    assert (result.exit_code, result.stdout) == (2, "")
    assert reason in result.stderr


def test_a_code_word_for_a_file_that_has_its_own_is_refused(school: Path) -> None:
    name = sorted(path.name for path in (school / "7a").iterdir())[0]
    result = carts("class", school / "7a", "--student", f"{name}=RED-CAT-11")
    assert result.exit_code == 2
    assert "this file has the code word" in result.stderr


@pytest.mark.parametrize(
    ("words", "warning"),
    [
        (
            ("7a", "--key", "key.json", "--group", "a=7a/*", "--group", "b=7x/*"),
            "--group b=7x/*: no file fits it",
        ),
        (("--table", "marks.csv", "--max", "20"), "--max 20 changes nothing: the table tells it"),
    ],
)
def test_the_class_warns_of_what_changes_nothing(
    school: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...], warning: str
) -> None:
    monkeypatch.chdir(school)
    result = carts("class", *words)
    assert (result.exit_code, result.stderr) == (0, f"warning: {warning}\n")


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("cost", "scene.yml", "--carts", "2,3"), "--carts stands in place of a scene"),
        (("cost", "--carts", "2,3", "--svg", "x.svg"), "has no --svg"),
        (("check", "--json", "--format", "github"), "exclude each other"),
        (("law", "mine.py", "--json", "--yaml", "energy"), "exclude each other"),
    ],
)
def test_options_that_exclude_each_other_are_refused(words: tuple[str, ...], reason: str) -> None:
    result = carts(*words)
    assert (result.exit_code, result.stdout) == (2, "")
    assert reason in result.stderr
