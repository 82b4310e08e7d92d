"""What is said of a scene that cannot be."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from sim.scene import SceneError, read_scene


def problems(plain: Any, read: Callable[[Any], object] = read_scene) -> set[tuple[str, str]]:
    """Where they are, and their codes."""
    with pytest.raises(SceneError) as caught:
        read(plain)
    return {(problem.where, problem.code) for problem in caught.value.problems}
