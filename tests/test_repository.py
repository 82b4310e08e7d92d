"""What may lie in the repository: no registry's address, no path of a machine, nothing large."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
LARGEST = 1_000_000  # bytes


def tracked() -> list[Path]:
    names = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True
    ).stdout.decode()
    return [ROOT / name for name in names.split("\0") if name and (ROOT / name).is_file()]


def test_no_tracked_file_is_large() -> None:
    large = {p.relative_to(ROOT).as_posix(): p.stat().st_size for p in tracked()}
    assert {name: size for name, size in large.items() if size > LARGEST} == {}


@pytest.mark.parametrize("lock", ["requirements.lock", "package-lock.json"])
def test_the_locks_name_no_host(lock: str) -> None:
    text = (ROOT / lock).read_text(encoding="utf-8")
    # npm notes where an author can be supported: no address that anything is fetched from.
    data = re.sub(r'"funding": (\[.*?\]|\{.*?\})', "", text, flags=re.DOTALL)
    assert re.findall(r"https?://\S+", data) == []
    assert "index-url" not in text
    assert '"resolved"' not in text


def test_every_locked_python_package_has_its_hashes() -> None:
    text = (ROOT / "requirements.lock").read_text(encoding="utf-8").replace("\\\n", " ")
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            assert "==" in line, line
            assert "--hash=sha256:" in line, line


def test_every_locked_npm_package_has_its_hash() -> None:
    lock = json.loads((ROOT / "package-lock.json").read_text(encoding="utf-8"))
    for name, entry in lock["packages"].items():
        assert not name or entry.get("integrity", "").startswith("sha512-"), name


def test_no_file_holds_a_path_of_somebodys_machine() -> None:
    # /home/pyodide is a folder inside Python's own little computer in the page.
    home = rb"home/(?!pyodide|web_user)\w+"
    pattern = re.compile(rb"(?<![\w.])/(?:work|root|farm|Users/\w+|" + home + rb")/[A-Za-z.]")
    found = [
        path.relative_to(ROOT).as_posix()
        for path in tracked()
        if path.suffix not in (".woff2", ".png", ".gif") and pattern.search(path.read_bytes())
    ]
    assert found == []


def test_what_is_built_is_not_tracked() -> None:
    built = ("site/", "build/", ".cache/", "node_modules/", ".venv/")
    assert [p for p in tracked() if p.relative_to(ROOT).as_posix().startswith(built)] == []
