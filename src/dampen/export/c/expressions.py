"""Expressions of scalar Python as expressions of C99, in the same order of operations, so that they round alike."""

from __future__ import annotations

import ast
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from dampen.component import ArgumentError
from dampen.export.c.numbers import literal
from dampen.export.c.types import INT, is_whole

ATOM, UNARY, PRODUCT, SUM, ORDER, LOOSE = 9, 8, 7, 6, 5, 1
OPERATORS: dict[type[ast.AST], tuple[str, int]] = {
    ast.Add: ("+", SUM), ast.Sub: ("-", SUM), ast.Mult: ("*", PRODUCT), ast.Div: ("/", PRODUCT),
    ast.Lt: ("<", ORDER), ast.LtE: ("<=", ORDER), ast.Gt: (">", ORDER), ast.GtE: (">=", ORDER),
    ast.Eq: ("==", ORDER), ast.NotEq: ("!=", ORDER),
}  # fmt: skip
# what <math.h> calls the functions of Python's math and numpy
MATH = {
    name: name for name in ("sin", "cos", "tan", "atan", "atan2", "exp", "expm1", "log", "log1p", "sqrt", "floor", "copysign")
}
NUMPY = {"minimum": "least", "maximum": "most", "abs": "fabs"}
BUILTINS = {"min": "least", "max": "most", "abs": "fabs"}
OWN = ("least", "most", "squared")


@dataclass
class Expressions:
    """Writes the expressions of one function. kinds: of its names; globals: what names outside mean; single: in float;
    lengths: what `len` of an array is; called: the functions of Python's that it has met, by name."""

    where: str
    kinds: Mapping[str, str]
    globals: Mapping[str, Any]
    single: bool
    lengths: Mapping[str, str]
    called: Mapping[str, str]

    def __call__(self, node: ast.expr, whole: bool = False) -> str:
        """An expression as text; `whole`: where C wants an int."""
        return self.write(node, whole)[0]

    def write(self, node: ast.expr, whole: bool = False) -> tuple[str, int]:
        """The text, and how tightly it binds."""
        method = getattr(self, f"_{type(node).__name__}", None)
        if method is None:
            raise self.refuse(node)
        return method(node, whole)

    def within(self, node: ast.expr, level: int, whole: bool = False) -> str:
        """The text as an operand of something that binds with `level`."""
        text, own = self.write(node, whole)
        return text if own >= level else f"({text})"

    def refuse(self, node: ast.AST) -> ArgumentError:
        return ArgumentError(f"Function `{self.where}` has {ast.unparse(node)!r}, which cannot be written in C.")

    def whole(self, node: ast.expr) -> bool:
        return is_whole(node, {**whole_globals(self.globals), **self.kinds}, self.is_whole_call)

    @staticmethod
    def is_whole_call(node: ast.Call) -> bool:
        return isinstance(node.func, ast.Name) and node.func.id in ("len", "int")

    def _Constant(self, node: ast.Constant, whole: bool) -> tuple[str, int]:
        if whole or isinstance(node.value, bool):
            return str(int(node.value)), ATOM  # type: ignore[arg-type]
        return literal(node.value, self.single), ATOM  # type: ignore[arg-type]

    def _Name(self, node: ast.Name, whole: bool) -> tuple[str, int]:
        if node.id in self.kinds:
            return node.id, ATOM
        value = self.globals.get(node.id)
        if not isinstance(value, int | float):
            raise self.refuse(node)
        return (str(value) if whole else literal(value, self.single)), ATOM

    def _Attribute(self, node: ast.Attribute, whole: bool) -> tuple[str, int]:
        if isinstance(node.value, ast.Name):
            if self.globals.get(node.value.id) is math:
                return literal(getattr(math, node.attr), self.single), ATOM
            return f"{node.value.id}->{node.attr}", ATOM
        raise self.refuse(node)

    def _Subscript(self, node: ast.Subscript, whole: bool) -> tuple[str, int]:
        return f"{self.within(node.value, ATOM)}[{self(node.slice, whole=True)}]", ATOM

    def _UnaryOp(self, node: ast.UnaryOp, whole: bool) -> tuple[str, int]:
        sign = {ast.USub: "-", ast.UAdd: "+", ast.Not: "!"}.get(type(node.op))
        if sign is None:
            raise self.refuse(node)
        return f"{sign}{self.within(node.operand, ATOM, whole)}", UNARY

    def _BinOp(self, node: ast.BinOp, whole: bool) -> tuple[str, int]:
        if isinstance(node.op, ast.Pow):
            if isinstance(node.right, ast.Constant) and node.right.value == 2:
                return f"squared({self(node.left)})", ATOM
            raise self.refuse(node)
        if type(node.op) not in OPERATORS:
            raise self.refuse(node)
        sign, level = OPERATORS[type(node.op)]
        whole = self.whole(node) and not isinstance(node.op, ast.Div)
        left, right = self._operand(node.left, level, whole), self._operand(node.right, level + 1, whole)
        return f"{left} {sign} {right}", level

    def _operand(self, node: ast.expr, level: int, whole: bool) -> str:
        """An operand; a whole variable among reals is cast, so that 1 / n is what it is in Python."""
        if whole or isinstance(node, ast.Constant) or not self.whole(node):
            return self.within(node, level, whole)
        return f"(real){self.within(node, ATOM, whole=True)}"

    def _Compare(self, node: ast.Compare, whole: bool) -> tuple[str, int]:
        values, parts = [node.left, *node.comparators], []
        for sign, left, right in zip(node.ops, values, values[1:], strict=False):
            both = self.whole(left) and self.whole(right)
            parts.append(f"{self.within(left, SUM, both)} {OPERATORS[type(sign)][0]} {self.within(right, SUM, both)}")
        return (parts[0], ORDER) if len(parts) == 1 else (" && ".join(parts), LOOSE)

    def _BoolOp(self, node: ast.BoolOp, whole: bool) -> tuple[str, int]:
        sign = " && " if isinstance(node.op, ast.And) else " || "
        return sign.join(self.within(value, ORDER) for value in node.values), LOOSE

    def _IfExp(self, node: ast.IfExp, whole: bool) -> tuple[str, int]:
        branches = f"{self.within(node.body, SUM, whole)} : {self.within(node.orelse, SUM, whole)}"
        return f"{self.within(node.test, ORDER)} ? {branches}", LOOSE

    def _Call(self, node: ast.Call, whole: bool) -> tuple[str, int]:
        name, function = self._called(node)
        if name == "len":
            return self._length(node.args[0]), ATOM
        if name == "int":
            return f"(int){self.within(node.args[0], ATOM)}", UNARY
        if function in MATH.values() or function == "fabs":
            function += "f" if self.single else ""
        elif function not in OWN and name not in self.called:
            raise self.refuse(node)
        return f"{function}({', '.join(self(a, self._wants_whole(a)) for a in node.args)})", ATOM

    def _wants_whole(self, node: ast.expr) -> bool:
        return isinstance(node, ast.Name) and self.kinds.get(node.id) == INT

    def _called(self, node: ast.Call) -> tuple[str, str]:
        """The name in Python, and that in C."""
        if isinstance(node.func, ast.Name):
            name = node.func.id
            return name, self.called.get(name) or BUILTINS.get(name, name)
        if isinstance(node.func, ast.Attribute) and isinstance(node.func.value, ast.Name):
            module = getattr(self.globals.get(node.func.value.id), "__name__", "")
            table = {"math": MATH, "numpy": NUMPY}.get(module, {})
            if node.func.attr in table:
                return node.func.attr, table[node.func.attr]
        raise self.refuse(node)

    def _length(self, node: ast.expr) -> str:
        name = ast.unparse(node)
        if name not in self.lengths:
            raise self.refuse(node)
        return self.lengths[name]


def whole_globals(names: Mapping[str, Any]) -> dict[str, str]:
    """INT for every name outside the function that means a whole number."""
    return {name: INT for name, value in names.items() if type(value) is int}
