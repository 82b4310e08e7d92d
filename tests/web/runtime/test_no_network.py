"""The strongest proof that no page asks for anything: there is nothing there to ask."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]


@pytest.mark.browser
def test_the_site_runs_in_an_empty_network_namespace(site: Path) -> None:
    unshare = shutil.which("unshare")
    allowed = unshare and subprocess.run([unshare, "-rn", "true"], check=False).returncode == 0
    if not allowed:
        pytest.skip("this computer does not let a test make a network namespace")
    result = subprocess.run(
        [str(unshare), "-rn", sys.executable, "-m", "tests.web.runtime.netless", str(site)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert result.returncode == 0, result.stderr
    state, live, scenes = result.stdout.split()
    assert state == "live"
    assert live == scenes != "0"
