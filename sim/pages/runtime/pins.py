"""Which Pyodide, and the fingerprint of every byte of it that we use.

The five files are those of the npm package. Pyodide's own lock file, pinned here by its sha256, in
turn names the sha256 of its numpy and scipy wheels. A new Pyodide means new numbers here, nothing
else; see docs/developers/runtime.md.
"""

from __future__ import annotations

from typing import Final

PYODIDE: Final = "314.0.4"

LOADER: Final = "pyodide.mjs"
MODULE: Final = "pyodide.asm.mjs"
WASM: Final = "pyodide.asm.wasm"
STDLIB: Final = "python_stdlib.zip"
LOCK: Final = "pyodide-lock.json"

CORE: Final[dict[str, str]] = {
    LOADER: "c75dd73bb0c70674135f9f4ab746c9b5316e9fe027cafacb2be445e658f04c92",
    MODULE: "fd7a3cefa122ff6463dcf2997961eb341250e4cc4ed60281448390f0a767cca2",
    WASM: "6c8986a8ee583401069aa403e76ee79d4633a1478ab11cea76030bc299aded9f",
    STDLIB: "b5ca2308e9fa72eda319889a1ddf086389e9f1234ced279cc71267fe9ba56e54",
    LOCK: "c963d22858f6bcb8f41586a2142f03905ab370c88ea22a86a2736e95fac2a8f3",
}

# A PyPI package whose wheel carries unmodified wheels of the Pyodide distribution: the way to numpy
# and scipy where pip reaches out but nothing else does. Downloaded once, 106 MB.
CARRIER: Final = "open-webui==0.12.4"
CARRIER_FOLDER: Final = "open_webui/frontend/pyodide/"
CARRIER_MB: Final = 106

# In loading order: scipy needs numpy.
PACKAGES: Final = ("numpy", "scipy")
