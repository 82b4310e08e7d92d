"""The custom element `<carts-scene>` as the generator writes it: a picture that needs no script.

`render` draws the start of a baked run as SVG, the graphs, tables and controls. The page's script
takes over the same elements and computes them anew with the same arithmetic: every module that
draws has a twin in `sim/web/src`, and a test compares what the two write.
"""

from sim.pages.widget.render import render

__all__ = ["render"]
