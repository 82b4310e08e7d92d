"""The custom element `<carts-scene>` as the generator writes it: a picture that needs no script.

Python decides what the page may know (`baked`) and the scales that hold for its life. What draws is
the page's own script, run once when the site is built (`sim.pages.drawing`); the page takes over
the elements that it finds.
"""

from sim.pages.widget.render import render

__all__ = ["render"]
