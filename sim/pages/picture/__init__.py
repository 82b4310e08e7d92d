"""A still picture of a scene: for a card, a menu, a page that plays nothing."""

from __future__ import annotations

from .block import PictureBlock, read_picture_block
from .render import render_picture

__all__ = ["PictureBlock", "read_picture_block", "render_picture"]
