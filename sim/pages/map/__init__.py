"""The custom element `<carts-map>` as the generator writes it: a figure that needs no script.

`bake` computes the values when the site is built, `render` draws them as a picture with few
colours; the page's script, once the reader opens the map, lets Python compute them anew and paints
the same bands.
"""
