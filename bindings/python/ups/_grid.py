"""Where EN 12464-1 wants an area's illuminance.

Used by programs, as ups.en12464_grid.
"""
from __future__ import annotations

import ctypes
from collections.abc import Sequence
from ctypes import byref
from typing import TYPE_CHECKING

import numpy as np

from . import _ffi
from ._convert import address, as_array, describe, lib, read_array
from ._status import check

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def en12464_grid(polygon_m: ArrayLike, holes_m: Sequence[ArrayLike] = (),
                 border_m: float = 0.5) -> tuple[NDArray[np.void], _ffi.En12464Info]:
    """The grid's points in a polygon (n, 2), holes likewise, as (points, info): a record array with the fields of
    ups_en12464_point, and ups_en12464_info."""
    corners = as_array(polygon_m, np.float64, (-1, 2), "polygon_m")
    holes = [as_array(hole, np.float64, (-1, 2), f"holes_m[{i}]") for i, hole in enumerate(holes_m)]
    hole_corners = np.concatenate(holes) if holes else np.empty((0, 2))
    counts = np.array([len(hole) for hole in holes], dtype=np.uint32)
    desc = describe(_ffi.En12464Desc, {"corners_m": address(corners, ctypes.c_double), "corner_count": len(corners),
                                       "hole_corners_m": address(hole_corners, ctypes.c_double),
                                       "hole_corner_counts": address(counts, ctypes.c_uint32),
                                       "hole_count": len(counts), "border_m": border_m})
    info = _ffi.En12464Info()
    info.struct_size = ctypes.sizeof(info)
    points = read_array(_ffi.En12464Point, lib.ups_en12464_grid, byref(desc), None)
    needed = ctypes.c_size_t()
    check(lib.ups_en12464_grid(byref(desc), byref(info), None, 0, byref(needed)))
    return points, info
