"""One table of functions in every browser, so that one picture of the memory fits all of them.

C keeps a pointer to a function as its place in WebAssembly's table, and the picture of the memory
is full of such numbers. Emscripten fills the table while it starts: it appends every exported
function that is not in it yet, and Python one function of its own that calls others whatever number
of arguments they take ("trampoline"). In two kinds of browsers another table comes out of it, and
the picture's numbers then point at the wrong functions or past the end:

- WebKit gives a function of the table as another object than the same function among the exports,
  so 972 of them are appended twice. Here a function that is not found as an object is looked up by
  its name, which by the standard is its number in the module.
- Chromium before 119 can't compile the trampoline, which is written with WebAssembly's types of
  garbage collection, and Pyodide leaves it out on iOS, where it once ended the whole page
  (pyodide#5428). Here a function in JavaScript then takes the same place. In a worker nobody can
  tell an iPad that poses as a Mac from a Mac, so all of WebKit gets that one.
"""

from __future__ import annotations

import re

from .node import RuntimePackError

_WAY = "return functionsInTableMap.get(func)||0};"
_STARTS = "functionsInTableMap=new WeakMap;updateTableMap(0,wasmTable.length)"
_DONE = "updateGOT(origExports);"
_POSES = (
    r"let isIOS=globalThis\.navigator&&\(/iPad\|iPhone\|iPod/.{0,160}?maxTouchPoints>1\);"
    r"if\(isIOS\)\{return 0\}"
)
_FAILS = "try{trampolineModule=getWasmTrampolineModule()}catch(e){return 0}"

_BY_NAME = (
    "own={};for(let at=0;at<wasmTable.length;at++)"
    "{const entry=wasmTable.get(at);if(entry)own[entry.name]=at}"
)
_IN_JS = (
    'const inJS=()=>addFunction((_,f,a,b,c)=>getWasmTableEntry(f)(a,b,c),"iiiiii");'
    'const told=globalThis.navigator?.userAgent??"";'
    "if(/AppleWebKit/.test(told)&&!/Chrom/.test(told))return inJS();"
)


def same_table(module: str) -> str:
    """Return the text of pyodide.asm.mjs so that it fills the table in the same way everywhere.

    Raises RuntimePackError where the text is not that of the release which this was written for.
    """
    module = once(module, _STARTS, f"{_STARTS};{_BY_NAME}")
    module = once(
        module, _WAY, "return functionsInTableMap.get(func)||own?.[func.name]||0};var own;"
    )
    module = once(module, _DONE, f"{_DONE}own=undefined;")  # other modules number theirs anew
    module = once(module, _FAILS, _FAILS.replace("return 0", "return inJS()"))
    found = re.findall(_POSES, module)
    if len(found) != 1:
        raise RuntimePackError(f"Pyodide's text asks {len(found)} times for iOS, once was expected")
    return module.replace(found[0], _IN_JS)


def once(text: str, old: str, new: str) -> str:
    """Return `text` with `new` for `old`. Raises RuntimePackError if `old` is not there once."""
    if (count := text.count(old)) != 1:
        raise RuntimePackError(f"Pyodide's text has {count} times {old!r}, once was expected")
    return text.replace(old, new)
