"""Components: frozen dataclasses whose parameters carry their unit, range and meaning.

Every plant, actuator, disturbance and controller is a :class:`Component`. A parameter is declared once::

    tip_mass: Annotated[float, Ge(0), Unit("kg"), Doc("payload mass M at the tip")] = 0.1

and that one line serves the check at the door, the scenario file, `dampen list` and the generated reference.
"""

from __future__ import annotations

import dataclasses
import difflib
import re
from abc import ABC
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import MISSING, dataclass, fields
from functools import cache
from math import isfinite
from numbers import Integral, Real
from types import UnionType
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Union, get_args, get_origin, get_type_hints

from annotated_types import Ge, Gt, Le, Lt, Unit
from typing_extensions import Doc

if TYPE_CHECKING:
    from pydantic import BaseModel

LONGEST_LINE = 1000
LEAST_KIN = 4  # letters of a word that means something as a part of another one
LEAST, MOST = 1e-50, 1e50  # sizes of numbers: beyond, squares and fourth powers of them leave what a double can hold
_BOUNDS = ((Gt, "gt", ">"), (Ge, "ge", ">="), (Lt, "lt", "<"), (Le, "le", "<="))
_TYPES = {
    "float_type": "a number",
    "float_parsing": "a number",
    "int_type": "a whole number",
    "int_from_float": "a whole number",
    "bool_type": "true or false",
    "string_type": "a string",
    "finite_number": "a finite number",
    "tuple_type": "a list",
    "dict_type": "a table",
}


NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
UNIT = r"(?:[^\W\d_]|[%°])[\w/^*%° .-]*"
WITH_UNIT = re.compile(f"{NUMBER} *{UNIT}")  # text that was to be a number: 150g, 5 mm, 30 %


class InFile:
    """Marks a parameter that names a file: a scenario file means it relative to its own folder."""


class ArgumentError(ValueError):
    """One or more arguments are wrong; each line of the message says which, what it must be and what it was."""

    def __init__(self, lines: str | Iterable[str]):
        self.lines = [on_one_line(line) for line in ([lines] if isinstance(lines, str) else lines)]
        super().__init__("\n".join(self.lines))

    def under(self, prefix: str) -> ArgumentError:
        """The same complaint, seen from the table that holds the component."""
        return ArgumentError([line.replace("Argument `", f"Argument `{prefix}.", 1) for line in self.lines])


def on_one_line(text: str) -> str:
    """`text` as a terminal can show it, whatever names and files have put into it: no control characters, and not endless."""
    text = "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text[:LONGEST_LINE])
    return text if len(text) < LONGEST_LINE else text[: LONGEST_LINE - 3] + "..."


def wrong(name: str, must: str, value: object) -> ArgumentError:
    """The one form that a complaint about an argument takes."""
    return ArgumentError(f"Argument `{name}` must {must}, but is {shown(value)}.")


def is_whole(value: object) -> bool:
    """Whether a value is a whole number, of Python's or NumPy's; True and False are none."""
    return isinstance(value, Integral) and not isinstance(value, bool)


def is_number(value: object) -> bool:
    """Whether a value is a finite number, of Python's or NumPy's; True and False are none."""
    try:
        return isinstance(value, Real) and not isinstance(value, bool) and isfinite(value)
    except OverflowError:  # a whole number beyond all that a double holds
        return False


def check_order(lower: str, low: float, upper: str, high: float) -> None:
    """Raise ArgumentError unless the argument `lower` is below the argument `upper`."""
    if low >= high:
        raise ArgumentError(f"Argument `{lower}` must be < `{upper}`, but is {low:g} where `{upper}` is {high:g}.")


def own_name(thing: Any) -> str:
    """The name "module:name" of a class or function; only what stands at the top of a module is found again by it."""
    named = thing if hasattr(thing, "__qualname__") else type(thing)
    return f"{named.__module__}:{named.__qualname__}"


def shown(value: object, width: int = 60) -> str:
    """`value` as its owner wrote it, cut to a readable length."""
    return cut(repr(list(value) if isinstance(value, tuple) else value), width)


def cut(text: str, width: int = 60) -> str:
    """`text`, or its beginning where it is longer."""
    return text if len(text) <= width else text[: width - 3] + "..."


def near(word: str, known: Iterable[str], cutoff: float = 0.6) -> str:
    """'; did you mean `x`?' when some known word is near, "" when none is."""
    found = difflib.get_close_matches(word, list(known), n=1, cutoff=cutoff)
    return f"; did you mean `{found[0]}`?" if found else ""


def suggestion(word: str, known: Iterable[str]) -> str:
    """'; did you mean `x`?' when some known word is near, or one is a part of the other; all known words when none is."""
    known = list(known)
    kin = [other for other in known if min(len(word), len(other)) >= LEAST_KIN and (word in other or other in word)]
    return near(word, known, 0.8) or near(word, kin, 0.0) or near(word, known) or f"; known here: {', '.join(known)}."


def placed(path: str, tables: Iterable[tuple[str, type]], shape: str = "`{}`") -> str:
    """'; did you mean `table.path`?' for the first of some tables that has a parameter at that path, "" when none has.

    shape: how the path is to be shown.
    """
    found = next((name for name, cls in tables if _leads(cls, path.split("."))), "")
    return f"; did you mean {shape.format(f'{found}.{path}')}?" if found else ""


def _leads(cls: Any, keys: Sequence[str]) -> bool:
    """Whether keys lead to a parameter of a class, or into a table that is one."""
    if not keys or get_origin(cls) is dict:
        return len(keys) < 2
    if isinstance(cls, UnionType):
        return any(_leads(option, keys) for option in get_args(cls))
    known = dataclasses.is_dataclass(cls) and keys[0] in (f.name for f in fields(cls))
    return known and _leads(split_hint(hints_of(cls)[keys[0]])[0], keys[1:])


def listed(words: Sequence[str]) -> str:
    """Words in a sentence: with commas and a last "and"."""
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"


@dataclass(frozen=True)
class Parameter:
    """What the code itself knows of one parameter of a component."""

    name: str
    type: str
    default: Any
    required: bool
    unit: str
    range: str
    doc: str


@dataclass(frozen=True)
class Component(ABC):  # noqa: B024  (families below have abstract methods)
    """Base of everything that a scenario is made of: checked once, when it is made.

    `kind` is the name under which scenario files know the class.
    """

    kind: ClassVar[str] = ""

    def __post_init__(self) -> None:
        values = {f.name: plain_value(getattr(self, f.name)) for f in fields(self)}
        for name, value in check(type(self), values).items():
            object.__setattr__(self, name, value)
        self.check()

    def check(self) -> None:  # noqa: B027  (most have no such rule)
        """Raise :class:`ArgumentError` where parameters do not fit one another; override where there is such a rule."""

    @classmethod
    def summary(cls) -> str:
        """The first line of the docstring."""
        return (cls.__doc__ or cls.__name__).strip().splitlines()[0]


def check(cls: type, values: Mapping[str, Any]) -> dict[str, Any]:
    """`values` checked against the declared types and ranges of `cls`; raises one :class:`ArgumentError` for all faults."""
    import pydantic

    try:
        model = _model(cls).model_validate(dict(values))
    except pydantic.ValidationError as error:
        raise ArgumentError(_lines(cls, values, error.errors())) from None
    checked = {name: getattr(model, name) for name in values}
    faults = [line for name, value in checked.items() for line in _beyond(name, value)]
    if faults:
        raise ArgumentError(faults)
    return checked


def _beyond(name: str, value: Any) -> list[str]:
    """A complaint for the first number in `value` that is too large or too small to be reckoned with."""
    if isinstance(value, float) and value and not LEAST <= abs(value) <= MOST:
        return wrong(name, f"be 0 or between {LEAST:g} and {MOST:g} in size", value).lines
    if isinstance(value, tuple):
        return next((line for i, v in enumerate(value) if (line := _beyond(f"{name}[{i}]", v))), [])
    if isinstance(value, dict):
        return next((line for key, v in value.items() if (line := _beyond(f"{name}.{key}", v))), [])
    return []


@cache
def hints_of(cls: type) -> Mapping[str, Any]:
    """The type hints of a class, `Annotated` and all; found once, since finding them takes as long as checking a scenario."""
    return get_type_hints(cls, include_extras=True)


def parameters(cls: type) -> list[Parameter]:
    """Name, type, default, unit, range and meaning of every parameter of a component class."""
    hints = hints_of(cls)
    found = []
    for f in fields(cls):
        base, extras = split_hint(hints[f.name])
        made = f.default_factory is not MISSING
        required = f.default is MISSING and not made
        default: Any = f.default_factory() if made else None if required else f.default  # type: ignore[operator]
        unit = next((e.unit for e in extras if isinstance(e, Unit)), "")
        doc = next((e.documentation for e in extras if isinstance(e, Doc)), "")
        found.append(Parameter(f.name, _type_name(base), default, required, unit, _range(extras), doc))
    return found


def plain(component: Any) -> dict[str, Any]:
    """The component's parameters as nested dicts of plain values, `None` left out: what a TOML table holds."""
    return {
        f.name: plain(value) if dataclasses.is_dataclass(value) else value
        for f in fields(component)
        if (value := getattr(component, f.name)) is not None
    }


@cache
def _model(cls: type) -> type[BaseModel]:
    """A strict pydantic model with the fields of the dataclass `cls`."""
    import pydantic

    def instances(hint: Any) -> Any:
        """`hint` with every component class in it to be checked by isinstance alone: a component has checked itself."""
        if isinstance(hint, type) and issubclass(hint, Component):
            return pydantic.InstanceOf.__class_getitem__(hint)  # type: ignore[type-arg]
        if get_origin(hint) is Annotated:
            return Annotated[instances(get_args(hint)[0]), *get_args(hint)[1:]]
        if isinstance(hint, UnionType):
            return Union[tuple(map(instances, get_args(hint)))]  # noqa: UP007
        if get_origin(hint) in (tuple, dict):
            return get_origin(hint)[tuple(map(instances, get_args(hint)))]
        return hint

    config = pydantic.ConfigDict(strict=True, extra="forbid", allow_inf_nan=False, arbitrary_types_allowed=True)
    hints = hints_of(cls)
    declared: dict[str, Any] = {}
    for f in fields(cls):
        base, extras = split_hint(hints[f.name])
        bounds = {key: getattr(e, key) for e in extras for kind, key, _ in _BOUNDS if isinstance(e, kind)}
        declared[f.name] = (_bounded(instances(base), bounds), ...)
    return pydantic.create_model(cls.__name__, __config__=config, **declared)


def _bounded(hint: Any, bounds: dict[str, Any]) -> Any:
    """`hint` with bounds on its numbers: on the parameter itself, or on the members of its lists and dicts."""
    import pydantic

    if not bounds or hint in (type(None), str, bool):
        return hint
    if hint in (int, float):
        return Annotated[hint, pydantic.Field(**bounds)]
    if get_origin(hint) in (tuple, dict):
        return get_origin(hint)[tuple(a if a is Ellipsis else _bounded(a, bounds) for a in get_args(hint))]
    if isinstance(hint, UnionType) or get_origin(hint) is Union:
        return Union[tuple(_bounded(a, bounds) for a in get_args(hint))]  # noqa: UP007
    return hint


def split_hint(hint: Any) -> tuple[Any, tuple[Any, ...]]:
    """A type hint as the type itself and what `Annotated` adds to it."""
    return (get_args(hint)[0], get_args(hint)[1:]) if get_origin(hint) is Annotated else (hint, ())


def _range(extras: tuple[Any, ...]) -> str:
    return " and ".join(f"{sign} {getattr(e, key):g}" for e in extras for kind, key, sign in _BOUNDS if isinstance(e, kind))


def _type_name(base: Any) -> str:
    names = {float: "number", int: "whole number", bool: "true/false", str: "string"}
    if base in names:
        return names[base]
    if get_origin(base) is Callable:
        return "function"
    if get_origin(base) is tuple:
        return f"list of {_plural(get_args(base)[0])}"
    if get_origin(base) is dict:
        return f"table of {_plural(get_args(base)[1])}"
    if get_origin(base) is Annotated:
        return next((extra for extra in get_args(base)[1:] if isinstance(extra, str)), _type_name(get_args(base)[0]))
    if get_origin(base) is Callable:
        return "function"
    options = [a for a in get_args(base) if a is not type(None)]
    if options and all(isinstance(o, str) for o in options):
        return " | ".join(f'"{o}"' for o in options)
    return " or ".join(map(_type_name, options)) if options else getattr(base, "__name__", str(base))


def _plural(base: Any) -> str:
    name = _type_name(base)
    return name.replace("list of", "lists of", 1) if name.startswith("list of") else f"{name}s"


def plain_value(value: Any) -> Any:
    """Lists, tables, NumPy's and sparse arrays become tuples and dicts of Python's numbers, so that any may be given."""
    if isinstance(value, list | tuple):
        return tuple(plain_value(v) for v in value)
    if isinstance(value, dict):
        return {key: plain_value(v) for key, v in value.items()}
    if type(value).__module__.startswith("scipy.sparse"):
        value = value.toarray()
    return plain_value(value.tolist()) if type(value).__module__ == "numpy" and hasattr(value, "tolist") else value


def _lines(cls: type, values: Mapping[str, Any], errors: Sequence[Any]) -> list[str]:
    """pydantic's errors in the house form: one line for each fault, and one for a value that fits none of several types."""
    known = {p.name: p for p in parameters(cls)}
    lines: dict[object, str] = {}
    for error in sorted(errors, key=lambda e: not _bound(e)):
        name, *inner = error["loc"]
        base, value = split_hint(hints_of(cls)[name])[0], values[name]
        if " or " not in known[name].type:
            lines[error["loc"]] = _line(known[name], inner, error, error["input"])
        elif inner and get_origin(base) is dict:
            member = dataclasses.replace(known[name], name=f"{name}.{inner[0]}", type=_type_name(get_args(base)[1]))
            lines.setdefault(member.name, _line(member, [], error, value[inner[0]]))
        else:
            lines.setdefault(name, _line(known[name], [], error, value))
    return list(lines.values())


def _bound(error: Any) -> tuple[str, str] | None:
    return next(((sign, key) for _, key, sign in _BOUNDS if key in error.get("ctx", {})), None)


def _line(parameter: Parameter, inner: Sequence[Any], error: Any, value: object) -> str:
    path = parameter.name + "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in inner if part != "[key]")
    unit, kind, bound = (f" {parameter.unit}" if parameter.unit else ""), error["type"], _bound(error)
    units = f" in{unit}" if unit else ""
    if bound:
        must = f"be {bound[0]} {error['ctx'][bound[1]]:g}{unit}"
    elif kind == "literal_error":
        must = f"be {error['ctx']['expected']}"
    elif kind == "is_instance_of" and inner:
        must = f"be a {error['ctx']['class']}"
    elif kind == "dict_type" and "port" in parameter.doc:
        must = f"be a table by port, such as {{tip_w = {shown(value, 30) if _may_be_of_a_port(value) else '...'}}}{units}"
    elif " or " in parameter.type:
        must = f"be a {parameter.type}{units}"
    elif kind == "is_instance_of":
        must = f"be a {parameter.type}"
    else:
        must = f"be {_TYPES.get(kind, error['msg'])}{units}"
    if "number" in must and isinstance(value, str) and WITH_UNIT.fullmatch(value):
        must += ", without the unit"
    return wrong(path, must, value).lines[0]


def _may_be_of_a_port(value: object) -> bool:
    """Whether what was given for all ports might have been meant for one: a number, or a list of numbers."""
    return is_number(value) or (isinstance(value, tuple) and len(value) > 0 and all(map(is_number, value)))
