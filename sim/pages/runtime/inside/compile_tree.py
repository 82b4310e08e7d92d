"""Replace every .py in an archive by its .pyc. Runs inside Pyodide, whose Python alone can do it.

The .pyc stands where the .py stood, so no source is needed to import it. Entries are sorted, dated
1980 and carry their path inside the archive as file name: equal input gives equal output.
"""

import ast
import importlib.util
import io
import marshal
import types
import zipfile

DATE = (1980, 1, 1, 0, 0, 0)
BUILD_ONLY = (".pyi", ".pxd", ".pyx", ".h", ".c", ".a", ".in", ".build", ".pc", ".template")
SMALLEST = 2  # as `python -OO`
OURS = "sim/"
"""Nobody asks our functions for the types of their arguments at run time: a tenth of their weight,
which each start of Python would read."""
NO_SOURCE_TO_CHECK = (1).to_bytes(4, "little") + bytes(8)  # PEP 552: by hash, "unchecked"


def entry(name: str) -> zipfile.ZipInfo:
    """Return a zip entry without a trace of when and by whom it was written."""
    info = zipfile.ZipInfo(name, DATE)
    info.external_attr = 0o644 << 16
    info.create_system = 3
    return info


def compiled(name: str, source: bytes, optimize: int) -> bytes:
    """Return the .pyc of one module."""
    bare = optimize == SMALLEST and name.startswith(OURS)
    tree = without_annotations(source) if bare else source
    code = compile(tree, name, "exec", dont_inherit=True, optimize=optimize)
    if optimize == SMALLEST:
        code = without_lines(code)
    return importlib.util.MAGIC_NUMBER + NO_SOURCE_TO_CHECK + marshal.dumps(code)


def without_annotations(source: bytes) -> ast.Module:
    """The same module without the types of what its functions take and return.

    Those of fields stay: a dataclass is made of them.
    """
    tree = ast.parse(source)
    for one in ast.walk(tree):
        if isinstance(one, ast.arg):
            one.annotation = None
        elif isinstance(one, ast.FunctionDef):
            one.returns = None
    return tree


def without_lines(code: types.CodeType) -> types.CodeType:
    """The same code without its table of lines, which only a traceback would read.

    Where files are made as small as can be a traceback still names modules and functions.
    """
    consts = tuple(without_lines(c) if isinstance(c, types.CodeType) else c for c in code.co_consts)
    return code.replace(co_linetable=b"", co_consts=consts)


def wanted(name: str) -> bool:
    """Whether a wheel's file is used when the package runs: no tests, no headers, no old RECORD."""
    return not ("/tests/" in name or name.endswith(BUILD_ONLY) or is_record(name))


def is_record(name: str) -> bool:
    """Whether this is a wheel's list of its own files."""
    return name.endswith(".dist-info/RECORD")


def record_line(name: str) -> str:
    """The line of RECORD for one file. Its hash is left out, as PEP 376 allows: a page checks
    an archive as a whole, and what is random cannot be packed, 32 bytes a file."""
    return f"{name},,\n"


def compile_archive(data: bytes, optimize: int, wheel: bool) -> bytes:
    """Return the zip `data` with compiled modules; of a `wheel` also trimmed, with a new RECORD."""
    out = io.BytesIO()
    lines = []
    with zipfile.ZipFile(io.BytesIO(data)) as source, zipfile.ZipFile(out, "w") as target:
        names = sorted(name for name in source.namelist() if not name.endswith("/"))
        for name in (n for n in names if wanted(n) or not wheel):
            content = source.read(name)
            is_source = name.endswith(".py")
            packed = compiled(name, content, optimize) if is_source else content
            packed_name = f"{name}c" if is_source else name
            target.writestr(entry(packed_name), packed)
            lines.append(record_line(packed_name))
        for name in filter(is_record, names if wheel else []):
            target.writestr(entry(name), "".join([*lines, record_line(name)]))
    return out.getvalue()
