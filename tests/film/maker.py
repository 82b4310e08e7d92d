"""Films of two carts whose motion is known: drawn pixel by pixel, with noise, blur and compression.

A mark is a disc with a soft edge: how much of a pixel it covers follows from the distance of the
pixel's middle from the disc's, so a mark may stand between pixels.
"""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

Frame = NDArray[np.uint8]
RED, GREEN = (214.0, 40.0, 52.0), (24.0, 160.0, 72.0)
CART, TRACK, RULER = (92.0, 96.0, 108.0), (60.0, 56.0, 50.0), (236.0, 222.0, 160.0)
SOFT = 0.6  # pixels to each side: the edge of a disc as a good lens draws it


@dataclass(frozen=True)
class Stage:
    """What stands before the camera. Lengths in pixels but for `scale`, in pixels per metre."""

    width: int = 640
    height: int = 240
    scale: float = 320.0
    radius: float = 9.0
    tilt: float = 0.0  # of the camera, rad: the track runs down to the right
    noise: float = 0.0  # of 255, standard deviation
    blur: float = 0.0  # s that the shutter is open

    colours: ClassVar = (RED, GREEN)

    @cached_property
    def still(self) -> NDArray[np.float32]:
        """All that does not move: a wall that is no plain colour, the track, a ruler."""
        y, x = np.mgrid[: self.height, : self.width].astype(np.float32)
        wall = 150 + 30 * np.sin(x / 37) * np.cos(y / 23) + 20 * (y / self.height)
        picture = np.stack([wall, 0.98 * wall + 4, 0.9 * wall + 10], axis=2)
        floor = self.height * 0.72 + (x - self.width / 2) * np.tan(self.tilt)
        picture[np.abs(y - floor) < 4] = TRACK
        a, b = self.ruler
        on = (np.abs(y - a[1]) < 5) & (x >= a[0]) & (x <= b[0])
        picture[on] = RULER
        return picture.astype(np.float32)

    @property
    def ruler(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Its two ends, half a metre apart."""
        y = self.height * 0.9
        left = self.width * 0.3
        return (left, y), (left + 0.5 * self.scale, y)

    def place(self, x: float) -> tuple[float, float]:
        """Where a mark at x m stands in the picture; a pixel's middle has whole numbers."""
        along = self.scale * x - self.width / 2
        return (
            self.width / 2 + along * np.cos(self.tilt),
            self.height * 0.5 + along * np.sin(self.tilt),
        )

    def frame(self, places: Sequence[float], noise: np.random.Generator) -> Frame:
        """One picture with the marks at these x, in m; a bumper pressed in deep lets the carts'
        bodies overlap, and a mark stands before both of them."""
        picture = self.still.copy()
        spots = [self._around(picture, *self.place(x)) for x in places]
        for part, across, down in spots:
            box = np.maximum(np.abs(across) / 2.6, np.abs(down - self.radius) / 2.2)
            cover(part, self.radius - box, CART)
        for (part, across, down), colour in zip(spots, self.colours, strict=True):
            cover(part, self.radius - np.hypot(across, down), colour)
        if self.noise:
            picture += noise.normal(0.0, self.noise, picture.shape).astype(np.float32)
        return np.clip(np.rint(picture), 0, 255).astype(np.uint8)

    def _around(
        self, picture: NDArray[np.float32], cx: float, cy: float
    ) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
        """The part of the picture that a cart with its mark there covers, how far its columns lie
        to the right of the mark, and how far its rows below."""
        reach = int(3.2 * self.radius)
        left, top = int(cx) - reach, int(cy) - reach
        rows = slice(max(0, top), max(0, min(self.height, top + 2 * reach + 2)))
        columns = slice(max(0, left), max(0, min(self.width, left + 2 * reach + 2)))
        across = np.arange(self.width, dtype=np.float32)[columns] - cx
        down = np.arange(self.height, dtype=np.float32)[rows, None] - cy
        return picture[rows, columns], across, down


def cover(part: NDArray[np.float32], inside: NDArray[np.float32], colour: Sequence[float]) -> None:
    """Paint where `inside` is positive; softly where it is near 0."""
    share = np.clip(0.5 + inside / (2 * SOFT), 0, 1)[..., None]
    part += share * (np.asarray(colour, dtype=np.float32) - part)


def frames(
    stage: Stage, times: Sequence[float], motion: Sequence[NDArray[np.float64]], seed: int = 1
) -> Iterator[Frame]:
    """The pictures at these times; `motion[k]` are the places of cart k then, in m.

    With a shutter that stays open, each is the mean of five pictures along the way of the carts.
    """
    noise = np.random.default_rng(seed)
    for n in range(len(times)):
        if not stage.blur:
            yield stage.frame([x[n] for x in motion], noise)
            continue
        speeds = [np.gradient(x, times) for x in motion]
        beside = stage.blur * np.linspace(-0.5, 0.5, 5)
        parts = [
            stage.frame([x[n] + dt * v[n] for x, v in zip(motion, speeds, strict=True)], noise)
            for dt in beside
        ]
        yield np.mean(parts, axis=0).astype(np.uint8)


def encoded(
    pictures: Iterator[Frame], times: Sequence[float], stage: Stage, *,
    codec: str = "libvpx", kind: str = "webm", options: dict[str, str] | None = None,
) -> bytes:  # fmt: skip
    """A film file in which each picture has its own time, in whole milliseconds."""
    import av

    file = io.BytesIO()
    with av.open(file, "w", format=kind) as out:
        stream = out.add_stream(codec, rate=30, options=options or {})
        stream.width, stream.height, stream.pix_fmt = stage.width, stage.height, "yuv420p"
        stream.time_base = stream.codec_context.time_base = Fraction(1, 1000)
        for picture, t in zip(pictures, times, strict=True):
            frame = av.VideoFrame.from_ndarray(picture, format="rgb24")
            frame.pts, frame.time_base = round(1000 * t), Fraction(1, 1000)
            out.mux(stream.encode(frame))
        out.mux(stream.encode())
    return file.getvalue()
