"""Puts bounds into a law's operators: what could grow beyond all memory is looked at before.

`x ** y`, `x << y`, `x * y`, `x + y` and `x % y` become calls (`sim.mine.growing`); `x *= y` becomes
`x *= _fits("*", x, y)`, so that what it changes in place stays the same object; `[*x, *y]` becomes
`_few([*x, *y])` and `f"{x}"` becomes `f"{_told(x)}"`. What holds a float cannot grow and is left as
it stands: that is nearly all of a force, which costs nothing then.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from copy import deepcopy
from typing import Any

from sim.mine.arguments import ARGUMENTS
from sim.mine.growing import OPERATORS, few, fits, told

NAMES = {"**": "_power", "<<": "_shifted", "*": "_times", "+": "_plus", "%": "_rest"}
SIGNS: dict[type[ast.operator], str] = {
    ast.Pow: "**", ast.LShift: "<<", ast.Mult: "*", ast.Add: "+", ast.Mod: "%",
}  # fmt: skip
FITS, FEW, TOLD, BASE, PLACE = "_fits", "_few", "_told", "_base", "_place"
PUT_IN: dict[str, Callable[..., Any]] = {
    FITS: fits,
    FEW: few,
    TOLD: told,
    **{NAMES[sign]: both for sign, both in OPERATORS.items()},
}
"""What the law's text calls now. Its author's names have no underscore in front."""

KEEPS = (ast.Add, ast.Sub, ast.Mult, ast.Div, ast.FloorDiv, ast.Pow)
"""With a float on one side they give a float, or refuse: no long list, no large whole number."""

WORDS = ("name_self", "name_other", "side")
"""Arguments that are texts."""


class Bounded(ast.NodeTransformer):
    """For one law."""

    def __init__(self, tree: ast.Module) -> None:
        nodes = list(ast.walk(tree))
        given = [n.arg for n in nodes if isinstance(n, ast.arg)]
        changed = {n.id for n in nodes if isinstance(n, ast.Name) and n.ctx.__class__ is ast.Store}
        forces = [n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == "force"]
        asked = [n.args for n in forces[-1:] if not n.args.defaults]
        names = {one.arg for arguments in asked for one in arguments.args}
        numbers = names & set(ARGUMENTS) - set(WORDS) - changed
        self.floats = {name for name in numbers if given.count(name) == 1}

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        """`a * b` becomes `_times(a, b)`."""
        sign = self._grows(node.op, node.left, node.right)
        self.generic_visit(node)
        return _call(NAMES[sign], node, node.left, node.right) if sign else node

    def visit_AugAssign(self, node: ast.AugAssign) -> ast.AST | list[ast.AST]:
        """`a[f()] *= b` becomes `_base = a`, `_place = f()`, `_base[_place] *= _fits(…, b)`."""
        target = node.target
        sign = self._grows(node.op, target, node.value)
        self.generic_visit(node)
        if not sign:
            return node
        before: list[ast.AST] = []
        if not isinstance(target, ast.Name):
            before.append(_assign(BASE, target.value, node))
            target.value = ast.Name(BASE, ast.Load())
        if isinstance(target, ast.Subscript):
            before.append(_assign(PLACE, target.slice, node))
            target.slice = ast.Name(PLACE, ast.Load())
        now = deepcopy(target)
        now.ctx = ast.Load()
        node.value = _call(FITS, node, ast.Constant(sign), now, node.value)
        return [*before, node]

    def visit_List(self, node: ast.List | ast.Set | ast.Tuple) -> ast.AST:
        """`[*a, *a]` becomes `_few([*a, *a])`; `first, *rest = a` is none of these."""
        self.generic_visit(node)
        starred = any(isinstance(one, ast.Starred) for one in node.elts)
        made = isinstance(node, ast.Set) or isinstance(node.ctx, ast.Load)
        return _call(FEW, node, node) if starred and made else node

    visit_Set = visit_Tuple = visit_List  # noqa: N815 - names of ast

    def visit_FormattedValue(self, node: ast.FormattedValue) -> ast.AST:
        """`f"{a}"` becomes `f"{_told(a)}"`."""
        self.generic_visit(node)
        node.value = _call(TOLD, node, node.value)
        return node

    def _grows(self, op: ast.operator, left: ast.expr, right: ast.expr) -> str:
        """The operator's sign, if what comes out may be larger than both."""
        sign = SIGNS.get(type(op), "")
        if self._float(left) or (self._float(right) and sign != "%"):
            return ""
        number = sign == "+" and (_number(left) or _number(right))
        return "" if number else sign

    def _float(self, node: ast.expr) -> bool:
        """Surely one."""
        if isinstance(node, ast.BinOp) and isinstance(node.op, KEEPS):
            div = isinstance(node.op, ast.Div)
            return div or self._float(node.left) or self._float(node.right)
        if isinstance(node, ast.UnaryOp):
            return isinstance(node.op, (ast.USub, ast.UAdd)) and self._float(node.operand)
        if isinstance(node, ast.Name):
            return node.id in self.floats
        return isinstance(node, ast.Constant) and isinstance(node.value, float)


def _number(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, (int, float))


def _call(name: str, at: ast.AST, *values: ast.expr) -> ast.expr:
    return ast.copy_location(ast.Call(ast.Name(name, ast.Load()), list(values), []), at)


def _assign(name: str, value: ast.expr, at: ast.AST) -> ast.AST:
    return ast.copy_location(ast.Assign([ast.Name(name, ast.Store())], value), at)
