"""Which libups is used, and how its functions look to ctypes. Called once, when the package is imported.

Looked for in this order: UPS_LIBRARY (a file, or a folder that holds libups.so), this package's own folder, the system.
"""
import ctypes
import ctypes.util
import os
from pathlib import Path

from . import _ffi

_NAME = "libups.so"


def _candidates():
    chosen = os.environ.get("UPS_LIBRARY")
    if chosen:  # a wrong choice is an error and never a silent fall back to another library
        yield str(Path(chosen) / _NAME) if os.path.isdir(chosen) else chosen
        return
    beside = Path(__file__).resolve().parent / _NAME
    if beside.exists():
        yield str(beside)
    # The SONAME first: a program without the development files has nothing else.
    major, minor, _ = _ffi.HEADER_VERSION
    yield f"{_NAME}.{major}.{minor}" if major == 0 else f"{_NAME}.{major}"
    yield _NAME
    found = ctypes.util.find_library("ups")
    if found:
        yield found


def load():
    tried = []
    for name in _candidates():
        try:
            library = ctypes.CDLL(name)
        except OSError as error:
            tried.append(str(error))
            continue
        _bind(library, name)
        return library
    raise ImportError("libups was not found; set UPS_LIBRARY to the file or to its folder. Tried: " + "; ".join(tried))


def _bind(library, name):
    for function, (result, parameters) in _ffi.PROTOTYPES.items():
        try:
            f = getattr(library, function)
        except AttributeError:
            raise ImportError(f"{name} has no {function}: it is older than this package, which needs UPS "
                              + ".".join(map(str, _ffi.HEADER_VERSION))) from None
        f.restype, f.argtypes = result, parameters
