"""Integers that C can hold. ctypes cuts off what does not fit: 2^32 + 1 would become 1, and -1 a large number.

Called by _convert for the fields of descriptions and arrays, by _library for the parameters of functions.
"""
from __future__ import annotations

import ctypes
import operator
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


def as_integers(values: Any, dtype: Any, name: str) -> np.ndarray[Any, Any]:
    """As an array of integers of that type; a copy only where it is not one. Errors as of as_integer."""
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
    """The function, whose arguments at those places are checked; they have these names."""
    def call(*arguments: Any) -> Any:
        values = list(arguments)
        for i, name in integers.items():
            values[i] = as_integer(function.argtypes[i], values[i], name)
        return function(*values)
    return call
