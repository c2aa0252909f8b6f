"""Handles of the library, which free themselves, and the context.

Called by the modules of the package's classes; programs see the context.
"""
from __future__ import annotations

import ctypes
import weakref
from ctypes import byref
from typing import Any, Callable, SupportsIndex, TypeVar

from . import _ffi
from ._convert import describe, lib
from ._ffi import LogLevel, Status
from ._library import version_of
from ._status import Error, check

Owner = TypeVar("Owner", bound="Handle")


def version() -> tuple[int, int, int]:
    """(major, minor, patch) of the loaded library."""
    return version_of(lib.ups_version())


class _Pointer(ctypes.c_void_p):
    """A handle of the library, destroyed with it. A call keeps what it is given, so that what is closed meanwhile by
    another thread is destroyed after the call."""


class Handle:
    """Owns a handle of the library, which it destroys once. Classes say what destroys theirs, and what their library's
    answers are checked by."""
    _destroy: Callable[[ctypes.c_void_p], None]
    _check = staticmethod(check)
    _as_parameter_: ctypes.c_void_p | None = None

    def __init__(self, function: Callable[..., int], *arguments: Any):
        """Of what the function makes. It has an owner before it is there: an interrupt may come right after."""
        made, pointer = ctypes.c_void_p(), _Pointer()
        self._end = weakref.finalize(pointer, self._destroy, made)
        self._end.atexit = False  # a thread that nobody waits for, or an array, may still use it
        self._check(function(*arguments, byref(made)))
        pointer.value = made.value
        self._as_parameter_ = pointer

    def close(self) -> None:
        self._as_parameter_ = None  # the library answers any later call with INVALID_ARGUMENT

    def __enter__(self: Owner) -> Owner:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def pointer_of(handle: Handle, kind: type[Handle]) -> ctypes.c_void_p:
    """For a field of a description, which anything but a handle could get into, and where NULL may mean that it stays
    as it is. Errors: TypeError for anything else; Error for what was closed, as where a function takes it."""
    name = kind.__name__
    if not isinstance(handle, kind):
        raise TypeError(f"expected a {name}, got {type(handle).__name__}")
    pointer = handle._as_parameter_
    if pointer is None:
        raise Error(Status.ERROR_INVALID_ARGUMENT, f"{name.lower()} is None, or was closed")
    return pointer


class Context(Handle):
    """Threads and log. thread_count 0: all hardware threads."""
    _destroy = lib.ups_context_destroy

    def __init__(self, thread_count: SupportsIndex = 0):
        desc = describe(_ffi.ContextDesc, {"thread_count": thread_count})
        super().__init__(lib.ups_context_create, byref(desc))

    @property
    def thread_count(self) -> int:
        count = ctypes.c_int32()
        check(lib.ups_context_get_thread_count(self, byref(count)))
        return count.value

    def pop_log(self) -> list[tuple[LogLevel, str]]:
        """Takes all messages out of the log: a list of (LogLevel, text), oldest first."""
        messages: list[tuple[LogLevel, str]] = []
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
