"""Newton's Carts: collision carts on an air track, exact, and the lessons built around them.

Layers, from inside out: ``scene`` (description), ``dynamics`` (numerics), ``lesson``
(questions), ``classroom`` (statistics), ``measured`` (real carts), ``bridge`` (wire), ``pages``
(generator), ``cli``.
``import sim`` itself imports nothing, so that a page or a command pays only for what it uses.
"""

__version__ = "0.1.0"
