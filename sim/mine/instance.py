"""From the text of a law to a function that answers with N, or says at which line it went wrong.

A law may remember things (a list, a `global`): that is one of the ways to break physics. So each
run gets an instance of its own, made anew from the text, and knows nothing of other runs.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import CodeType
from typing import Any

from sim.mine.allowed import BUILTINS, COUNT, RESULT, clean, parsed
from sim.mine.arguments import ARGUMENTS, PLACES
from sim.mine.bounded import PUT_IN
from sim.mine.forgets import keeps_nothing
from sim.mine.growing import (
    OPERATORS,
    BoundedText,
    bounded_math,
    bounded_range,
    bounded_round,
    bounded_sum,
)
from sim.mine.wrong import EndlessError, WrongLawError
from sim.scene.problem import nearest
from sim.scene.reading.written import EXAMPLE, NO_FORCE
from sim.scene.said import said

MOST_TURNS = 20_000
"""Turns of all loops in one answer. A spring needs none, a sum over a table some hundred."""


LARGEST = 1e100
"""N. With more than that neither velocities nor energies would stay numbers."""


@dataclass(frozen=True, slots=True)
class Written:
    """A law as it was written: its file's name, its text, what `force` asks for, and the line.

    `forgets`: nothing in it can outlive one answer, so that equal questions have equal answers.
    """

    file: str
    text: str
    wants: tuple[str, ...]
    line: int
    forgets: bool
    code: CodeType


@lru_cache(maxsize=32)
def read_law(text: str, file: str = "mine.py") -> Written:
    """Look a law through; raises `WrongLawError`."""
    tree = parsed(text, file)
    found = [n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == "force"]
    if not found:
        raise _no_force(file, 1)
    force = found[-1]
    given = force.args
    if given.vararg or given.kwarg or given.kwonlyargs:
        message = said("the arguments of force are plain names, without *")
        raise WrongLawError(file, force.lineno, message, EXAMPLE)
    names = [one.arg for one in (*given.posonlyargs, *given.args)]
    asked = names[: len(names) - len(given.defaults)] if given.defaults else names
    for name in asked:
        if name not in PLACES:
            near = nearest(name, PLACES)
            hint = said("it may ask for {names}", names=", ".join(ARGUMENTS))
            if near:
                hint = said("did you mean {name}?", name=f"“{near}”")
            message = said("force cannot be given “{name}”", name=name)
            raise WrongLawError(file, force.lineno, message, hint)
    forgets = keeps_nothing(ast.parse(clean(text), file))
    _Returns().visit(force)
    code = compile(ast.fix_missing_locations(tree), file, "exec")
    written = Written(file, text, tuple(asked), force.lineno, forgets, code)
    Instance(written)  # its outer lines may be wrong, too
    return written


def _no_force(file: str, line: int) -> WrongLawError:
    hint = said("begin with {example}", example=EXAMPLE)
    return WrongLawError(file, line, NO_FORCE, hint)


class _Returns(ast.NodeTransformer):
    """Looks at what `force` returns, at the line of its return; not at functions inside of it."""

    depth = 0

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        """`force` itself, and what is defined in it."""
        if self.depth:
            return node
        self.depth = 1
        return self.generic_visit(node)

    def visit_Lambda(self, node: ast.Lambda) -> ast.AST:
        """Left alone."""
        return node

    def visit_Return(self, node: ast.Return) -> ast.AST:
        """`return x` becomes `return _result(x, line)`."""
        value = node.value or ast.copy_location(ast.Constant(None), node)
        line = ast.Constant(node.lineno)
        call = ast.Call(ast.Name(RESULT, ast.Load()), [value, line], [])
        node.value = ast.copy_location(call, node)
        return node


class Instance:
    """One life of a law. `calls` counts what it was asked."""

    def __init__(self, written: Written) -> None:
        self.written, self.calls, self.turns = written, 0, 0
        self._places = [PLACES[name] for name in written.wants]
        names: dict[str, Any] = {
            "__builtins__": _builtins(),
            COUNT: self._count,
            RESULT: self._result,
            **PUT_IN,
        }
        try:
            exec(written.code, names)
        except (Exception, EndlessError) as error:
            raise self._told(error) from None
        force = names.get("force")
        if not callable(force):  # taken away again, or another thing of that name
            raise _no_force(written.file, written.line)
        self._force: Callable[..., Any] = force

    def ask(self, row: Sequence[Any]) -> float:
        """N on the side that asks; `row` holds all of `ARGUMENTS` in their order."""
        self.calls += 1
        self.turns = 0
        try:
            answer = self._force(*[row[place] for place in self._places])
        except (Exception, EndlessError) as error:
            raise self._told(error) from None
        if answer is None:
            hint = said("end it with a line like: return stiffness * overlap")
            message = said("force came to its end without a return")
            raise WrongLawError(self.written.file, self.written.line, message, hint)
        return answer  # type: ignore[no-any-return]

    def _told(self, error: BaseException) -> WrongLawError:
        """Whatever went wrong inside of the law, with its line."""
        if isinstance(error, WrongLawError):
            return error
        if isinstance(error, EndlessError):
            count = str(MOST_TURNS)
            message = said("this goes on and on, for more than {count} turns", count=count)
            hint = said("a force is asked for one instant, so it needs no loop that waits")
            return WrongLawError(self.written.file, error.line, message, hint)
        message = said("{kind}: {why}", kind=type(error).__name__, why=str(error))
        line = _line_of(error, self.written.file) or self.written.line
        return WrongLawError(self.written.file, line, message, _help(error))

    def _count(self, line: int) -> bool:
        self.turns += 1
        if self.turns > MOST_TURNS:
            raise EndlessError(line)
        return True

    def _result(self, value: Any, line: int) -> float:
        if type(value) is float and -LARGEST < value < LARGEST:
            return value
        file = self.written.file
        if isinstance(value, complex):
            hint = said("a root or power of a number below 0 is none: use max(0, …) in it")
            raise WrongLawError(file, line, said("the force is a complex number"), hint)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            message = said("the force must be a number, and this is {kind}", kind=_kind(value))
            raise WrongLawError(file, line, message, said("return one number, in N"))
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if not math.isfinite(number):
            message = said("the force is no number that can be computed with: {value}",
                           value=str(number))  # fmt: skip
            hint = said("look for inf − inf, 0 · inf, or a number beyond all bounds")
            raise WrongLawError(file, line, message, hint)
        if abs(number) >= LARGEST:
            raise too_large(self.written, line, number)
        return number


def too_large(written: Written, line: int, force: float) -> WrongLawError:
    """Of so many N."""
    message = said("the force is too large to be computed with: {force}", force=f"{force:.3g} N")
    return WrongLawError(written.file, line, message, said("bumpers push with some newtons"))


def _kind(value: Any) -> str:
    return "None" if value is None else type(value).__name__


def _help(error: BaseException) -> str:
    if isinstance(error, ZeroDivisionError):
        return said("overlap and rate are 0 when two carts just touch, or are deepest")
    if isinstance(error, RecursionError):
        return said("a function that calls itself has to stop some time")
    return ""


def _line_of(error: BaseException, file: str) -> int | None:
    """The deepest line of the law itself."""
    line, trace = None, error.__traceback__
    while trace is not None:
        if trace.tb_frame.f_code.co_filename == file:
            line = trace.tb_lineno
        trace = trace.tb_next
    return line


def _builtins() -> dict[str, Any]:
    """Those of `BUILTINS`, and the one import."""
    import builtins

    names = {name: getattr(builtins, name) for name in BUILTINS}
    bounded = bounded_math()

    def only_math(name: str, *_: Any) -> Any:
        assert name == "math"  # `allowed` has refused all others
        return bounded

    return names | {
        "print": lambda *_, **__: None,
        "range": bounded_range,
        "round": bounded_round,
        "str": BoundedText,
        "sum": bounded_sum,
        "pow": OPERATORS["**"],
        "__import__": only_math,
    }
