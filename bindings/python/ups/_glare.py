"""How much does a source dazzle: position indices and UGR by hand.

Used by programs, as ups.position_index and ups.ugr. Luminaires' tables are in _profile.py, observers in _scene.py and
_result.py.
"""
from __future__ import annotations

import ctypes
from ctypes import byref
from typing import TYPE_CHECKING

import numpy as np

from ._convert import address, as_array, lib, target
from ._ffi import PositionIndex
from ._status import check

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def position_index(directions: ArrayLike, kind: PositionIndex = PositionIndex.TABLE) -> NDArray[np.float32]:
    """In each direction of an (n, 3) array, in the eye's frame, which looks along -Z, +Y up; -1: not a source there."""
    d = as_array(directions, np.float32, (-1, 3), "directions")
    out = np.empty(len(d), dtype=np.float32)
    check(lib.ups_glare_get_position_index(kind, address(d, ctypes.c_float), len(d), target(out, ctypes.c_float)))
    return out


def ugr(luminance_cd_m2: ArrayLike, solid_angle_sr: ArrayLike, index: ArrayLike, background_cd_m2: float) -> float:
    """Of sources by three arrays of one length; -1: none of them counts."""
    values = [as_array(np.ravel(v), np.float32, (-1,), name)
              for v, name in ((luminance_cd_m2, "luminance_cd_m2"), (solid_angle_sr, "solid_angle_sr"), (index, "index"))]
    if len({len(v) for v in values}) != 1:
        raise ValueError("luminance_cd_m2, solid_angle_sr and index must have one length")
    out = ctypes.c_float()
    check(lib.ups_glare_get_ugr(*(address(v, ctypes.c_float) for v in values), len(values[0]), background_cd_m2,
                                byref(out)))
    return out.value
