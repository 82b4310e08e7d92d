"""A run as the page gets it, and how a script opens it."""

from __future__ import annotations

from base64 import b64encode
from typing import Any

from sim.bridge.protocol import answer

READ = """const [t, f, i, w, s] = await Promise.all(
  ["trajectory", "forces", "impulse", "windows", "series"].map(
    (name) => import(`${view}/${name}.js`)));
const opened = ({ header, base64 }) => {
  const bytes = Uint8Array.from(Buffer.from(base64, "base64"));
  return { header, trajectory: t.fromWire(header, new Float64Array(bytes.buffer)) };
};
"""


def wired(plain: dict[str, Any]) -> dict[str, Any]:
    """A run as the page gets it."""
    header, numbers = answer({"id": 1, "kind": "run", "scene": plain})
    return {"header": header, "base64": b64encode(numbers.tobytes()).decode()}
