"""Which Python a law may use, and loops that cannot run for ever.

A law is arithmetic: numbers, lists, functions, conditions, loops, `math`. What is left out is left
out by its form, before anything runs: other modules, files, classes, names with an underscore in
front. Every loop, every comprehension and every function gets a line that counts, so that a loop
without an end is told with its number instead of waited for; what could grow beyond all memory at
one stroke has bounds (`sim.mine.bounded`). This keeps accidents away from a reader, and from a
teacher who judges a student's file; it is no wall against somebody who wants in.
"""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterator

from sim.mine.bounded import Bounded
from sim.mine.growing import WIDE
from sim.mine.wrong import WrongLawError
from sim.scene.said import said

LONGEST = 20_000
"""Characters of a law: what an answer may have."""

BUILTINS = (
    *("abs", "bool", "dict", "divmod", "enumerate", "float", "int", "isinstance", "len", "list"),
    *("map", "max", "min", "pow", "print", "range", "reversed", "round", "set", "sorted", "str"),
    *("sum", "tuple", "zip", "ValueError"),
)
"""Functions of Python that a law may call; `print` is there and writes nothing."""

REFUSED: tuple[tuple[type[ast.AST], str], ...] = (
    (ast.ClassDef, "class"),
    (ast.Try, "try"),
    (ast.TryStar, "try"),
    (ast.With, "with"),
    (ast.AsyncFunctionDef, "async"),
    (ast.AsyncFor, "async"),
    (ast.AsyncWith, "async"),
    (ast.Await, "await"),
    (ast.Yield, "yield"),
    (ast.YieldFrom, "yield"),
)
"""A loop inside of these could swallow the counting; none of them is arithmetic."""

GROWING = (
    *("center", "encode", "expandtabs", "extend", "join", "ljust", "replace", "rjust"),
    *("to_bytes", "translate", "zfill"),
)
"""Methods that make a text or list of any length at one stroke, or bytes, which no bound knows."""

COUNT, RESULT = "_count", "_result"
"""Names of what is put into a law; its author's names have no underscore in front."""


def clean(text: str) -> str:
    """Without the mark and the line ends that some editors write."""
    return text.removeprefix("\ufeff").replace("\r\n", "\n")


def parsed(text: str, file: str) -> ast.Module:
    """The law's tree, looked through and with its counting lines; raises `WrongLawError`."""
    if len(text) > LONGEST:
        raise WrongLawError(
            file, 1, said("this is longer than a law can be"),
            said("at most {count} characters", count=str(LONGEST)),
        )  # fmt: skip
    try:
        tree = ast.parse(clean(text), file)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        line = getattr(error, "lineno", None) or 1
        why = getattr(error, "msg", None) or str(error)
        hint = said("look at this line, and at the one above it")
        raise WrongLawError(file, line, said("this is not Python: {why}", why=why), hint) from None
    for fault in _faults(tree, file):
        raise fault
    try:
        counted: ast.Module = _Counted().visit(Bounded(tree).visit(tree))
        return ast.fix_missing_locations(counted)
    except RecursionError:
        raise WrongLawError(file, 1, said("this is longer than a law can be")) from None


def _faults(tree: ast.Module, file: str) -> Iterator[WrongLawError]:
    """What a law may not hold, in the order of its lines."""
    nodes = [node for node in ast.walk(tree) if hasattr(node, "lineno")]
    nodes.sort(key=lambda node: node.lineno)
    for node in nodes:
        for kind, word in REFUSED:
            if isinstance(node, kind):
                message = said("a law needs no “{word}”", word=word)
                yield WrongLawError(file, node.lineno, message, said("numbers, if, for and def do"))
        for module in _modules(node):
            if module != "math":
                message = said("a law cannot import “{name}”", name=module)
                hint = said("only the module math is there: import math")
                yield WrongLawError(file, node.lineno, message, hint)
        wide = _wide(node)
        if wide:
            message = said("a law cannot use “{name}”", name=wide)
            yield WrongLawError(file, node.lineno, message, said("numbers, if, for and def do"))
        name = _name(node)
        if name.startswith("_") or (isinstance(node, ast.Attribute) and "format" in name):
            message = said("a law cannot use “{name}”", name=name)
            hint = said("choose a name without an underscore in front")
            yield WrongLawError(file, node.lineno, message, hint)
        loads = isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
        if loads and hasattr(builtins, name) and name not in (*BUILTINS, *_made(tree)):
            message = said("a law cannot use “{name}”", name=name)
            hint = said("it may use {names}", names=", ".join(BUILTINS))
            yield WrongLawError(file, node.lineno, message, hint)


def _wide(node: ast.AST) -> str:
    """What makes a text or a list as long as it is told, at one stroke."""
    if isinstance(node, ast.Attribute) and node.attr in GROWING:
        return node.attr
    if isinstance(node, ast.Constant) and isinstance(node.value, bytes):
        return "b''"
    if isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Store):
        return "[:] =" if isinstance(node.slice, ast.Slice) else ""
    spec = node.format_spec if isinstance(node, ast.FormattedValue) else None
    parts = spec.values if isinstance(spec, ast.JoinedStr) else []
    shown = "".join(str(p.value) if isinstance(p, ast.Constant) else "{*}" for p in parts)
    return f":{shown}" if WIDE.search(shown) else ""


def _modules(node: ast.AST) -> list[str]:
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    return [node.module or "."] if isinstance(node, ast.ImportFrom) else []


def _name(node: ast.AST) -> str:
    for field in ("attr", "id", "arg", "name"):
        value = getattr(node, field, None)
        if isinstance(value, str):
            return value
    return ""


def _made(tree: ast.Module) -> set[str]:
    """Names that the law gives itself: arguments, functions, what is on the left of =."""
    stored = {
        n.id for n in ast.walk(tree) if isinstance(n, ast.Name) and n.ctx.__class__ is ast.Store
    }
    return stored | {
        _name(node) for node in ast.walk(tree) if isinstance(node, (ast.arg, ast.FunctionDef))
    }


class _Counted(ast.NodeTransformer):
    """Puts the counting into loops and functions, and a look at its result into every return."""

    def _count(self, node: ast.AST) -> ast.Expr:
        return ast.copy_location(ast.Expr(self._call(COUNT, node)), node)

    def _call(self, name: str, node: ast.AST) -> ast.expr:
        line = ast.Constant(getattr(node, "lineno", 1))
        return ast.copy_location(ast.Call(ast.Name(name, ast.Load()), [line], []), node)

    def _loop(self, node: ast.For | ast.While | ast.FunctionDef) -> ast.AST:
        self.generic_visit(node)
        node.body.insert(0, self._count(node))
        return node

    visit_For = visit_While = visit_FunctionDef = _loop  # noqa: N815 - names of ast

    def visit_comprehension(self, node: ast.comprehension) -> ast.AST:
        """`_count` gives True: one more condition of what is gone through."""
        self.generic_visit(node)
        node.ifs.insert(0, self._call(COUNT, node.target))
        return node

    def visit_Lambda(self, node: ast.Lambda) -> ast.AST:
        """One that calls itself twice would go on for ever: `_count` gives True, and it goes on."""
        self.generic_visit(node)
        node.body = ast.copy_location(
            ast.BoolOp(ast.And(), [self._call(COUNT, node), node.body]), node.body
        )
        return node
