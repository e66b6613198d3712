"""Scalar Python functions, those that the kernel compiles, as C99: one source for each equation.

What can be written: assignment, if, for over a range, while, arithmetic, comparisons, conditional expressions, min, max, abs, the
functions of math, array elements, and calls of other such functions, which come along. Everything else is refused.
"""

from __future__ import annotations

import ast
import inspect
import textwrap
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from types import FunctionType
from typing import Any

from dampen.component import ArgumentError
from dampen.export.c.expressions import Expressions, whole_globals
from dampen.export.c.statements import Statements
from dampen.export.c.types import ARRAY, INT, REAL, argument_kinds, assignments, local_kinds

# names that mean something else in C
WORDS = """
auto break case char const continue default do double else enum extern float for goto if inline int long register restrict return
short signed sizeof static struct switch typedef union unsigned void volatile while real least most squared
"""
TAKEN = frozenset(WORDS.split())


@dataclass(frozen=True)
class CFunction:
    """A function in C: its name there, the kinds of its arguments, its text, and how many numbers it returns."""

    name: str
    kinds: tuple[str, ...]
    text: str
    returns: int


class Translator:
    """Translates functions and all that they call; each once, callees first.

    lengths: what `len(name)` is; kinds: arguments whose kind is known by name; single: float for double.
    """

    def __init__(self, lengths: Mapping[str, str] = {}, kinds: Mapping[str, str] = {}, single: bool = False):
        self.lengths, self.kinds, self.single = lengths, kinds, single
        self.done: dict[str, tuple[Any, CFunction]] = {}

    def add(self, function: Callable[..., Any]) -> CFunction:
        """Translate a function, unless that has been done."""
        assert isinstance(function, FunctionType)
        name, code = function.__name__, function.__code__
        if name in self.done:
            if self.done[name][0] is not code:
                raise ArgumentError(f"Function `{name}` would stand for two things in C.")
            return self.done[name][1]
        tree = source_tree(function)
        callees = {n: self.add(f) for n in code.co_names if isinstance(f := function.__globals__.get(n), FunctionType)}
        written = self._write(function, tree, callees)
        self.done[name] = code, written
        return written

    @property
    def text(self) -> str:
        """All functions, callees first."""
        return "\n\n".join(function.text for _, function in self.done.values())

    def _write(self, function: FunctionType, tree: ast.FunctionDef, callees: Mapping[str, CFunction]) -> CFunction:
        passed = {name: callee.kinds for name, callee in callees.items()}
        arguments = argument_kinds(tree, passed, self.kinds)
        known = {**whole_globals(function.__globals__), **arguments}
        kinds = {**arguments, **local_kinds(tree, known, Expressions.is_whole_call)}
        called = {name: callee.name for name, callee in callees.items()}
        where = f"{function.__module__}.{function.__name__}"
        expressions = Expressions(where, kinds, function.__globals__, self.single, self.lengths, called)
        taken = sorted(TAKEN & set(kinds))
        if taken:
            raise ArgumentError(f"Function `{where}` has {taken[0]!r} as a name, which cannot be written in C.")
        returns = returned(tree)
        body = Statements(expressions, arguments, returns).function(tree)
        unused = sorted(set(arguments) - {n.id for n in ast.walk(tree) if isinstance(n, ast.Name)})
        if body[-1:] == ["    return;"]:
            body.pop()
        lines = [*(f"    (void){name};" for name in unused), *body]
        head = f"static {'real' if returns == 1 else 'void'} {tree.name}({parameters(tree, arguments, returns)})"
        text = "\n".join([*comment(tree), head, "{", *lines, "}"])
        return CFunction(tree.name, tuple(arguments.values()), text, returns)


def source_tree(function: FunctionType) -> ast.FunctionDef:
    """The syntax tree of a function."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(function))).body[0]
    assert isinstance(tree, ast.FunctionDef)
    return tree


def returned(tree: ast.FunctionDef) -> int:
    """How many numbers a function returns."""
    values = [node.value for node in ast.walk(tree) if isinstance(node, ast.Return) and node.value is not None]
    return max((len(v.elts) if isinstance(v, ast.Tuple) else 1 for v in values), default=0)


def parameters(tree: ast.FunctionDef, kinds: Mapping[str, str], returns: int) -> str:
    """The parameter list; what is only read is const, and several results go out through pointers."""
    written = {base(target) for target, _ in assignments(tree) if not isinstance(target, ast.Name)}
    declared = []
    for name, kind in kinds.items():
        const = "" if name in written else "const "
        declared.append({REAL: f"real {name}", INT: f"int {name}", ARRAY: f"{const}real *{name}"}.get(kind, ""))
        if not declared[-1]:
            declared[-1] = f"const struct {name} *{name}"
    outputs = [f"real *out{i}" for i in range(returns)] if returns > 1 else []
    return ", ".join([*declared, *outputs])


def base(node: ast.expr) -> str:
    """The name at the root of `name[...]` or `name.field[...]`."""
    while isinstance(node, ast.Subscript | ast.Attribute):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""


def comment(tree: ast.FunctionDef) -> Iterable[str]:
    """The docstring as a comment."""
    text = ast.get_docstring(tree)
    if not text:
        return []
    first, *rest = text.replace("*/", "* /").splitlines()
    if not rest:
        return [f"/* {first} */"]
    return [f"/* {first}", *(f" * {line}".rstrip() for line in rest), " */"]
