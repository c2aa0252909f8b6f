"""Arguments that C can hold. ctypes cuts off integers that do not fit: 2^32 + 1 would become 1, and -1 a large number.

Called by _convert for the fields of descriptions and arrays, by _library for the parameters of functions.
"""
from __future__ import annotations

import ctypes
import operator
import re
from typing import Any

import numpy as np

# Of each integer type that the headers use; size_t is one of them.
_NUMPY: dict[Any, Any] = {
    ctypes.c_uint8: np.uint8, ctypes.c_int32: np.int32, ctypes.c_uint32: np.uint32, ctypes.c_uint64: np.uint64}


def is_integer(kind: Any) -> bool:
    return kind in _NUMPY


def as_integer(kind: Any, value: Any, name: str) -> int:
    """Errors: TypeError for what is no integer, ValueError for one out of the C type's range."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: expected an integer, got {value!r}") from None
    limits = np.iinfo(_NUMPY[kind])
    if not limits.min <= number <= limits.max:
        raise ValueError(f"{name}: expected an integer from {limits.min} to {limits.max}, got {number}")
    return number


def is_masked(values: Any) -> bool:
    """What lies beneath a mask would count as known."""
    return isinstance(values, np.ma.MaskedArray) and bool(np.any(np.asarray(values.mask)))


def as_integers(values: Any, dtype: Any, name: str) -> np.ndarray[Any, Any]:
    """As an array of integers of that type; a copy only where it is not one. Errors as of as_integer."""
    if is_masked(values):
        raise TypeError(f"{name}: expected integers that are all known, got a masked array")
    a = np.asarray(values)
    if a.dtype == dtype or a.size == 0:
        return a.astype(dtype, copy=False)
    if a.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected integers, got an array of {a.dtype}")
    limits = np.iinfo(dtype)
    low, high = int(a.min()), int(a.max())
    if low < limits.min or high > limits.max:
        raise ValueError(f"{name}: expected integers from {limits.min} to {limits.max}, got {low} to {high}")
    return a.astype(dtype)


def checked(function: Any, integers: dict[int, str]) -> Any:
    """The function, whose arguments at those places are checked; they have these names. What ctypes finds wrong with
    the others, an id of another kind, no number, is a TypeError too."""
    def call(*arguments: Any) -> Any:
        try:
            return function(*arguments)
        except ctypes.ArgumentError as error:
            raise TypeError(_refusal(function, arguments, str(error))) from None

    def call_with_integers(*arguments: Any) -> Any:
        values = list(arguments)
        for i, kind, name in places:
            values[i] = as_integer(kind, values[i], name)
        return call(*values)

    kinds = function.argtypes
    places = [(i, kinds[i], f"{function.__name__}: {name}") for i, name in integers.items()]
    return call_with_integers if places else call


class HandleParameter(ctypes.c_void_p):
    """A parameter that takes a handle, or where the library writes. ctypes takes integers and texts for addresses, too,
    which the library would read."""
    @classmethod
    def from_param(cls, value: Any) -> Any:
        if value is not None and isinstance(value, (int, str, bytes, bytearray)):
            raise TypeError("an address was expected")
        return ctypes.c_void_p.from_param(value)


_EXPECTED = {ctypes.c_float: "a number", ctypes.c_double: "a number", HandleParameter: "a handle"}


def _refusal(function: Any, arguments: tuple[Any, ...], error: str) -> str:
    """error: ctypes' own, which tells the argument by its number: that of the method's, which counts self."""
    found = re.match(r"argument (\d+):", error)
    if not found:
        return f"{function.__name__}: {error}"
    i = int(found[1]) - 1
    kind = function.argtypes[i]
    return f"{function.__name__}: argument {i + 1}: expected {_EXPECTED.get(kind, kind.__name__)}, got {arguments[i]!r}"
