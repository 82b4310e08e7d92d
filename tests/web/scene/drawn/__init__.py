"""The pure functions that draw, without a page."""
