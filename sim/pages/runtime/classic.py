"""Pyodide's loader as one classic script, the only kind that a worker on a file:// page can be.

Chromium refuses module workers and `import()` of Blob addresses there, and Pyodide is published as
ES modules that refuse classic workers. Three words of its text are replaced; since pins.py fixes
that text, a replacement that does not fit is an error of ours and fails the build.
"""

from __future__ import annotations

import re

from .node import RuntimePackError
from .own_picture import takes_our_picture, waits_later
from .same_table import same_table

# Pyodide recognises a classic worker by an importScripts that works. Nothing here may load scripts.
PRELUDE = 'self.importScripts = () => { throw new TypeError("no scripts from elsewhere"); };\n'

TEMPLATE = """\
// Pyodide {version}, MPL-2.0, https://github.com/pyodide/pyodide
// Unchanged but for its import and export, for how the table of functions is filled and how a
// picture of the memory is put back: see same_table.py and own_picture.py in sim/pages/runtime of
// Newton's Carts.
{prelude}self.__pyodide = {{
  createPyodideModule: (() => {{
{module}
    return _createPyodideModule;
  }})(),
  ...(() => {{
{loader}
  }})(),
}};
"""


def classic_script(loader: str, module: str, version: str) -> str:
    """Return pyodide.mjs and pyodide.asm.mjs as a script that sets `self.__pyodide`."""
    module = takes_our_picture(same_table(module))
    module = _once(module, r"export default _createPyodideModule;\s*$", "")
    module = module.replace("import.meta.url", "self.location.href")
    loader = re.sub(r"//# sourceMappingURL=\S+\s*$", "", waits_later(loader))
    loader = _once(
        loader,
        r"export\{(\w+) as loadPyodide,(\w+) as version\};\s*$",
        r"return{loadPyodide:\1,version:\2};",
    )
    for name, text in (("pyodide.asm.mjs", module), ("pyodide.mjs", loader)):
        left = re.search(r"\bimport\.meta\b|^\s*(?:import|export)\b[^(.]", text, re.MULTILINE)
        if left:
            raise RuntimePackError(f"{name} still has {left.group()!r}: another release?")
    return TEMPLATE.format(version=version, prelude=PRELUDE, module=module, loader=loader)


def _once(text: str, pattern: str, replacement: str) -> str:
    changed, count = re.subn(pattern, replacement, text)
    if count != 1:
        raise RuntimePackError(f"Pyodide's text has {count} times {pattern!r}, once was expected")
    return changed
