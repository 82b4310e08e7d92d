"""Runs the page's own following of marks, without a page: frames in, places and readings out."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.film.maker import Frame, Stage
from tests.web.scene.given.widget_site import in_node

_SCRIPT = """
const { Follower, around } = await import(source + "/film/follow.js");
const { patchOf } = await import(source + "/film/patch.js");
const { readings } = await import(source + "/film/along.js");
const { width, height, times, pictures, clicks, ruler, slower } = data;
const size = { width, height };
const frames = pictures.map((text) => Buffer.from(text, "base64"));
const cut = (frame, box) => {
  const rgba = new Uint8ClampedArray(4 * box.width * box.height);
  for (let y = 0; y < box.height; y += 1) {
    for (let x = 0; x < box.width; x += 1) {
      const from = 3 * ((box.top + y) * width + box.left + x);
      rgba.set([frame[from], frame[from + 1], frame[from + 2], 255], 4 * (y * box.width + x));
    }
  }
  return patchOf(rgba, box);
};
const marks = clicks.map(([x, y]) => {
  const box = around({ x, y }, size);
  return Follower.of(cut(frames[0], box), { x, y }, times[0], size);
});
const rows = frames.map((frame, k) => ({
  t: times[k],
  marks: marks.map((mark) => {
    if (!mark || !k) return mark && { ...mark.place };
    const box = mark.box(times[k]);
    return mark.take(cut(frame, box), times[k]);
  }),
}));
const ends = ruler.map(([x, y]) => ({ x, y }));
const how = { names: ["A", "B"], slower, remarks: ["a film"] };
const text = marks.every(Boolean) ? readings(rows, { ends, length: 0.5 }, how) : "";
give({ rows, text, known: marks.map(Boolean) });
"""


@dataclass(frozen=True)
class Followed:
    """`places[k]`: of mark k in every frame, pixels, not a number where it was lost."""

    places: list[NDArray[np.float64]]
    known: list[bool]
    text: str

    def lost(self, mark: int) -> list[int]:
        return [int(k) for k in np.flatnonzero(np.isnan(self.places[mark][:, 0]))]


def follow(
    stage: Stage,
    pictures: Iterable[Frame],
    times: Sequence[float],
    clicks: Sequence[tuple[float, float]],
    slower: float = 1.0,
) -> Followed:
    """Follow what was clicked in the first picture through all of them."""
    found: dict[str, Any] = in_node(
        _SCRIPT,
        {
            "width": stage.width,
            "height": stage.height,
            "times": [float(t) for t in times],
            "pictures": [b64encode(picture.tobytes()).decode() for picture in pictures],
            "clicks": [list(click) for click in clicks],
            "ruler": [list(end) for end in stage.ruler],
            "slower": slower,
        },
    )
    places = [
        np.array([[p["x"], p["y"]] if (p := row["marks"][k]) else [np.nan] * 2
                  for row in found["rows"]])
        for k in range(len(clicks))
    ]  # fmt: skip
    return Followed(places, found["known"], found["text"])


def missed(followed: Followed, stage: Stage, motion: Sequence[NDArray[np.float64]]) -> list[float]:
    """Root mean square distance along each axis of found and true places, in pixels; the worse.

    A mark's middle may be off by the same amount in all frames: no reading depends on it.
    """
    worst = []
    for places, x in zip(followed.places, motion, strict=True):
        off = places - np.array([stage.place(float(one)) for one in x])
        worst.append(float(np.nanstd(off, axis=0).max()))
    return worst
