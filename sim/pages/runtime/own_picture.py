"""Pyodide takes the picture of the memory in our form, and when it is needed, not before.

As released it takes the whole memory in one piece, and waits for it before it makes the instance
that the memory is for. Here the instance is made while the picture still comes, and the option
`_putPicture` puts it there: a function of memory and picture (sim/web/src/runtime/picture.js).
"""

from __future__ import annotations

from .same_table import once

_WHOLE = "return Module.HEAP8.set(t),l}"
_IN_OUR_FORM = "return API.config._putPicture(Module.HEAP8,t),l}"
_FIRST = "s=await ke(t,n),r=await Re(i,n);Fe(r,t);let a=Ae(r,s,t)"
_LATER = (
    "s=t._loadSnapshot;if(s)n.noInitialRun=!0;let r=await Re(i,n);Fe(r,t);let a=Ae(r,await s,t)"
)


def takes_our_picture(module: str) -> str:
    """Return the text of pyodide.asm.mjs so that it leaves the memory to `_putPicture`.

    Raises RuntimePackError where the text is not that of the release which this was written for.
    """
    return once(module, _WHOLE, _IN_OUR_FORM)


def waits_later(loader: str) -> str:
    """Return the text of pyodide.mjs so that it awaits the picture after its instance.

    Raises RuntimePackError where the text is not that of the release which this was written for.
    """
    return once(loader, _FIRST, _LATER)
