"""What the names in a scalar Python function are in C: numbers, whole numbers, arrays, or records of arrays."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping, Sequence

REAL, INT, ARRAY = "real", "int", "array"
WHOLE = (ast.Add, ast.Sub, ast.Mult, ast.FloorDiv, ast.Mod)


def argument_kinds(tree: ast.FunctionDef, passed: Mapping[str, Sequence[str]], given: Mapping[str, str]) -> dict[str, str]:
    """REAL, INT, ARRAY or "record" for every argument, from how it is used; `passed`: the kinds that each function it calls
    takes, `given`: what is known beforehand."""
    kinds = dict.fromkeys((a.arg for a in tree.args.args), REAL)
    for node in ast.walk(tree):
        if isinstance(node, ast.Subscript):
            _note(kinds, node.value, ARRAY)
            for inner in ast.walk(node.slice):
                _note(kinds, inner, INT)
        elif isinstance(node, ast.Attribute):
            _note(kinds, node.value, "record")
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            if node.func.id in ("range", "len"):
                for argument in node.args:
                    _note(kinds, argument, INT if node.func.id == "range" else ARRAY)
            for argument, kind in zip(node.args, passed.get(node.func.id, ()), strict=False):
                if kind != REAL:
                    _note(kinds, argument, kind)
    return {**kinds, **{name: kind for name, kind in given.items() if name in kinds}}


def _note(kinds: dict[str, str], node: ast.AST, kind: str) -> None:
    if isinstance(node, ast.Name) and node.id in kinds:
        kinds[node.id] = kind


def assignments(tree: ast.AST) -> Iterator[tuple[ast.expr, ast.expr]]:
    """(target, value) of every assignment to one thing, tuples taken apart; of `a += b` the value a + b."""
    for node in ast.walk(tree):
        if isinstance(node, ast.AugAssign):
            yield node.target, ast.BinOp(node.target, node.op, node.value)
        elif isinstance(node, ast.Assign):
            for target in node.targets:
                yield from pairs(target, node.value)


def pairs(target: ast.expr, value: ast.expr) -> list[tuple[ast.expr, ast.expr]]:
    """`a, b = x, y` as (a, x), (b, y); with one call on the right, both come from it."""
    if not isinstance(target, ast.Tuple):
        return [(target, value)]
    values = value.elts if isinstance(value, ast.Tuple) else [value] * len(target.elts)
    return list(zip(target.elts, values, strict=True))


def local_kinds(tree: ast.FunctionDef, arguments: Mapping[str, str], whole_calls: Callable[[ast.Call], bool]) -> dict[str, str]:
    """REAL or INT for every local name: whole where everything that it is given is."""
    given: dict[str, list[ast.expr]] = {}
    for target, value in assignments(tree):
        if isinstance(target, ast.Name):
            given.setdefault(target.id, []).append(value)
    kinds = dict.fromkeys(given, INT)
    kinds |= {node.target.id: INT for node in ast.walk(tree) if isinstance(node, ast.For) and isinstance(node.target, ast.Name)}
    while True:
        known = {**arguments, **kinds}
        real = [n for n in given if kinds[n] == INT and not all(is_whole(v, known, whole_calls) for v in given[n])]
        if not real:
            return {name: kind for name, kind in kinds.items() if name not in arguments}
        kinds |= dict.fromkeys(real, REAL)


def is_whole(node: ast.expr, kinds: Mapping[str, str], whole_calls: Callable[[ast.Call], bool]) -> bool:
    """Whether an expression is a whole number in C as it is in Python."""
    if isinstance(node, ast.Constant):
        return isinstance(node.value, int)
    if isinstance(node, ast.Name):
        return kinds.get(node.id) == INT
    if isinstance(node, ast.UnaryOp):
        return isinstance(node.op, ast.Not) or is_whole(node.operand, kinds, whole_calls)
    if isinstance(node, ast.BinOp):
        both = is_whole(node.left, kinds, whole_calls) and is_whole(node.right, kinds, whole_calls)
        return both and isinstance(node.op, WHOLE)
    if isinstance(node, ast.Compare | ast.BoolOp):
        return True
    return isinstance(node, ast.Call) and whole_calls(node)
