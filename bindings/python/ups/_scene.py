"""What is there to light and to measure: materials, meshes, luminaires, fixtures and sensors; commit and render.

Used by programs, as ups.Scene.
"""
import ctypes
import math
from ctypes import byref

import numpy as np

from . import _ffi
from ._core import (Handle, address, as_array, as_matrix, check, create, describe, describe_mesh, lib, read_array,
                    read_info, read_text)
from ._ffi import SceneText
from ._profile import Profile
from ._result import Job, ReplayedPath, Result


class Scene(Handle):
    """Description of what there is. add_* return ids of this scene; changes take effect at the next commit."""

    def __init__(self, context):
        super().__init__(create(lib.ups_scene_create, context), lib.ups_scene_destroy)
        self._shapes = {}  # of each sensor's results: (height, width) or (count,)

    def _add(self, function, id_type, desc):
        out = id_type()
        check(function(self, byref(desc), byref(out)))
        return out

    def add_texture(self, texels):
        """Of shape (height, width) or (height, width, channels); linear; row 0 first."""
        t = np.ascontiguousarray(texels, dtype=np.float32)
        t = as_array(t[:, :, None] if t.ndim == 2 else t, np.float32, (-1, -1, -1), "texels")
        desc = describe(_ffi.TextureDesc, {"width": t.shape[1], "height": t.shape[0], "channel_count": t.shape[2],
                                           "texels": address(t, ctypes.c_float)})
        return self._add(lib.ups_scene_add_texture, _ffi.TextureId, desc)

    def add_material(self, **fields):
        return self._add(lib.ups_scene_add_material, _ffi.MaterialId, describe(_ffi.MaterialDesc, fields))

    def add_mesh(self, positions_m, indices, material, normals=None, uvs=None, tangents=None):
        """positions_m and normals (n, 3), uvs (n, 2), tangents (n, 4); indices (triangles, 3), counter-clockwise."""
        desc = describe_mesh(positions_m, indices, normals=normals, uvs=uvs, tangents=tangents, material=material)
        return self._add(lib.ups_scene_add_mesh, _ffi.MeshId, desc)

    def add_instance(self, mesh, **fields):
        desc = describe(_ffi.InstanceDesc, {"mesh": mesh, **fields})
        return self._add(lib.ups_scene_add_instance, _ffi.InstanceId, desc)

    def add_light(self, **fields):
        return self._add(lib.ups_scene_add_light, _ffi.LuminaireId, describe(_ffi.LightDesc, fields))

    def add_luminaire(self, profile, **fields):
        desc = describe(_ffi.LuminaireDesc, {"profile": profile._as_parameter_, **fields})
        return self._add(lib.ups_scene_add_luminaire, _ffi.LuminaireId, desc)

    def add_fixture(self, fixture, **fields):
        """Places a Fixture as it is now, which may be changed or closed afterwards."""
        desc, out = describe(_ffi.FixtureInstanceDesc, fields), _ffi.FixtureId()
        check(lib.ups_scene_add_fixture(self, fixture, byref(desc), byref(out)))
        return out

    def fixture_instance(self, fixture, part):
        """The instance that a part of a placed fixture became; part: what Fixture.add_* returned."""
        out = _ffi.InstanceId()
        check(lib.ups_scene_get_fixture_instance(self, fixture, part, byref(out)))
        return out

    def add_camera(self, width, height, **fields):
        desc = describe(_ffi.CameraDesc, {"width": width, "height": height, **fields})
        sensor = self._add(lib.ups_scene_add_camera, _ffi.SensorId, desc)
        self._shapes[sensor.v] = (height, width)
        return sensor

    def add_meters(self, positions_m, normals, tangents=None, **fields):
        """All three (n, 3); one normal may stand for all meters. Readings keep the order."""
        p = as_array(positions_m, np.float64, (-1, 3), "positions_m")
        n = as_array(np.broadcast_to(np.asarray(normals, np.float32), p.shape), np.float32, (-1, 3), "normals")
        t = None
        if tangents is not None:
            t = as_array(np.broadcast_to(np.asarray(tangents, np.float32), p.shape), np.float32, (-1, 3), "tangents")
        desc = describe(_ffi.MeterDesc, {"positions_m": address(p, ctypes.c_double),
                                         "normals": address(n, ctypes.c_float), "count": len(p), **fields})
        if t is not None:
            desc.tangents = address(t, ctypes.c_float)
        sensor = self._add(lib.ups_scene_add_meters, _ffi.SensorId, desc)
        self._shapes[sensor.v] = (len(p),)
        return sensor

    def add_goniometer(self, c_deg=None, gamma_deg=None, **fields):
        """Light that leaves the scene, by direction. Angles ascending, of shape (n,); or equal steps, so many as the
        fields c_count and gamma_count say."""
        for name, values in (("c", c_deg), ("gamma", gamma_deg)):
            if values is not None:
                angles = as_array(values, np.float32, (-1,), f"{name}_deg")
                fields.update({f"{name}_deg": address(angles, ctypes.c_float), f"{name}_count": len(angles)})
        return self._add(lib.ups_scene_add_goniometer, _ffi.SensorId, describe(_ffi.GoniometerDesc, fields))

    def set_material(self, material, **fields):
        """Fields that are not given take the library's defaults."""
        check(lib.ups_scene_set_material(self, material, byref(describe(_ffi.MaterialDesc, fields))))

    def set_transform(self, instance, to_world):
        check(lib.ups_scene_set_transform(self, instance, address(as_matrix(to_world, "to_world"), ctypes.c_double)))

    def set_dimming(self, luminaire, dimming):
        check(lib.ups_scene_set_dimming(self, luminaire, dimming))

    def set_maintenance_factor(self, factor):
        """Multiplies the flux of every luminaire and fixture: above 0, at most 1."""
        check(lib.ups_scene_set_maintenance_factor(self, factor))

    def set_fixture_transform(self, fixture, to_world):
        matrix = address(as_matrix(to_world, "to_world"), ctypes.c_double)
        check(lib.ups_scene_set_fixture_transform(self, fixture, matrix))

    def set_fixture_dimming(self, fixture, dimming):
        check(lib.ups_scene_set_fixture_dimming(self, fixture, dimming))

    def remove_instance(self, instance):
        check(lib.ups_scene_remove_instance(self, instance))

    def remove_luminaire(self, luminaire):
        check(lib.ups_scene_remove_luminaire(self, luminaire))

    def remove_fixture(self, fixture):
        check(lib.ups_scene_remove_fixture(self, fixture))

    def remove_sensor(self, sensor):
        check(lib.ups_scene_remove_sensor(self, sensor))

    def commit(self):
        check(lib.ups_scene_commit(self))

    @property
    def info(self):
        return read_info(_ffi.SceneInfo, lib.ups_scene_get_info, self)

    def text(self, topic=SceneText.WARNINGS):
        return read_text(lib.ups_scene_get_text, self, topic)

    def section(self, point_m, normal):
        """Where a plane cuts the committed scene's surfaces: an array (segments, 2, 3), m."""
        return self._segments(lib.ups_scene_read_section, point_m, normal)

    def outlines(self, point_m, normal, depth_m=math.inf):
        """Edges of surfaces that are seen beneath a plane, as ups_scene_read_outlines: an array (segments, 2, 3), m."""
        return self._segments(lib.ups_scene_read_outlines, point_m, normal, depth_m)

    def _segments(self, read, point_m, normal, *more):
        at = address(as_array(point_m, np.float64, (3,), "point_m"), ctypes.c_double)
        to = address(as_array(normal, np.float64, (3,), "normal"), ctypes.c_double)
        segments = read_array(_ffi.Segment, read, self, at, to, *more)
        return np.stack([segments["from_m"], segments["to_m"]], axis=1)

    def sources(self):
        """A ups_scene_source of each luminaire, light and emissive instance of the committed scene: kind, id, group,
        light_kind, flux_lm, to_world, bounds_min_m, bounds_max_m."""
        count = ctypes.c_uint32()
        check(lib.ups_scene_get_source_count(self, byref(count)))
        return [read_info(_ffi.SceneSource, lib.ups_scene_get_source, self, i) for i in range(count.value)]

    def source_profile(self, index):
        """The Profile of a luminaire, by its index in sources()."""
        return Profile(create(lib.ups_scene_get_source_profile, self, index))

    def replay(self, sample, **fields):
        """Traces one of Result.largest_samples again, as a ReplayedPath; fields: those of the render that it is of."""
        own = _ffi.Sample.from_buffer_copy(np.asarray(sample, dtype=np.dtype(_ffi.Sample)).tobytes())
        desc = describe(_ffi.RenderDesc, fields)
        return ReplayedPath(create(lib.ups_replay, self, byref(desc), byref(own)))

    def render(self, **fields):
        """Blocks until a limit or the target is met; an interrupt of the program waits as long. See start."""
        desc = describe(_ffi.RenderDesc, fields)
        return Result(create(lib.ups_render, self, byref(desc)), dict(self._shapes))

    def start(self, **fields):
        """The same as a Job, which can be watched and cancelled."""
        desc = describe(_ffi.RenderDesc, fields)
        return Job(create(lib.ups_job_start, self, byref(desc)), dict(self._shapes))

    def estimate_memory(self, **fields):
        """What a render with these fields will take, as ups_memory_estimate: scene_bytes, working_bytes, light_bytes,
        result_bytes, peak_bytes in all, and allowed_bytes. Takes as long as a render's preparations."""
        desc = describe(_ffi.RenderDesc, fields)
        return read_info(_ffi.MemoryEstimate, lib.ups_scene_estimate_memory, self, byref(desc))
