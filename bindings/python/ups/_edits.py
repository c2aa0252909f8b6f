"""What was added to a scene is set, asked for and removed, and a commit may run by itself.

A part of ups.Scene.
"""
from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from ctypes import byref
from typing import TYPE_CHECKING, Any, Callable, SupportsIndex, TypeVar

import numpy as np

from . import _ffi
from ._convert import (address, angle_fields, as_array, as_matrix, assign, describe, instance_fields, lib,
                       material_fields, merged, mesh_fields, meter_fields, read_info, target, texture_fields)
from ._core import Handle, pointer_of
from ._ffi import FixtureId, InstanceId, LuminaireId, MaterialId, MeshId, SensorId, TextureId
from ._job import Job
from ._profile import Profile
from ._status import check

if TYPE_CHECKING:
    from typing import Unpack

    from numpy.typing import ArrayLike, NDArray

    from . import _fields

Desc = TypeVar("Desc", bound=ctypes.Structure)

# Arrays of descriptions: their length, and how many numbers each element has.
_ARRAYS: dict[Any, dict[str, tuple[str, int]]] = {
    _ffi.MaterialDesc: {name: ("pane_angle_count", 1) for name in ("pane_angle_deg", "pane_transmittance",
                                                                    "pane_reflectance")},
    _ffi.MeshDesc: {"positions_m": ("vertex_count", 3), "normals": ("vertex_count", 3), "uvs": ("vertex_count", 2),
                    "tangents": ("vertex_count", 4), "indices": ("triangle_count", 3)},
    _ffi.MeterDesc: {name: ("count", 3) for name in ("positions_m", "normals", "tangents")},
    _ffi.GoniometerDesc: {"c_deg": ("c_count", 1), "gamma_deg": ("gamma_count", 1)},
    _ffi.SurfaceMetersDesc: {"instances": ("instance_count", 1)},
    _ffi.LightmapDesc: {"instances": ("instance_count", 1)},
}


class CommitJob(Job):
    """A commit on the library's own threads: as a render's job, without its findings."""


class Edits(Handle):
    """get_X tells the description as it stands, edits that were not committed included, as the C struct with its
    fields; its arrays are copies, numpy's, in the dict `arrays`. set_X takes the arguments of add_X; what is not given
    stays as it is. remove_X: what others still need is not removed. Edits take effect at the next commit."""

    def _get(self, function: Callable[..., int], cls: type[Desc], id: Any) -> Desc:
        _owner = self._as_parameter_  # what another thread closes stays until its arrays are copied
        desc = read_info(cls, function, self, id)
        arrays: dict[str, NDArray[Any]] = {}
        for name, (count, width) in _ARRAYS.get(cls, {}).items():
            pointer, n = getattr(desc, name), getattr(desc, count)
            if pointer and n:
                arrays[name] = np.ctypeslib.as_array(pointer, (n,) if width == 1 else (n, width)).copy()
                setattr(desc, name, address(arrays[name], pointer._type_))
        desc.arrays = arrays
        return desc

    def _set(self, get: Callable[..., int], set_to: Callable[..., int], cls: type[ctypes.Structure], id: Any,
             own: Mapping[str, Any], fields: Mapping[str, Any]) -> None:
        """own: what the method makes of arrays. What is not given is handed back as the library has it, its arrays too,
        whose counts are therefore no caller's to say."""
        desc = read_info(cls, get, self, id)
        assign(desc, merged(own, fields, [count for count, _ in _ARRAYS.get(cls, {}).values()]))
        check(set_to(self, id, byref(desc)))

    # ---- surfaces

    def set_texture(self, texture: TextureId, texels: ArrayLike) -> None:
        check(lib.ups_scene_set_texture(self, texture, byref(describe(_ffi.TextureDesc, texture_fields(texels)))))

    def get_texture(self, texture: TextureId) -> NDArray[np.float32]:
        """Of shape (height, width, channels)."""
        desc, needed = read_info(_ffi.TextureDesc, lib.ups_scene_get_texture, self, texture), ctypes.c_size_t()
        out = np.empty((desc.height, desc.width, desc.channel_count), np.float32)
        check(lib.ups_scene_read_texture(self, texture, target(out, ctypes.c_float), out.size, byref(needed)))
        return out

    def set_material(self, material: MaterialId, pane_angle_deg: ArrayLike | None = None,
                     pane_transmittance: ArrayLike | None = None, pane_reflectance: ArrayLike | None = None,
                     **fields: Unpack[_fields.MaterialDescFields]) -> None:
        """pane_*: all of them are new, or stay."""
        panes = {"pane_angle_deg": pane_angle_deg, "pane_transmittance": pane_transmittance,
                 "pane_reflectance": pane_reflectance}
        new = panes if any(p is not None for p in panes.values()) else {}
        self._set(lib.ups_scene_get_material, lib.ups_scene_set_material, _ffi.MaterialDesc, material,
                  material_fields(new), fields)

    def get_material(self, material: MaterialId) -> _ffi.MaterialDesc:
        return self._get(lib.ups_scene_get_material, _ffi.MaterialDesc, material)

    def set_mesh(self, mesh: MeshId, positions_m: ArrayLike, indices: ArrayLike, material: MaterialId | None = None,
                 normals: ArrayLike | None = None, uvs: ArrayLike | None = None,
                 tangents: ArrayLike | None = None) -> None:
        """Other vertices and triangles; material None: as it is."""
        fields = mesh_fields(positions_m, indices, normals=normals, uvs=uvs, tangents=tangents)
        if material is not None:
            fields["material"] = material
        self._set(lib.ups_scene_get_mesh, lib.ups_scene_set_mesh, _ffi.MeshDesc, mesh, fields, {})

    def set_mesh_vertices(self, mesh: MeshId, positions_m: ArrayLike, normals: ArrayLike | None = None) -> None:
        """As many as the mesh has, (n, 3) both; normals None: as they are."""
        p = as_array(positions_m, np.float32, (-1, 3), "positions_m")
        n = None if normals is None else as_array(normals, np.float32, (len(p), 3), "normals")
        check(lib.ups_scene_set_mesh_vertices(self, mesh, address(p, ctypes.c_float), address(n, ctypes.c_float),
                                              len(p)))

    def get_mesh(self, mesh: MeshId) -> _ffi.MeshDesc:
        return self._get(lib.ups_scene_get_mesh, _ffi.MeshDesc, mesh)

    def set_instance(self, instance: InstanceId, mesh: MeshId | None = None,
                     **fields: Unpack[_fields.InstanceDescFields]) -> None:
        own = {} if mesh is None else {"mesh": mesh}
        self._set(lib.ups_scene_get_instance, lib.ups_scene_set_instance, _ffi.InstanceDesc, instance, own, fields)

    def set_transform(self, instance: InstanceId, to_world: ArrayLike) -> None:
        check(lib.ups_scene_set_transform(self, instance, address(as_matrix(to_world, "to_world"), ctypes.c_double)))

    def get_instance(self, instance: InstanceId) -> _ffi.InstanceDesc:
        return self._get(lib.ups_scene_get_instance, _ffi.InstanceDesc, instance)

    # ---- luminaires

    def set_light(self, light: LuminaireId, **fields: Unpack[_fields.LightDescFields]) -> None:
        self._set(lib.ups_scene_get_light, lib.ups_scene_set_light, _ffi.LightDesc, light, {}, fields)

    def get_light(self, light: LuminaireId) -> _ffi.LightDesc:
        return self._get(lib.ups_scene_get_light, _ffi.LightDesc, light)

    def set_luminaire(self, luminaire: LuminaireId, profile: Profile | None = None,
                      **fields: Unpack[_fields.LuminaireDescFields]) -> None:
        """profile None: as it is."""
        own: dict[str, Any] = {} if profile is None else {"profile": pointer_of(profile, Profile)}
        self._set(lib.ups_scene_get_luminaire, lib.ups_scene_set_luminaire, _ffi.LuminaireDesc, luminaire, own, fields)

    def set_luminaire_transform(self, luminaire: LuminaireId, to_world: ArrayLike) -> None:
        """Of a luminaire or a light."""
        matrix = address(as_matrix(to_world, "to_world"), ctypes.c_double)
        check(lib.ups_scene_set_luminaire_transform(self, luminaire, matrix))

    def set_dimming(self, luminaire: LuminaireId, dimming: float) -> None:
        """Of a luminaire or a light."""
        check(lib.ups_scene_set_dimming(self, luminaire, dimming))

    def get_luminaire(self, luminaire: LuminaireId) -> _ffi.LuminaireDesc:
        """Its profile is None: see get_luminaire_profile."""
        return self._get(lib.ups_scene_get_luminaire, _ffi.LuminaireDesc, luminaire)

    def get_luminaire_profile(self, luminaire: LuminaireId) -> Profile:
        return Profile(lib.ups_scene_get_luminaire_profile, self, luminaire)

    def get_dimming(self, luminaire: LuminaireId) -> float:
        out = ctypes.c_float()
        check(lib.ups_scene_get_dimming(self, luminaire, byref(out)))
        return out.value

    def set_maintenance_factor(self, factor: float) -> None:
        """Multiplies the flux of every luminaire and fixture: above 0, at most 1."""
        check(lib.ups_scene_set_maintenance_factor(self, factor))

    def get_maintenance_factor(self) -> float:
        out = ctypes.c_double()
        check(lib.ups_scene_get_maintenance_factor(self, byref(out)))
        return out.value

    def set_fixture(self, fixture: FixtureId, **fields: Unpack[_fields.FixtureInstanceDescFields]) -> None:
        self._set(lib.ups_scene_get_fixture, lib.ups_scene_set_fixture, _ffi.FixtureInstanceDesc, fixture, {}, fields)

    def set_fixture_transform(self, fixture: FixtureId, to_world: ArrayLike) -> None:
        matrix = address(as_matrix(to_world, "to_world"), ctypes.c_double)
        check(lib.ups_scene_set_fixture_transform(self, fixture, matrix))

    def set_fixture_dimming(self, fixture: FixtureId, dimming: float) -> None:
        check(lib.ups_scene_set_fixture_dimming(self, fixture, dimming))

    def get_fixture(self, fixture: FixtureId) -> _ffi.FixtureInstanceDesc:
        return self._get(lib.ups_scene_get_fixture, _ffi.FixtureInstanceDesc, fixture)

    # ---- sensors

    def set_camera(self, camera: SensorId, width: SupportsIndex | None = None, height: SupportsIndex | None = None,
                   **fields: Unpack[_fields.CameraDescFields]) -> None:
        size = {name: n for name, n in (("width", width), ("height", height)) if n is not None}
        self._set(lib.ups_scene_get_camera, lib.ups_scene_set_camera, _ffi.CameraDesc, camera, size, fields)

    def get_camera(self, camera: SensorId) -> _ffi.CameraDesc:
        return self._get(lib.ups_scene_get_camera, _ffi.CameraDesc, camera)

    def set_meters(self, meters: SensorId, positions_m: ArrayLike | None = None, normals: ArrayLike | None = None,
                   tangents: ArrayLike | None = None, **fields: Unpack[_fields.MeterDescFields]) -> None:
        """The arrays: all of them are new, or stay."""
        own: dict[str, Any] = {}
        if positions_m is not None and normals is not None:
            own = meter_fields(positions_m, normals, tangents)
        elif not (positions_m is None and normals is None and tangents is None):
            raise TypeError("positions_m, normals: both are needed where the arrays are to change")
        self._set(lib.ups_scene_get_meters, lib.ups_scene_set_meters, _ffi.MeterDesc, meters, own, fields)

    def get_meters(self, meters: SensorId) -> _ffi.MeterDesc:
        return self._get(lib.ups_scene_get_meters, _ffi.MeterDesc, meters)

    def set_surface_meters(self, meters: SensorId, instances: Sequence[InstanceId] | None = None,
                           **fields: Unpack[_fields.SurfaceMetersDescFields]) -> None:
        self._set(lib.ups_scene_get_surface_meters, lib.ups_scene_set_surface_meters, _ffi.SurfaceMetersDesc, meters,
                  {} if instances is None else instance_fields(instances), fields)

    def get_surface_meters(self, meters: SensorId) -> _ffi.SurfaceMetersDesc:
        return self._get(lib.ups_scene_get_surface_meters, _ffi.SurfaceMetersDesc, meters)

    def set_lightmap(self, lightmap: SensorId, instances: Sequence[InstanceId] | None = None,
                     width: SupportsIndex | None = None, height: SupportsIndex | None = None,
                     **fields: Unpack[_fields.LightmapDescFields]) -> None:
        own = {name: n for name, n in (("width", width), ("height", height)) if n is not None}
        self._set(lib.ups_scene_get_lightmap, lib.ups_scene_set_lightmap, _ffi.LightmapDesc, lightmap,
                  {**own, **({} if instances is None else instance_fields(instances))}, fields)

    def get_lightmap(self, lightmap: SensorId) -> _ffi.LightmapDesc:
        return self._get(lib.ups_scene_get_lightmap, _ffi.LightmapDesc, lightmap)

    def set_goniometer(self, goniometer: SensorId, c_deg: ArrayLike | None = None, gamma_deg: ArrayLike | None = None,
                       **fields: Unpack[_fields.GoniometerDescFields]) -> None:
        own, rest = angle_fields(c_deg, gamma_deg, fields)
        self._set(lib.ups_scene_get_goniometer, lib.ups_scene_set_goniometer, _ffi.GoniometerDesc, goniometer,
                  own, rest)

    def get_goniometer(self, goniometer: SensorId) -> _ffi.GoniometerDesc:
        return self._get(lib.ups_scene_get_goniometer, _ffi.GoniometerDesc, goniometer)

    def set_observer(self, observer: SensorId, **fields: Unpack[_fields.ObserverDescFields]) -> None:
        self._set(lib.ups_scene_get_observer, lib.ups_scene_set_observer, _ffi.ObserverDesc, observer, {}, fields)

    def get_observer(self, observer: SensorId) -> _ffi.ObserverDesc:
        return self._get(lib.ups_scene_get_observer, _ffi.ObserverDesc, observer)

    # ---- what is not wanted any more

    def remove_texture(self, texture: TextureId) -> None:
        check(lib.ups_scene_remove_texture(self, texture))

    def remove_material(self, material: MaterialId) -> None:
        check(lib.ups_scene_remove_material(self, material))

    def remove_mesh(self, mesh: MeshId) -> None:
        check(lib.ups_scene_remove_mesh(self, mesh))

    def remove_instance(self, instance: InstanceId) -> None:
        check(lib.ups_scene_remove_instance(self, instance))

    def remove_luminaire(self, luminaire: LuminaireId) -> None:
        """Or a light."""
        check(lib.ups_scene_remove_luminaire(self, luminaire))

    def remove_fixture(self, fixture: FixtureId) -> None:
        check(lib.ups_scene_remove_fixture(self, fixture))

    def remove_sensor(self, sensor: SensorId) -> None:
        check(lib.ups_scene_remove_sensor(self, sensor))
