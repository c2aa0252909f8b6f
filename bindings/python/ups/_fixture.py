"""What is a luminaire made of: emitters, reflectors, lenses, collimators and meshes, in a frame of their own.

Used by programs, as ups.Fixture; Scene.add_fixture places it.
"""
from __future__ import annotations

import ctypes
from collections.abc import Mapping
from ctypes import byref
from typing import TYPE_CHECKING, Any, Callable

import numpy as np

from . import _ffi
from ._convert import address, as_array, describe, lib, material_fields, mesh_fields, read_info
from ._core import Context, Handle
from ._status import check

if TYPE_CHECKING:
    from typing import Unpack

    from numpy.typing import ArrayLike

    from . import _fields


def _points(points_rz_m: ArrayLike | None, fields: dict[str, Any], name: str) -> None:
    """Points (n, 2) of a profile, radius and z, into the fields <name>_rz_m and <name>_point_count."""
    if points_rz_m is not None:
        points = as_array(points_rz_m, np.float64, (-1, 2), f"{name}_rz_m")
        fields.update({f"{name}_rz_m": address(points, ctypes.c_double), f"{name}_point_count": len(points)})


class Fixture(Handle):
    """Parts of a luminaire; light leaves along local -Z. add_* return the part's number; their keyword arguments are
    the fields of the C description of the same name. material: a dict of the fields of ups_material_desc, for
    finish=Finish.CUSTOM."""

    _destroy = lib.ups_fixture_destroy

    def __init__(self, context: Context):
        super().__init__(lib.ups_fixture_create, context)

    def _add(self, function: Callable[..., int], cls: type[ctypes.Structure], fields: dict[str, Any],
             material: Mapping[str, Any] | None = None) -> _ffi.FixturePartId:
        if material is not None:
            fields["material"] = ctypes.pointer(describe(_ffi.MaterialDesc, material_fields(material)))
        desc, out = describe(cls, fields), _ffi.FixturePartId()
        check(function(self, byref(desc), byref(out)))
        return out

    def add_emitter(self, **fields: Unpack[_fields.FixtureEmitterDescFields]) -> _ffi.FixturePartId:
        return self._add(lib.ups_fixture_add_emitter, _ffi.FixtureEmitterDesc, {**fields})

    def add_reflector(self, profile_rz_m: ArrayLike | None = None, material: Mapping[str, Any] | None = None,
                      **fields: Unpack[_fields.ReflectorDescFields]) -> _ffi.FixturePartId:
        """profile_rz_m: radius and z of each point of a POLYLINE, (n, 2)."""
        own: dict[str, Any] = {**fields}
        _points(profile_rz_m, own, "profile")
        return self._add(lib.ups_fixture_add_reflector, _ffi.ReflectorDesc, own, material)

    def add_lens(self, material: Mapping[str, Any] | None = None,
                 **fields: Unpack[_fields.LensDescFields]) -> _ffi.FixturePartId:
        return self._add(lib.ups_fixture_add_lens, _ffi.LensDesc, {**fields}, material)

    def add_collimator(self, wall_rz_m: ArrayLike | None = None, material: Mapping[str, Any] | None = None,
                       **fields: Unpack[_fields.CollimatorDescFields]) -> _ffi.FixturePartId:
        """wall_rz_m: radius and z of each point of a POLYLINE, (n, 2)."""
        own: dict[str, Any] = {**fields}
        _points(wall_rz_m, own, "wall")
        return self._add(lib.ups_fixture_add_collimator, _ffi.CollimatorDesc, own, material)

    def add_part(self, positions_m: ArrayLike, indices: ArrayLike, normals: ArrayLike | None = None,
                 material: Mapping[str, Any] | None = None,
                 **fields: Unpack[_fields.FixturePartDescFields]) -> _ffi.FixturePartId:
        """positions_m and normals (n, 3); indices (triangles, 3), counter-clockwise."""
        mesh = ctypes.pointer(describe(_ffi.MeshDesc, mesh_fields(positions_m, indices, normals=normals)))
        return self._add(lib.ups_fixture_add_part, _ffi.FixturePartDesc, {**fields, "mesh": mesh}, material)

    @property
    def info(self) -> _ffi.FixtureInfo:
        return read_info(_ffi.FixtureInfo, lib.ups_fixture_get_info, self)
