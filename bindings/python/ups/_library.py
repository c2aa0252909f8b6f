"""Which libups and which extras are used, and how their functions look to ctypes. The core is loaded when the package
is imported, an extra when something first needs it.

Looked for in this order: UPS_LIBRARY (the core's file, or the folders that hold the libraries, separated as in PATH),
the folder `lib` of this package, which wheels have, the system.
"""
from __future__ import annotations

import ctypes
import ctypes.util
import functools
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from . import _ffi
from ._numbers import HandleParameter, checked


def _abi(version: tuple[int, int, int]) -> str:
    """As in the SONAME: before 1.0 a minor version may lay out structs otherwise."""
    major, minor, _ = version
    return f"{major}.{minor}" if major == 0 else f"{major}"


def _names(library: str, platform: str = sys.platform) -> tuple[str, ...]:
    """The SONAME first: a program without the development files has nothing else."""
    abi = _abi(_ffi.HEADER_VERSION)
    if platform == "win32":
        return (f"{library}.dll",)
    if platform == "darwin":
        return f"lib{library}.{abi}.dylib", f"lib{library}.dylib"
    return f"lib{library}.so.{abi}", f"lib{library}.so"


def _in_folder(folder: Path, library: str) -> list[str]:
    return [str(folder / name) for name in _names(library) if (folder / name).exists()]


def _chosen(places: str, library: str) -> list[str]:
    """By UPS_LIBRARY: a wrong choice is an error and never a silent fall back to another library."""
    if os.path.isfile(places) and library == "ups":
        return [os.path.abspath(places)]  # of a name without a folder the system would look elsewhere
    given = [Path(os.path.abspath(p)) for p in places.split(os.pathsep) if p]
    folders = [p.parent if p.is_file() else p for p in given]
    found = [file for folder in folders for file in _in_folder(folder, library)]
    return found or [str(folders[0] / _names(library)[0]) if folders else places]


def _candidates(library: str) -> Iterator[str]:
    places = os.environ.get("UPS_LIBRARY")
    if places:
        yield from _chosen(places, library)
        return
    yield from _in_folder(Path(__file__).resolve().parent / "lib", library)
    yield from _names(library)
    found = ctypes.util.find_library(library)
    if found:
        yield found


@functools.cache
def load(library: str = "ups") -> Any:
    """Errors: ImportError, which says where it was looked for."""
    tried = []
    for name in _candidates(library):
        try:
            loaded = ctypes.CDLL(name)
        except OSError as error:
            tried.append(str(error))
            continue
        if library == "ups":
            _check_abi(loaded, name)
        _bind(loaded, name, library)
        return loaded
    raise ImportError(f"lib{library} was not found; set UPS_LIBRARY to the file of libups or to the folders that hold "
                      "it and its extras. Tried: " + "; ".join(tried))


def version_of(number: int) -> tuple[int, int, int]:
    """(major, minor, patch) of what ups_version() returns."""
    return number // 10000, number // 100 % 100, number % 100


def _check_abi(core: Any, name: str) -> None:
    """Names without a version, and UPS_LIBRARY, may lead to another ABI's library."""
    if not hasattr(core, "ups_version"):
        return  # _bind tells
    version = version_of(core.ups_version())
    if _abi(version) != _abi(_ffi.HEADER_VERSION):
        found, own = (".".join(map(str, v)) for v in (version, _ffi.HEADER_VERSION))
        file = _file_of(core.ups_version, name)
        raise ImportError(f"{file} is UPS {found}, which this package cannot use: it is of "
                          f"UPS {own} and needs a library of {_abi(_ffi.HEADER_VERSION)}")


class _SymbolInfo(ctypes.Structure):
    """Dl_info of dlfcn.h."""
    _fields_ = [("file", ctypes.c_char_p), ("base", ctypes.c_void_p), ("name", ctypes.c_char_p),
                ("address", ctypes.c_void_p)]


def _file_of(function: Any, name: str) -> str:
    """The path of what was loaded by a name without a folder, where the system tells it."""
    info = _SymbolInfo()
    if sys.platform != "win32" and ctypes.CDLL(None).dladdr(function, ctypes.byref(info)) and info.file:
        return os.fsdecode(info.file)
    return name


def _bind(loaded: Any, name: str, library: str) -> None:
    for function, (result, parameters, integers) in _ffi.PROTOTYPES[library].items():
        try:
            f = getattr(loaded, function)
        except AttributeError:
            raise ImportError(f"{name} has no {function}: it is older than this package, which needs UPS "
                              + ".".join(map(str, _ffi.HEADER_VERSION))) from None
        f.restype, f.argtypes = result, [HandleParameter if p is ctypes.c_void_p else p for p in parameters]
        if parameters and result is not None:  # the others take what the package made
            setattr(loaded, function, checked(f, integers))
