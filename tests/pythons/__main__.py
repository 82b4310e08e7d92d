"""`make test-pythons`: the whole site, built by every Python of this machine, to the last byte.

Each gets an environment of its own from the lock (a minute), and builds the site as `make site`
does. Python 3.11 adds floats up in another way than later ones, so its last digits may differ, and
it cannot make the bytecode of numpy and scipy: there the site must be built, not be the same.
"""

from __future__ import annotations

import filecmp
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from tests.pythons.found import SAME_SUMS, other_pythons

ROOT = Path(__file__).parents[2]
INSTALL = ("-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps")


def built_by(python: str, folder: Path) -> Path:
    """The folder of the site that this Python has built."""
    own = folder / "venv"
    subprocess.run([python, "-m", "venv", own], check=True)
    inside = str(own / "bin" / "python")
    lock = ("--require-hashes", "-r", "requirements.lock")
    subprocess.run([inside, *INSTALL, *lock], cwd=ROOT, check=True)
    subprocess.run(
        [inside, *INSTALL, "--no-build-isolation", "--editable", "."], cwd=ROOT, check=True
    )
    return _site(inside, folder / "site")


def _site(python: str, folder: Path) -> Path:
    program = "import sys; from pathlib import Path; from sim.cli.site.build import build_site; "
    program += "assert build_site(Path('.'), hosted=False, strict=True, site_dir=Path(sys.argv[1]))"
    where = os.environ | {"PYTHONPATH": str(ROOT), "PYTHONDONTWRITEBYTECODE": "1"}
    subprocess.run([python, "-c", program, str(folder)], cwd=ROOT, env=where, check=True)
    return folder


def differences(one: Path, other: Path) -> Iterator[str]:
    """Files that only one of two folders has, or that differ."""
    names = {
        path.relative_to(folder)
        for folder in (one, other)
        for path in folder.rglob("*")
        if path.is_file()
    }
    for name in sorted(names):
        both = (one / name).exists() and (other / name).exists()
        if not both or not filecmp.cmp(one / name, other / name, shallow=False):
            yield name.as_posix()


def main() -> None:
    """Builds with each and says what differs; ends with 1 where it must not."""
    bad = False
    with tempfile.TemporaryDirectory() as made:
        here = _site(sys.executable, Path(made) / "here")
        for version, python in other_pythons().items():
            there = built_by(python, Path(made) / version)
            found = list(differences(here, there))
            same = tuple(map(int, version.split("."))) >= SAME_SUMS
            bad = bad or (same and bool(found))
            said = f"{len(found)} files differ" if found else "the same to the last byte"
            print(f"Python {version}: {said}{'' if same else ' (may: see tests/pythons)'}")
            for name in found[:10] if same else ():
                print(f"  {name}")
    raise SystemExit(bad)


if __name__ == "__main__":
    main()
