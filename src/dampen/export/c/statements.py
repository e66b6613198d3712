"""Statements of scalar Python as statements of C99."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping

from dampen.export.c.expressions import OPERATORS, Expressions
from dampen.export.c.types import INT, pairs

INDENT = "    "


class Statements:
    """Writes the body of one function. returns: how many numbers it returns; several go out through out0, out1, ..."""

    def __init__(self, expressions: Expressions, arguments: Mapping[str, str], returns: int):
        self.expressions, self.arguments, self.returns = expressions, arguments, returns
        self.in_place: set[str] = set()

    def function(self, tree: ast.FunctionDef) -> list[str]:
        """The body: names given once, and used only after that in the same block, are declared there; the others first."""
        self.in_place = set(given_once(tree))
        loops = {node.target.id for node in ast.walk(tree) if isinstance(node, ast.For) and isinstance(node.target, ast.Name)}
        first = []
        for kind in ("real", "int"):
            names = [
                name
                for name, own in self.expressions.kinds.items()
                if own == kind and name not in self.arguments and name not in self.in_place | loops
            ]
            if names:
                first.append(f"{INDENT}{kind} {', '.join(names)};")
        return [*first, *self.block(tree.body, 1)]

    def block(self, body: Iterable[ast.stmt], depth: int) -> list[str]:
        return [line for statement in body for line in self.statement(statement, depth)]

    def statement(self, node: ast.stmt, depth: int) -> list[str]:
        """One statement, in lines."""
        write, pad = self.expressions, INDENT * depth
        if isinstance(node, ast.Expr):
            if isinstance(node.value, ast.Constant):  # a docstring
                return []
            return [f"{pad}{write(node.value)};"]
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            return [pad + line for line in self.assign(node.targets[0], node.value)]
        if isinstance(node, ast.AugAssign) and type(node.op) in OPERATORS and not isinstance(node.op, ast.Pow):
            whole = write.whole(node.target)
            return [f"{pad}{write(node.target)} {OPERATORS[type(node.op)][0]}= {write(node.value, whole)};"]
        if isinstance(node, ast.If):
            return self.branch(node, depth, "if")
        if isinstance(node, ast.For):
            return [f"{pad}{self.loop(node)} {{", *self.block(node.body, depth + 1), f"{pad}}}"]
        if isinstance(node, ast.While):
            return [f"{pad}while ({write(node.test)}) {{", *self.block(node.body, depth + 1), f"{pad}}}"]
        if isinstance(node, ast.Return):
            return [pad + line for line in self.leave(node.value)]
        if isinstance(node, ast.Break | ast.Continue):
            return [f"{pad}{type(node).__name__.lower()};"]
        if isinstance(node, ast.Pass):
            return []
        raise write.refuse(node)

    def assign(self, target: ast.expr, value: ast.expr) -> list[str]:
        """An assignment; of a tuple one after the other, where no value reads what was written before it."""
        write, parts = self.expressions, pairs(target, value)
        if len(parts) > 1 and isinstance(value, ast.Call):
            raise write.refuse(value)
        for i, (_, later) in enumerate(parts):
            read = {ast.unparse(node) for node in ast.walk(later)}
            if any(ast.unparse(earlier) in read for earlier, _ in parts[:i]):
                raise write.refuse(target)
        lines = []
        for one, given in parts:
            name = one.id if isinstance(one, ast.Name) else ""
            kind = write.kinds.get(name, "real")
            declared = f"const {kind} " if name in self.in_place else ""
            lines.append(f"{declared}{write(one)} = {write(given, kind == INT)};")
        return lines

    def branch(self, node: ast.If, depth: int, word: str) -> list[str]:
        """if, else if, else."""
        pad = INDENT * depth
        lines = [f"{pad}{word} ({self.expressions(node.test)}) {{", *self.block(node.body, depth + 1)]
        if len(node.orelse) == 1 and isinstance(node.orelse[0], ast.If):
            return lines + self.branch(node.orelse[0], depth, "} else if")
        if node.orelse:
            lines += [f"{pad}}} else {{", *self.block(node.orelse, depth + 1)]
        return [*lines, f"{pad}}}"]

    def loop(self, node: ast.For) -> str:
        """`for name in range(...)`."""
        call = node.iter
        if not (
            isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id == "range" and len(call.args) < 3
        ):
            raise self.expressions.refuse(node)
        ends = [self.expressions(argument, whole=True) for argument in call.args]
        first, last = ends if len(ends) == 2 else ("0", ends[0])
        name = self.expressions(node.target, whole=True)
        return f"for (int {name} = {first}; {name} < {last}; {name}++)"

    def leave(self, value: ast.expr | None) -> list[str]:
        """`return`."""
        if value is None:
            return ["return;"]
        if isinstance(value, ast.Tuple):
            return [*(f"*out{i} = {self.expressions(one)};" for i, one in enumerate(value.elts)), "return;"]
        return [f"return {self.expressions(value)};"]


def given_once(tree: ast.FunctionDef) -> Iterable[str]:
    """Names that one plain assignment gives their value, and that are read only later in the same block."""
    reads = count_reads(tree.body)
    stores: dict[str, int] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            stores[node.id] = stores.get(node.id, 0) + 1
    for block in blocks(tree):
        for i, statement in enumerate(block):
            if not isinstance(statement, ast.Assign):
                continue
            after = count_reads(block[i + 1 :])
            for target in (t for whole in statement.targets for t, _ in pairs(whole, statement.value)):
                if isinstance(target, ast.Name) and stores[target.id] == 1 and after.get(target.id, 0) == reads.get(target.id, 0):
                    yield target.id


def blocks(tree: ast.AST) -> Iterable[list[ast.stmt]]:
    """Every list of statements."""
    for node in ast.walk(tree):
        for name in ("body", "orelse"):
            block = getattr(node, name, None)
            if isinstance(block, list):
                yield block


def count_reads(body: Iterable[ast.stmt]) -> dict[str, int]:
    """How often each name is read."""
    reads: dict[str, int] = {}
    for statement in body:
        for node in ast.walk(statement):
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
                reads[node.id] = reads.get(node.id, 0) + 1
    return reads
