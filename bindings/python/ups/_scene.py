"""What is there to light and to measure: materials, meshes, luminaires, fixtures and sensors; commit and render.

Used by programs, as ups.Scene.
"""
from __future__ import annotations

import ctypes
import math
import os
from collections.abc import Sequence
from ctypes import byref
from typing import TYPE_CHECKING, Any, Callable, SupportsIndex, TypeVar

import numpy as np

from . import _ffi
from ._convert import (address, angle_fields, as_array, describe, dtype_of, instance_fields, lib, material_fields,
                       merged, mesh_fields, meter_fields, read_array, read_count, read_info, read_text, texture_fields)
from ._core import Context, pointer_of
from ._edits import CommitJob, Edits
from ._ffi import (FixtureId, FixturePartId, InstanceId, LuminaireId, MaterialId, MeshId, SceneText, SensorId,
                   TextureId)
from ._fixture import Fixture
from ._gltf import GltfImport
from ._job import Job, Watcher, render
from ._profile import Profile
from ._result import ReplayedPath, Result
from ._status import Error, check

if TYPE_CHECKING:
    from typing import Unpack

    from numpy.typing import ArrayLike, NDArray

    from . import _fields

AnyId = TypeVar("AnyId", bound=ctypes.Structure)


class Scene(Edits):
    """Description of what there is. add_* return ids of this scene; changes take effect at the next commit."""

    _destroy = lib.ups_scene_destroy

    def __init__(self, context: Context):
        super().__init__(lib.ups_scene_create, context)
        self._context = context._as_parameter_  # which stays where the Context is closed

    def _add(self, function: Callable[..., int], id_type: type[AnyId], desc: ctypes.Structure) -> AnyId:
        out = id_type()
        check(function(self, byref(desc), byref(out)))
        return out

    def import_gltf(self, path: str | os.PathLike[str],
                    **fields: Unpack[_fields.GltfImportDescFields]) -> GltfImport:
        """Adds all of a glTF file (.gltf, .glb): surfaces, materials, luminaires, sensors, which have their names in
        the answer. After an error the scene holds part of the file: close it."""
        return GltfImport(self._context, self, path, fields)

    def add_texture(self, texels: ArrayLike) -> TextureId:
        """Of shape (height, width) or (height, width, channels); linear; row 0 first."""
        return self._add(lib.ups_scene_add_texture, TextureId, describe(_ffi.TextureDesc, texture_fields(texels)))

    def add_material(self, pane_angle_deg: ArrayLike | None = None, pane_transmittance: ArrayLike | None = None,
                     pane_reflectance: ArrayLike | None = None,
                     **fields: Unpack[_fields.MaterialDescFields]) -> MaterialId:
        """pane_*: of a pane measured by angle, three arrays of one length."""
        panes = {"pane_angle_deg": pane_angle_deg, "pane_transmittance": pane_transmittance,
                 "pane_reflectance": pane_reflectance}
        desc = describe(_ffi.MaterialDesc, material_fields({**panes, **fields}))
        return self._add(lib.ups_scene_add_material, MaterialId, desc)

    def add_mesh(self, positions_m: ArrayLike, indices: ArrayLike, material: MaterialId,
                 normals: ArrayLike | None = None, uvs: ArrayLike | None = None,
                 tangents: ArrayLike | None = None) -> MeshId:
        """positions_m and normals (n, 3), uvs (n, 2), tangents (n, 4); indices (triangles, 3), counter-clockwise.
        Floats of 32 bits are read where they are, from columns of a larger array too; anything else is copied."""
        fields = mesh_fields(positions_m, indices, normals=normals, uvs=uvs, tangents=tangents, material=material)
        return self._add(lib.ups_scene_add_mesh, MeshId, describe(_ffi.MeshDesc, fields))

    def add_instance(self, mesh: MeshId, **fields: Unpack[_fields.InstanceDescFields]) -> InstanceId:
        desc = describe(_ffi.InstanceDesc, {"mesh": mesh, **fields})
        return self._add(lib.ups_scene_add_instance, InstanceId, desc)

    def add_light(self, **fields: Unpack[_fields.LightDescFields]) -> LuminaireId:
        return self._add(lib.ups_scene_add_light, LuminaireId, describe(_ffi.LightDesc, fields))

    def add_luminaire(self, profile: Profile, **fields: Unpack[_fields.LuminaireDescFields]) -> LuminaireId:
        desc = describe(_ffi.LuminaireDesc, {"profile": pointer_of(profile, Profile), **fields})
        return self._add(lib.ups_scene_add_luminaire, LuminaireId, desc)

    def add_fixture(self, fixture: Fixture, **fields: Unpack[_fields.FixtureInstanceDescFields]) -> FixtureId:
        """Places a Fixture as it is now, which may be changed or closed afterwards."""
        desc, out = describe(_ffi.FixtureInstanceDesc, fields), FixtureId()
        check(lib.ups_scene_add_fixture(self, fixture, byref(desc), byref(out)))
        return out

    def fixture_instance(self, fixture: FixtureId, part: FixturePartId) -> InstanceId:
        """The instance that a part of a placed fixture became; part: what Fixture.add_* returned."""
        out = InstanceId()
        check(lib.ups_scene_get_fixture_instance(self, fixture, part, byref(out)))
        return out

    def add_camera(self, width: SupportsIndex, height: SupportsIndex,
                   **fields: Unpack[_fields.CameraDescFields]) -> SensorId:
        desc = describe(_ffi.CameraDesc, {"width": width, "height": height, **fields})
        return self._add(lib.ups_scene_add_camera, SensorId, desc)

    def add_meters(self, positions_m: ArrayLike, normals: ArrayLike, tangents: ArrayLike | None = None,
                   **fields: Unpack[_fields.MeterDescFields]) -> SensorId:
        """All three (n, 3); one normal may stand for all meters. Readings keep the order. kind: a MeterKind."""
        desc = describe(_ffi.MeterDesc, merged(meter_fields(positions_m, normals, tangents), fields))
        return self._add(lib.ups_scene_add_meters, SensorId, desc)

    def _add_on(self, function: Callable[..., int], desc_type: Any, instances: Sequence[InstanceId],
                fields: dict[str, Any]) -> SensorId:
        return self._add(function, SensorId, describe(desc_type, merged(instance_fields(instances), fields)))

    def add_surface_meters(self, instances: Sequence[InstanceId],
                           **fields: Unpack[_fields.SurfaceMetersDescFields]) -> SensorId:
        """One planar meter for each triangle of the instances, counted through them; back=1: on their backs."""
        return self._add_on(lib.ups_scene_add_surface_meters, _ffi.SurfaceMetersDesc, instances, {**fields})

    def add_lightmap(self, instances: Sequence[InstanceId], width: SupportsIndex, height: SupportsIndex,
                     **fields: Unpack[_fields.LightmapDescFields]) -> SensorId:
        """One planar meter for each texel of the instances' UVs; readings have row 0, at v = 0, first."""
        return self._add_on(lib.ups_scene_add_lightmap, _ffi.LightmapDesc, instances,
                            {"width": width, "height": height, **fields})

    def add_goniometer(self, c_deg: ArrayLike | None = None, gamma_deg: ArrayLike | None = None,
                       **fields: Unpack[_fields.GoniometerDescFields]) -> SensorId:
        """Light that leaves the scene, by direction. Angles ascending, of shape (n,); or equal steps, so many as the
        fields c_count and gamma_count say."""
        own, rest = angle_fields(c_deg, gamma_deg, fields)
        return self._add(lib.ups_scene_add_goniometer, SensorId, describe(_ffi.GoniometerDesc, merged(own, rest)))

    def add_observer(self, **fields: Unpack[_fields.ObserverDescFields]) -> SensorId:
        """An eye whose glare is rated; its meter's readings are those of a set of one."""
        return self._add(lib.ups_scene_add_observer, SensorId, describe(_ffi.ObserverDesc, fields))

    def commit(self) -> None:
        check(lib.ups_scene_commit(self))

    def start_commit(self, **fields: Unpack[_fields.CommitDescFields]) -> CommitJob:
        """A commit of the scene as it is now, by itself: edits go on meanwhile and belong to the next one. Its watch,
        wait and poll tell of its end; the scene renders as before until then. One at a time. thread_limit and priority
        as of start, memory_limit_bytes of the index of surfaces."""
        desc = describe(_ffi.CommitDesc, fields)
        return CommitJob(lib.ups_scene_start_commit_with, self, byref(desc))

    @property
    def is_dirty(self) -> bool:
        """Whether there are edits that no commit has taken, or there was no commit."""
        out = ctypes.c_int32()
        check(lib.ups_scene_is_dirty(self, byref(out)))
        return bool(out.value)

    @property
    def info(self) -> _ffi.SceneInfo:
        return read_info(_ffi.SceneInfo, lib.ups_scene_get_info, self)

    def text(self, topic: SceneText = SceneText.WARNINGS) -> str:
        return read_text(lib.ups_scene_get_text, self, topic)

    def meter_places(self, sensor: SensorId) -> NDArray[np.void]:
        """What each meter of the committed scene measures: a record array with the fields of ups_meter_place."""
        return read_array(_ffi.MeterPlace, lib.ups_scene_read_meter_places, self, sensor)

    def section(self, point_m: ArrayLike, normal: ArrayLike) -> NDArray[np.float64]:
        """Where a plane cuts the committed scene's surfaces: an array (segments, 2, 3), m."""
        return self._segments(lib.ups_scene_read_section, point_m, normal)

    def outlines(self, point_m: ArrayLike, normal: ArrayLike, depth_m: float = math.inf) -> NDArray[np.float64]:
        """Edges of surfaces that are seen beneath a plane, as ups_scene_read_outlines: an array (segments, 2, 3), m."""
        return self._segments(lib.ups_scene_read_outlines, point_m, normal, depth_m)

    def _segments(self, read: Callable[..., int], point_m: ArrayLike, normal: ArrayLike,
                  *more: float) -> NDArray[np.float64]:
        at = address(as_array(point_m, np.float64, (3,), "point_m"), ctypes.c_double)
        to = address(as_array(normal, np.float64, (3,), "normal"), ctypes.c_double)
        segments = read_array(_ffi.Segment, read, self, at, to, *more)
        return np.stack([segments["from_m"], segments["to_m"]], axis=1)

    def sources(self) -> list[_ffi.SceneSource]:
        """A ups_scene_source of each luminaire, light and emissive instance of the committed scene: kind, id, group,
        light_kind, flux_lm, to_world, bounds_min_m, bounds_max_m."""
        while True:  # a commit that comes between may number them anew
            revision = self.info.revision
            try:
                count = read_count(lib.ups_scene_get_source_count, self)
                all_sources = [read_info(_ffi.SceneSource, lib.ups_scene_get_source, self, i) for i in range(count)]
            except Error:
                if self.info.revision == revision:
                    raise
            else:
                if self.info.revision == revision:
                    return all_sources

    def source_profile(self, index: int) -> Profile:
        """The Profile of a luminaire, by its index in sources()."""
        return Profile(lib.ups_scene_get_source_profile, self, index)

    def replay(self, sample: Any, **fields: Unpack[_fields.RenderDescFields]) -> ReplayedPath:
        """Traces one of Result.largest_samples again, as a ReplayedPath; fields: those of the render that it is of."""
        one = np.asarray(sample, dtype=dtype_of(_ffi.Sample))
        if one.size != 1:
            raise ValueError(f"sample: expected one of Result.largest_samples, got {one.size}")
        own = _ffi.Sample.from_buffer_copy(one.tobytes())
        desc = describe(_ffi.RenderDesc, fields)
        return ReplayedPath(lib.ups_replay, self, byref(desc), byref(own))

    def render(self, progress: Watcher = False, **fields: Unpack[_fields.RenderDescFields]) -> Result:
        """Blocks until a limit or the target is met; progress: as of Job.watch. Ctrl-C ends it: the result has what
        whole iterations have found, with its errors, and is `interrupted`. A second Ctrl-C, or one before the first
        iteration is done, raises KeyboardInterrupt."""
        return render(self.start(**fields), progress)

    def start(self, **fields: Unpack[_fields.RenderDescFields]) -> Job:
        """The same as a Job, which can be watched and cancelled."""
        desc = describe(_ffi.RenderDesc, fields)
        return Job(lib.ups_job_start, self, byref(desc))

    def estimate_memory(self, **fields: Unpack[_fields.RenderDescFields]) -> _ffi.MemoryEstimate:
        """What a render with these fields will take, as ups_memory_estimate: scene_bytes, working_bytes, light_bytes,
        result_bytes, peak_bytes in all, and allowed_bytes. Takes as long as a render's preparations."""
        desc = describe(_ffi.RenderDesc, fields)
        return read_info(_ffi.MemoryEstimate, lib.ups_scene_estimate_memory, self, byref(desc))
