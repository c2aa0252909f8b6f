"""What is a luminaire made of: emitters, reflectors, lenses, collimators and meshes, in a frame of their own.

Used by programs, as ups.Fixture; Scene.add_fixture places it.
"""
import ctypes
from ctypes import byref

import numpy as np

from . import _ffi
from ._core import Handle, address, as_array, check, create, describe, describe_mesh, lib, read_info


def _points(points_rz_m, fields, name):
    """Points (n, 2) of a profile, radius and z, into the fields <name>_rz_m and <name>_point_count."""
    if points_rz_m is not None:
        points = as_array(points_rz_m, np.float64, (-1, 2), f"{name}_rz_m")
        fields.update({f"{name}_rz_m": address(points, ctypes.c_double), f"{name}_point_count": len(points)})


class Fixture(Handle):
    """Parts of a luminaire; light leaves along local -Z. add_* return the part's number; their keyword arguments are
    the fields of the C description of the same name. material: a dict of the fields of ups_material_desc, for
    finish=Finish.CUSTOM."""

    def __init__(self, context):
        super().__init__(create(lib.ups_fixture_create, context), lib.ups_fixture_destroy)

    def _add(self, function, cls, fields, material=None):
        if material is not None:
            fields["material"] = ctypes.pointer(describe(_ffi.MaterialDesc, material))
        desc, out = describe(cls, fields), _ffi.FixturePartId()
        check(function(self, byref(desc), byref(out)))
        return out

    def add_emitter(self, **fields):
        return self._add(lib.ups_fixture_add_emitter, _ffi.FixtureEmitterDesc, fields)

    def add_reflector(self, profile_rz_m=None, material=None, **fields):
        """profile_rz_m: radius and z of each point of a POLYLINE, (n, 2)."""
        _points(profile_rz_m, fields, "profile")
        return self._add(lib.ups_fixture_add_reflector, _ffi.ReflectorDesc, fields, material)

    def add_lens(self, material=None, **fields):
        return self._add(lib.ups_fixture_add_lens, _ffi.LensDesc, fields, material)

    def add_collimator(self, wall_rz_m=None, material=None, **fields):
        """wall_rz_m: radius and z of each point of a POLYLINE, (n, 2)."""
        _points(wall_rz_m, fields, "wall")
        return self._add(lib.ups_fixture_add_collimator, _ffi.CollimatorDesc, fields, material)

    def add_part(self, positions_m, indices, normals=None, material=None, **fields):
        """positions_m and normals (n, 3); indices (triangles, 3), counter-clockwise."""
        mesh = describe_mesh(positions_m, indices, normals=normals)
        fields["mesh"] = ctypes.pointer(mesh)
        return self._add(lib.ups_fixture_add_part, _ffi.FixturePartDesc, fields, material)

    @property
    def info(self):
        return read_info(_ffi.FixtureInfo, lib.ups_fixture_get_info, self)
