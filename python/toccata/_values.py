"""Values of the compiled part, copied, pickled and compared: of whatever class, also one that is derived from theirs.

The compiled part calls these, and pickles name `remade`.
"""

from __future__ import annotations

import copy
import copyreg
from typing import Any

import numpy


def remade(kind: Any, own: type, arguments: tuple[Any, ...], named: dict[str, Any]) -> Any:
    """A value of the class `own`, which is `kind` or derived from it, without what its own __init__ may want."""
    made = kind.__new__(own)
    kind.__init__(made, *arguments, **named)
    return made


def reduced(value: object, kind: type, arguments: tuple[Any, ...], named: dict[str, Any]) -> tuple[Any, ...]:
    """What __reduce__ returns for a value that `kind` makes of these arguments."""
    return remade, (kind, type(value), arguments, named), _added(value)


def _added(value: object) -> Any:
    """What a derived class has beside, as pickle tells it: None, a dict, or a dict and another of slots."""
    if hasattr(value, "__getstate__"):
        return value.__getstate__()
    return _state_before_python_3_11(value)


def _state_before_python_3_11(value: object) -> Any:
    """What object.__getstate__ tells since."""
    own = getattr(value, "__dict__", None)
    names = copyreg._slotnames(type(value))  # type: ignore[attr-defined]  # with those that are private
    slots = {name: getattr(value, name) for name in names if hasattr(value, name)}
    return (own, slots) if slots else own


def give_added(made: Any, value: object, memo: dict[int, object] | None) -> None:
    """Gives a copy what the class of the value has beside: itself, or with a memo copies of it (copy.deepcopy)."""
    state = _added(value)
    if memo is not None:
        memo[id(value)] = made
        state = copy.deepcopy(state, memo)
    if state is None:
        return
    if hasattr(made, "__setstate__"):
        made.__setstate__(state)
        return
    own, slots = state if isinstance(state, tuple) else (state, None)
    if own:
        made.__dict__.update(own)
    for name, told in (slots or {}).items():
        setattr(made, name, told)


def equal(a: Any, b: Any) -> bool:
    """Whether two values are made of the same: arrays by their fields and numbers, of which NaN is equal to itself."""
    if isinstance(a, numpy.ndarray):
        if a.dtype != b.dtype or a.shape != b.shape:
            return False
        if a.dtype.names:
            return all(equal(a[name], b[name]) for name in a.dtype.names)
        return bool(numpy.array_equal(a, b, equal_nan=a.dtype.kind == "f"))
    if isinstance(a, (tuple, list)):
        return type(a) is type(b) and len(a) == len(b) and all(map(equal, a, b))
    return bool(a == b)
