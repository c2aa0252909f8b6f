"""Which libups is used, and how its functions look to ctypes. Called once, when the package is imported.

Looked for in this order: UPS_LIBRARY (a file, or a folder that holds it), this package's own folder, the system.
"""
import ctypes
import ctypes.util
import os
from pathlib import Path

from . import _ffi

_MAJOR, _MINOR, _ = _ffi.HEADER_VERSION
# The SONAME first: a program without the development files has nothing else.
_NAMES = (f"libups.so.{_MAJOR}.{_MINOR}" if _MAJOR == 0 else f"libups.so.{_MAJOR}", "libups.so")


def _in_folder(folder):
    return [str(folder / name) for name in _NAMES if (folder / name).exists()]


def _candidates():
    chosen = os.environ.get("UPS_LIBRARY")
    if chosen:  # a wrong choice is an error and never a silent fall back to another library
        yield from (_in_folder(Path(chosen)) or [str(Path(chosen) / _NAMES[0])]) if os.path.isdir(chosen) else [chosen]
        return
    yield from _in_folder(Path(__file__).resolve().parent)
    yield from _NAMES
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
