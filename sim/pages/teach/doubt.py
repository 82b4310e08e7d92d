"""A value that can be read and is probably not meant: it is asked about before it is written."""

from __future__ import annotations

from sim.pages.text.yaml.source import KeyPath

HEAVY = 20.0
"""kg. What runs on a school's track is lighter; the masses of carts in grams are larger numbers."""


def doubt(path: KeyPath, wanted: str) -> str:
    """What is asked of a plain number as a mass, which is in kg; "" where nothing is to be asked.

    A field that shows “0.5 kg” is overwritten with “750” by who thinks in grams.
    """
    if not path or path[-1] != "mass":
        return ""
    typed = wanted.strip()
    try:
        mass = float(typed.replace(",", "."))
    except ValueError:
        return ""
    if not HEAVY < mass < float("inf"):
        return ""
    return (
        f"{typed} kg? Carts weigh 0.1 to 5 kg. Type {typed} g for grams, {typed} kg if you mean it"
    )
