"""What a call of the library answered: an exception with its status where it failed.

Called by every module that calls the library.
"""
from __future__ import annotations

import re
from typing import Any

from ._ffi import Status
from ._library import load


_OK = Status.OK
_NO_HANDLE = re.compile(r"\b(context|scene|job|result|profile|fixture|path) is NULL$")


class Error(Exception):
    """A failed call: `status` says which kind, the message what was wrong, where, and what would be right."""

    def __init__(self, status: Status, message: str):
        super().__init__(message)
        self.status = status

    def __str__(self) -> str:
        return f"{self.status.name}: {super().__str__()}"

    def __reduce__(self) -> Any:
        return Error, (self.status, *self.args)  # else pickling, as multiprocessing does, loses the status


def check(status: int, library: str = "ups") -> Status:
    """Failures are negative; TIMEOUT and CANCELLED are answers. Each library has messages of its own."""
    if status == 0:
        return _OK
    if status < 0:
        last_error = getattr(load(library), "ups_last_error" if library == "ups" else f"{library}_last_error")
        message = last_error().decode("utf-8", "replace")
        raise Error(Status(status), _NO_HANDLE.sub(r"\1 is None, or was closed", message))
    return Status(status)
