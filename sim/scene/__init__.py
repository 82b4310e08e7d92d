"""DESCRIPTION: what a scene is made of, and whether it makes sense. Standard library only.

`read_scene` turns plain values (as YAML or JSON give them) into a frozen `Scene`, or raises
`SceneError` with every problem found, each with its key path and a hint. The same code runs in
the command line, in the page generator and inside the page.
"""

from sim.scene.changes import apply_changes
from sim.scene.fence.controls import Control
from sim.scene.fence.predict import Predict
from sim.scene.fence.presentation import Fence, read_fence
from sim.scene.model import Cart, Contact, Scene, Track
from sim.scene.problem import Problem, SceneError
from sim.scene.read import read_scene

__all__ = [
    "Cart",
    "Contact",
    "Control",
    "Fence",
    "Predict",
    "Problem",
    "Scene",
    "SceneError",
    "Track",
    "apply_changes",
    "read_fence",
    "read_scene",
]
