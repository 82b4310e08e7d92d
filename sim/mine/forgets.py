"""Whether a law can remember anything from one answer to the next, read off its form."""

from __future__ import annotations

import ast


def keeps_nothing(tree: ast.Module) -> bool:
    """Only functions, `math` and numbers outside; nothing outside is changed from within."""
    for one in tree.body:
        number = isinstance(one, (ast.Assign, ast.Expr)) and isinstance(one.value, ast.Constant)
        if not (number or isinstance(one, (ast.FunctionDef, ast.Import, ast.ImportFrom))):
            return False
    for node in ast.walk(tree):
        if isinstance(node, (ast.Global, ast.Nonlocal)):
            return False
        if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            return False
        if isinstance(node, ast.arguments):
            given = [value for value in (*node.defaults, *node.kw_defaults) if value is not None]
            if not all(isinstance(value, ast.Constant) for value in given):
                return False
    return True
