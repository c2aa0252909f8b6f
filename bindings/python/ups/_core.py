"""What every class of the package stands on: errors, Python values to C fields, texts, handles; and the context.

Called by the other modules of the package; programs see what __init__ takes from here.
"""
import ctypes
import weakref
from ctypes import byref

import numpy as np

from . import _ffi, _library
from ._ffi import LogLevel, Status

lib = _library.load()


class Error(Exception):
    """A failed call: `status` says which kind, the message what was wrong, where, and what would be right."""

    def __init__(self, status, message):
        super().__init__(message)
        self.status = status

    def __str__(self):
        return f"{self.status.name}: {super().__str__()}"


def check(status):
    """Failures are negative; TIMEOUT and CANCELLED are answers."""
    if status < 0:
        raise Error(Status(status), lib.ups_last_error().decode("utf-8", "replace"))
    return Status(status)


def version():
    """(major, minor, patch) of the loaded library."""
    v = lib.ups_version()
    return v // 10000, v // 100 % 100, v % 100


def translation(x, y, z):
    """A transform, 3x4, that only moves."""
    return np.array([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z]], dtype=float)


# ---- from Python values to C fields


def as_matrix(transform, name):
    m = np.asarray(transform, dtype=np.float64)
    if m.shape == (4, 4):
        if not np.array_equal(m[3], (0, 0, 0, 1)):
            raise ValueError(f"{name}: the last row of a 4x4 transform must be 0 0 0 1")
        m = m[:3]
    if m.shape not in ((3, 4), (12,)):
        raise ValueError(f"{name}: expected 3x4 or 4x4 (row-major, own frame to outer frame), got shape {m.shape}")
    return m.ravel()


def as_array(values, dtype, shape, name):
    """A contiguous copy or view of the given shape; -1 stands for any length."""
    a = np.ascontiguousarray(values, dtype=dtype)
    if a.ndim != len(shape) or any(want not in (-1, have) for want, have in zip(shape, a.shape)):
        wanted = ", ".join("n" if s == -1 else str(s) for s in shape)
        raise ValueError(f"{name}: expected an array of shape ({wanted}), got {a.shape}")
    return a


def address(array, ctype):
    """As a pointer, which keeps the array alive."""
    return None if array is None else array.ctypes.data_as(ctypes.POINTER(ctype))


def describe(cls, fields):
    """A C description with the library's defaults, then with `fields`."""
    desc = cls()
    desc.inputs = fields  # a C field lets go of the array or the struct that it points to; this holds them
    getattr(lib, _ffi.INIT[cls])(byref(desc), ctypes.sizeof(desc))
    known = {name: kind for name, kind in cls._fields_ if name not in ("struct_size", "reserved")}
    for name, value in fields.items():
        if name not in known:
            raise TypeError(f"unknown field {name!r}; there are: {', '.join(known)}")
        if name in ("to_world", "to_fixture"):
            value = as_matrix(value, name)
        if issubclass(known[name], ctypes.Array):
            value = np.asarray(value, dtype=float).tolist()
            if len(value) != known[name]._length_:
                raise ValueError(f"{name}: expected {known[name]._length_} values, got {len(value)}")
            value = known[name](*value)
        setattr(desc, name, value)
    return desc


def describe_mesh(positions_m, indices, **optional):
    """Positions (n, 3), indices (triangles, 3); optional: normals (n, 3), uvs (n, 2), tangents (n, 4), material."""
    p = as_array(positions_m, np.float32, (-1, 3), "positions_m")
    i = as_array(indices, np.uint32, (-1, 3), "indices")
    fields = {"vertex_count": len(p), "triangle_count": len(i), "positions_m": address(p, ctypes.c_float),
              "indices": address(i, ctypes.c_uint32)}
    widths = {"normals": 3, "uvs": 2, "tangents": 4}
    for name, values in optional.items():
        if name in widths and values is not None:
            values = address(as_array(values, np.float32, (len(p), widths[name]), name), ctypes.c_float)
        fields[name] = values
    return describe(_ffi.MeshDesc, fields)


# ---- from the library's answers to Python values


def read_info(cls, function, *arguments):
    info = cls()
    info.struct_size = ctypes.sizeof(info)
    check(function(*arguments, byref(info)))
    return info


def read_bytes(function, *arguments):
    """The two calls that every text takes: its size, then its bytes. Without the final zero."""
    needed = ctypes.c_size_t()
    check(function(*arguments, None, 0, byref(needed)))
    if needed.value == 0:
        return b""
    buffer = ctypes.create_string_buffer(needed.value)
    check(function(*arguments, buffer, needed.value, byref(needed)))
    return buffer.raw[:-1]


def read_array(cls, function, *arguments):
    """The two calls of an array of plain elements: its length, then a record array of `cls`."""
    needed = ctypes.c_size_t()
    check(function(*arguments, None, 0, byref(needed)))
    out = np.empty(needed.value, dtype=np.dtype(cls))
    if len(out):
        check(function(*arguments, address(out, cls), len(out), byref(needed)))
    return out


def read_text(function, *arguments):
    return read_bytes(function, *arguments).decode("utf-8", "replace")


class Handle:
    """Owns a handle of the library, which it destroys once."""

    def __init__(self, pointer, destroy):
        self._as_parameter_ = pointer
        self._destroy = weakref.finalize(self, destroy, pointer)

    def close(self):
        self._destroy()
        self._as_parameter_ = None  # the library answers any later call with INVALID_ARGUMENT

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def create(function, *arguments):
    pointer = ctypes.c_void_p()
    check(function(*arguments, byref(pointer)))
    return pointer


class Context(Handle):
    """Threads and log. thread_count 0: all hardware threads."""

    def __init__(self, thread_count=0):
        desc = describe(_ffi.ContextDesc, {"thread_count": thread_count})
        super().__init__(create(lib.ups_context_create, byref(desc)), lib.ups_context_destroy)

    @property
    def thread_count(self):
        count = ctypes.c_int32()
        check(lib.ups_context_get_thread_count(self, byref(count)))
        return count.value

    def pop_log(self):
        """Takes all messages out of the log: a list of (LogLevel, text), oldest first."""
        messages = []
        needed, level = ctypes.c_size_t(), ctypes.c_int32()
        while True:
            check(lib.ups_context_pop_log(self, None, 0, byref(needed), None))
            if needed.value == 0:
                return messages
            buffer = ctypes.create_string_buffer(needed.value)
            status = lib.ups_context_pop_log(self, buffer, needed.value, byref(needed), byref(level))
            if status == Status.ERROR_BUFFER_TOO_SMALL:  # another thread took that message; look at the next one
                continue
            check(status)
            if needed.value:
                messages.append((LogLevel(level.value), buffer.value.decode("utf-8", "replace")))
