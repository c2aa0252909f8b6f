"""Python values to C: transforms, arrays, descriptions. And back: infos, texts, arrays of plain elements.

Called by the modules of the package's classes.
"""
from __future__ import annotations

import ctypes
import functools
import os
from collections.abc import Iterable, Mapping, Sequence
from ctypes import byref
from typing import TYPE_CHECKING, Any, Callable, TypeVar

import numpy as np

from . import _ffi
from ._library import load
from ._numbers import as_integer, as_integers, is_integer, is_masked
from ._status import check

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

lib = load()

Info = TypeVar("Info", bound=ctypes.Structure)


def translation(x: float, y: float, z: float) -> NDArray[np.float64]:
    """A transform, 3x4, that only moves."""
    return np.array([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z]], dtype=float)


# ---- from Python values to C


def as_matrix(transform: ArrayLike, name: str) -> NDArray[np.float64]:
    m = np.asarray(real(transform, name), dtype=np.float64)
    if m.shape == (4, 4):
        if not np.array_equal(m[3], (0, 0, 0, 1)):
            raise ValueError(f"{name}: the last row of a 4x4 transform must be 0 0 0 1")
        m = m[:3]
    if m.shape not in ((3, 4), (12,)):
        raise ValueError(f"{name}: expected 3x4 or 4x4 (row-major, own frame to outer frame), got shape {m.shape}")
    return m.ravel()


def _check_shape(a: NDArray[Any], shape: Sequence[int], name: str) -> None:
    if a.ndim != len(shape) or any(want not in (-1, have) for want, have in zip(shape, a.shape)):
        wanted = ", ".join("n" if s == -1 else str(s) for s in shape)
        raise ValueError(f"{name}: expected an array of shape ({wanted}), got {a.shape}")


def as_array(values: ArrayLike, dtype: Any, shape: Sequence[int], name: str) -> NDArray[Any]:
    """Contiguous and of the given shape; -1 stands for any length. A copy only where the values are not so already."""
    if np.dtype(dtype).kind in "iu":
        values = as_integers(values, dtype, name)
    a = np.require(np.ascontiguousarray(real(values, name), dtype=dtype), requirements=["ALIGNED"])
    _check_shape(a, shape, name)
    return a


def one_or_each(values: ArrayLike, count: int, name: str) -> NDArray[np.float32]:
    """Directions (count, 3), of which one, (3,) or (1, 3), may stand for all."""
    a = real(values, name)
    if a.shape in ((3,), (1, 3)):
        a = np.broadcast_to(a, (count, 3))
    return as_array(a, np.float32, (count, 3), name)


def real(values: ArrayLike, name: str) -> NDArray[Any]:
    if is_masked(values):
        raise TypeError(f"{name}: a masked array has values that are not known; say what they are: .filled(numpy.nan)")
    a = np.asarray(values)
    if a.dtype.kind == "c":  # NumPy would drop the imaginary parts with a warning
        raise TypeError(f"{name}: expected real numbers, got complex ones")
    return a


def as_rows(values: ArrayLike, width: int, name: str) -> tuple[NDArray[np.float32], int]:
    """Floats (n, width) and the bytes from row to row: a part of the columns of a larger array is not copied."""
    a = real(values, name)
    if a.dtype == np.float32 and a.ndim == 2 and a.shape[1] == width and a.flags.aligned:
        if a.strides[1] == a.itemsize and a.strides[0] >= width * a.itemsize:
            return a, a.strides[0]
    return as_array(a, np.float32, (-1, width), name), width * 4


def address(array: NDArray[Any] | None, ctype: Any) -> Any:
    """As a pointer, which keeps the array alive."""
    return None if array is None else array.ctypes.data_as(ctypes.POINTER(ctype))


def _as_field(kind: Any, value: Any, name: str) -> Any:
    if name in ("to_world", "to_fixture"):
        value = as_matrix(value, name)
    if is_integer(kind):
        return as_integer(kind, value, name)
    if not issubclass(kind, ctypes.Array):
        return value
    value = np.asarray(real(value, name), dtype=float).tolist()
    if not isinstance(value, list) or len(value) != kind._length_:
        raise ValueError(f"{name}: expected {kind._length_} values")
    return kind(*value)


def describe(cls: type[Info], fields: Mapping[str, Any], library: Any = lib) -> Info:
    """A C description with the library's defaults, then with `fields`."""
    desc = cls()
    getattr(library, _ffi.INIT[cls])(byref(desc), ctypes.sizeof(desc))
    assign(desc, fields)
    return desc


def assign(desc: ctypes.Structure, fields: Mapping[str, Any]) -> None:
    """Errors: TypeError for what is no field, or of a wrong type; ValueError for a wrong shape or range."""
    desc.inputs = fields  # a C field lets go of the array or the struct that it points to; this holds them
    known: dict[str, Any] = {f[0]: f[1] for f in desc._fields_}
    for name, value in fields.items():
        if name not in known or name == "struct_size" or name.startswith("reserved"):
            names = [n for n in known if n != "struct_size" and not n.startswith("reserved")]
            raise TypeError(f"unknown field {name!r}; there are: {', '.join(names)}")
        try:
            setattr(desc, name, _as_field(known[name], value, name))
        except TypeError as error:
            text = str(error)
            raise TypeError(text if text.startswith(name) else f"{name}: {text}") from None


def merged(own: Mapping[str, Any], fields: Mapping[str, Any], counts: Iterable[str] = ()) -> dict[str, Any]:
    """A caller's fields beside those that the method sets by itself: a count is an array's, whatever is said."""
    for name in fields:
        if name in own or name in counts:
            raise TypeError(f"{name}: is told by the other arguments")
    return {**own, **fields}


def c_text(text: str, encoding: tuple[str, str] = ("utf-8", "strict")) -> bytes:
    """As the library takes texts, which a NUL would cut short."""
    if "\0" in text:
        raise ValueError(f"embedded null character in {text!r}")
    return text.encode(*encoding)


def c_path(path: str | os.PathLike[str]) -> bytes:
    encoded = os.fsencode(path)
    if b"\0" in encoded:
        raise ValueError(f"embedded null character in the path {path!r}")
    return encoded


def texture_fields(texels: ArrayLike) -> dict[str, Any]:
    """Texels (height, width) or (height, width, channels)."""
    t = np.ascontiguousarray(real(texels, "texels"), dtype=np.float32)
    t = as_array(t[:, :, None] if t.ndim == 2 else t, np.float32, (-1, -1, -1), "texels")
    return {"width": t.shape[1], "height": t.shape[0], "channel_count": t.shape[2],
            "texels": address(t, ctypes.c_float)}


def meter_fields(positions_m: ArrayLike, normals: ArrayLike, tangents: ArrayLike | None) -> dict[str, Any]:
    """All three (n, 3); one normal or tangent may stand for all meters."""
    p = as_array(positions_m, np.float64, (-1, 3), "positions_m")
    fields: dict[str, Any] = {"positions_m": address(p, ctypes.c_double), "count": len(p)}
    for name, values in (("normals", normals), ("tangents", tangents)):
        fields[name] = None
        if values is not None:
            fields[name] = address(one_or_each(values, len(p), name), ctypes.c_float)
    return fields


def instance_fields(instances: Sequence[_ffi.InstanceId]) -> dict[str, Any]:
    return {"instance_count": len(instances), "instances": (_ffi.InstanceId * len(instances))(*instances)}


def angle_fields(c_deg: ArrayLike | None, gamma_deg: ArrayLike | None,
                 fields: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Of a goniometer: (what says its angles, the other fields). c_count and gamma_count alone: equal steps."""
    own: dict[str, Any] = {}
    rest = dict(fields)
    for name, values in (("c", c_deg), ("gamma", gamma_deg)):
        if values is not None:
            angles = as_array(values, np.float32, (-1,), f"{name}_deg")
            own.update({f"{name}_deg": address(angles, ctypes.c_float), f"{name}_count": len(angles)})
        elif f"{name}_count" in rest:
            own.update({f"{name}_deg": None, f"{name}_count": rest.pop(f"{name}_count")})
    return own, rest


def mesh_fields(positions_m: ArrayLike, indices: ArrayLike, **optional: Any) -> dict[str, Any]:
    """Positions (n, 3), indices (triangles, 3); optional: normals (n, 3), uvs (n, 2), tangents (n, 4), material."""
    p, stride = as_rows(positions_m, 3, "positions_m")
    i = as_array(indices, np.uint32, (-1, 3), "indices")
    fields: dict[str, Any] = {
        "vertex_count": len(p), "triangle_count": len(i), "positions_m": address(p, ctypes.c_float),
        "position_stride_bytes": stride, "indices": address(i, ctypes.c_uint32)}
    widths = {"normals": 3, "uvs": 2, "tangents": 4}
    for name, values in optional.items():
        if name in widths and values is not None:
            rows, stride = as_rows(values, widths[name], name)
            _check_shape(rows, (len(p), widths[name]), name)
            fields[name[:-1] + "_stride_bytes"] = stride
            values = address(rows, ctypes.c_float)
        fields[name] = values
    return fields


def material_fields(fields: Mapping[str, Any]) -> dict[str, Any]:
    """pane_angle_deg, pane_transmittance and pane_reflectance, of a pane measured by angle: arrays of one length."""
    values = dict(fields)
    for name in ("pane_angle_deg", "pane_transmittance", "pane_reflectance"):
        if values.get(name) is not None:
            array = as_array(values[name], np.float32, (-1,), name)
            if values.setdefault("pane_angle_count", len(array)) != len(array):
                raise ValueError(f"{name}: expected as many values as the others have, "
                                 f"{values['pane_angle_count']}, got {len(array)}")
            values[name] = address(array, ctypes.c_float)
    return values


# ---- from the library's answers to Python values


def read_info(cls: type[Info], function: Callable[..., int], *arguments: Any) -> Info:
    info = cls()
    info.struct_size = ctypes.sizeof(info)
    check(function(*arguments, byref(info)))
    return info


def read_count(function: Callable[..., int], owner: Any) -> int:
    count = ctypes.c_uint32()
    check(function(owner, byref(count)))
    return count.value


def read_bytes(function: Callable[..., int], *arguments: Any, checked: Callable[[int], Any] = check) -> bytes:
    """The two calls that every text takes: its size, then its bytes. Without the final zero."""
    needed = ctypes.c_size_t()
    while True:
        checked(function(*arguments, None, 0, byref(needed)))
        if needed.value == 0:
            return b""
        buffer = ctypes.create_string_buffer(needed.value)
        status = function(*arguments, buffer, len(buffer), byref(needed))
        if status != _ffi.Status.ERROR_BUFFER_TOO_SMALL:  # a commit that came between may have more to tell, or less
            checked(status)
            return buffer.raw[:max(needed.value, 1) - 1]


def read_text(function: Callable[..., int], *arguments: Any, checked: Callable[[int], Any] = check) -> str:
    return read_bytes(function, *arguments, checked=checked).decode("utf-8", "replace")


def lines_of(text: str) -> list[str]:
    """At line feeds alone: str.splitlines() splits at other characters, too, which a file's texts may have."""
    return text.removesuffix("\n").split("\n") if text else []


@functools.cache
def dtype_of(cls: Any) -> np.dtype[np.void]:
    """Of a record array whose records are these structs."""
    return np.dtype(cls)


def read_array(cls: type[ctypes.Structure], function: Callable[..., int], *arguments: Any) -> NDArray[np.void]:
    """The two calls of an array of plain elements: its length, then a record array of `cls`."""
    needed = ctypes.c_size_t()
    while True:
        check(function(*arguments, None, 0, byref(needed)))
        out = np.empty(needed.value, dtype=dtype_of(cls))
        if not len(out):
            return out
        status = function(*arguments, target(out, cls), len(out), byref(needed))
        if status != _ffi.Status.ERROR_BUFFER_TOO_SMALL:  # a commit that came between may have more of them, or less
            check(status)
            return out[:needed.value]


def target(out: NDArray[Any], ctype: Any) -> Any:
    """Where the library writes: the memory of a contiguous array. A microsecond faster than address; as bytes, because
    NumPy writes out what a record array's buffer consists of each time that it is asked for."""
    return ctype.from_buffer(out.view(np.uint8)) if out.size else None


def output(out: NDArray[Any] | None, like: NDArray[Any]) -> NDArray[Any]:
    """Where a copy goes: a new array, or the caller's, which must fit."""
    if out is None:
        return np.empty(like.shape, like.dtype)
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out: expected an array, got {type(out).__name__}")
    if out.shape != like.shape or out.dtype != like.dtype or not out.flags.carray:
        raise ValueError(f"out: expected a writeable, contiguous array of shape {like.shape} and type {like.dtype}, "
                         f"got {out.shape} and {out.dtype}")
    return out
