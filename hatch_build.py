"""What a wheel carries beside the sources: the packed runtime, fonts and KaTeX.

With them `pip install newtons-carts` is all that a teacher needs: no Node.js, no network. They are
put together by sim/pages/site/carried.py, which needs what `make setup` installs.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

PLACE = "sim/carried"


class CarriedFiles(BuildHookInterface):
    """Adds the folder sim/carried to a wheel; an editable installation takes the checkout's own."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Called by hatchling before it writes a wheel."""
        if version == "editable":
            return
        self.folder = tempfile.TemporaryDirectory(prefix="carts-wheel-")
        command = [sys.executable, "-m", "sim.pages.site.carried", self.folder.name]
        if subprocess.run(command, cwd=self.root, check=False).returncode:
            raise RuntimeError(
                "The wheel was not built: see above. “make wheel” sets up what it needs."
            )
        build_data["force_include"][self.folder.name] = PLACE

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Called when the wheel is written."""
        if hasattr(self, "folder"):
            self.folder.cleanup()
