"""What a process has imported after a run."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[3]


def imported_by(plain: dict) -> set[str]:
    """The modules that a process has after it has run this scene and nothing else."""
    script = (
        "import json, sys; from sim.scene import read_scene; from sim.dynamics.loop.run import run;"
        "from sim.dynamics.report.document import report;"
        "report(run(read_scene(json.load(sys.stdin)))); print(json.dumps(list(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        input=json.dumps(plain),
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
    )
    return set(json.loads(done.stdout))
