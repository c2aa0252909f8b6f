"""UPS for Python: illuminance and luminance by Unified Path Sampling.

    context = ups.Context()
    scene = ups.Scene(context)
    white = scene.add_material(reflectance_rgb=(0.8, 0.8, 0.8))
    ...
    scene.commit()
    result = scene.render(iteration_count=100)
    result.meters(sensor)["illuminance_lx"]

The names, units and defaults are those of the C headers (include/ups), where each function and field is described:
keyword arguments are the fields of the C description of the same name. Arrays are numpy's, in and out. Every failure
raises ups.Error. Objects free themselves; close() or a `with` block does it at once, in any order.
"""
import ctypes
import weakref
from ctypes import byref

import numpy as np

from . import _ffi, _library
from ._ffi import (AlphaMode, Channel, Contribution, Effect, JobState, LightKind, LogLevel, MaterialModel, MeterKind, Method,
                   OpeningShape, Perturbation, ProfileFormat, ProfileSymmetry, Projection, ResultText, SceneText, Status,
                   Technique)

__all__ = ["AlphaMode", "Channel", "Context", "Contribution", "Effect", "Error", "Job", "JobState", "LightKind", "LogLevel",
           "MaterialModel", "MeterKind", "Method", "OpeningShape", "Perturbation", "Profile", "ProfileFormat", "ProfileSymmetry",
           "Projection", "Result", "ResultText", "Scene", "SceneText", "Status", "Technique", "translation", "version"]

_lib = _library.load()


class Error(Exception):
    """A failed call: `status` says which kind, the message what was wrong, where, and what would be right."""

    def __init__(self, status, message):
        super().__init__(message)
        self.status = status

    def __str__(self):
        return f"{self.status.name}: {super().__str__()}"


def _check(status):
    """Failures are negative; TIMEOUT and CANCELLED are answers."""
    if status < 0:
        raise Error(Status(status), _lib.ups_last_error().decode("utf-8", "replace"))
    return Status(status)


def version():
    """(major, minor, patch) of the loaded library."""
    v = _lib.ups_version()
    return v // 10000, v // 100 % 100, v % 100


def translation(x, y, z):
    """A transform, 3x4, that only moves."""
    return np.array([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z]], dtype=float)


# ---- from Python values to C fields


def _matrix(to_world):
    m = np.asarray(to_world, dtype=np.float64)
    if m.shape == (4, 4):
        if not np.array_equal(m[3], (0, 0, 0, 1)):
            raise ValueError("to_world: the last row of a 4x4 transform must be 0 0 0 1")
        m = m[:3]
    if m.shape not in ((3, 4), (12,)):
        raise ValueError(f"to_world: expected 3x4 or 4x4 (row-major, object to world), got shape {m.shape}")
    return m.ravel()


def _array(values, dtype, shape, name):
    """A contiguous copy or view of the given shape; -1 stands for any length."""
    a = np.ascontiguousarray(values, dtype=dtype)
    if a.ndim != len(shape) or any(want not in (-1, have) for want, have in zip(shape, a.shape)):
        wanted = ", ".join("n" if s == -1 else str(s) for s in shape)
        raise ValueError(f"{name}: expected an array of shape ({wanted}), got {a.shape}")
    return a


def _pointer(array, ctype):
    return None if array is None else array.ctypes.data_as(ctypes.POINTER(ctype))


def _describe(cls, fields):
    """A C description with the library's defaults, then with `fields`."""
    desc = cls()
    getattr(_lib, _ffi.INIT[cls])(byref(desc), ctypes.sizeof(desc))
    known = {name: kind for name, kind in cls._fields_ if name not in ("struct_size", "reserved")}
    for name, value in fields.items():
        if name not in known:
            raise TypeError(f"unknown field {name!r}; there are: {', '.join(known)}")
        if name == "to_world":
            value = _matrix(value)
        if issubclass(known[name], ctypes.Array):
            value = np.asarray(value, dtype=float).tolist()
            if len(value) != known[name]._length_:
                raise ValueError(f"{name}: expected {known[name]._length_} values, got {len(value)}")
            value = known[name](*value)
        setattr(desc, name, value)
    return desc


def _info(cls, function, *arguments):
    info = cls()
    info.struct_size = ctypes.sizeof(info)
    _check(function(*arguments, byref(info)))
    return info


def _text(function, *arguments):
    """The two calls that every text takes: its size, then its bytes."""
    needed = ctypes.c_size_t()
    _check(function(*arguments, None, 0, byref(needed)))
    if needed.value == 0:
        return ""
    buffer = ctypes.create_string_buffer(needed.value)
    _check(function(*arguments, buffer, needed.value, byref(needed)))
    return buffer.value.decode("utf-8", "replace")


class _Handle:
    """Owns a handle of the library, which it destroys once."""

    def __init__(self, pointer, destroy):
        self._as_parameter_ = pointer
        self._destroy = weakref.finalize(self, destroy, pointer)

    def close(self):
        self._destroy()
        self._as_parameter_ = None  # the library answers any later call with INVALID_ARGUMENT

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def _create(function, *arguments):
    pointer = ctypes.c_void_p()
    _check(function(*arguments, byref(pointer)))
    return pointer


class Context(_Handle):
    """Threads and log. thread_count 0: all hardware threads."""

    def __init__(self, thread_count=0):
        desc = _describe(_ffi.ContextDesc, {"thread_count": thread_count})
        super().__init__(_create(_lib.ups_context_create, byref(desc)), _lib.ups_context_destroy)

    @property
    def thread_count(self):
        count = ctypes.c_int32()
        _check(_lib.ups_context_get_thread_count(self, byref(count)))
        return count.value

    def pop_log(self):
        """Takes all messages out of the log: a list of (LogLevel, text), oldest first."""
        messages = []
        needed, level = ctypes.c_size_t(), ctypes.c_int32()
        while True:
            _check(_lib.ups_context_pop_log(self, None, 0, byref(needed), None))
            if needed.value == 0:
                return messages
            buffer = ctypes.create_string_buffer(needed.value)
            status = _lib.ups_context_pop_log(self, buffer, needed.value, byref(needed), byref(level))
            if status == Status.ERROR_BUFFER_TOO_SMALL:  # another thread took that message; look at the next one
                continue
            _check(status)
            if needed.value:
                messages.append((LogLevel(level.value), buffer.value.decode("utf-8", "replace")))


class Profile(_Handle):
    """One luminous intensity distribution; immutable. Made by parse or from_table."""

    def __init__(self, pointer):
        super().__init__(pointer, _lib.ups_profile_destroy)

    @classmethod
    def parse(cls, context, data, format=ProfileFormat.AUTO):
        """From the bytes of a photometric file."""
        data = bytes(data)
        return cls(_create(_lib.ups_profile_parse, context, data, len(data), format))

    @classmethod
    def from_table(cls, context, c_deg, gamma_deg, intensity_cd):
        """From intensities of shape (len(c_deg), len(gamma_deg))."""
        c, gamma = _array(c_deg, np.float32, (-1,), "c_deg"), _array(gamma_deg, np.float32, (-1,), "gamma_deg")
        table = _array(intensity_cd, np.float32, (len(c), len(gamma)), "intensity_cd")
        desc = _describe(_ffi.ProfileDesc, {
            "c_count": len(c), "gamma_count": len(gamma), "c_deg": _pointer(c, ctypes.c_float),
            "gamma_deg": _pointer(gamma, ctypes.c_float), "intensity_cd": _pointer(table, ctypes.c_float)})
        return cls(_create(_lib.ups_profile_create, context, byref(desc)))

    @property
    def info(self):
        return _info(_ffi.ProfileInfo, _lib.ups_profile_get_info, self)

    @property
    def warnings(self):
        return _text(_lib.ups_profile_get_text, self, _ffi.ProfileText.WARNINGS).splitlines()

    @property
    def keywords(self):
        """The file's keywords, a line each: MANUFAC=..."""
        return _text(_lib.ups_profile_get_text, self, _ffi.ProfileText.KEYWORDS).splitlines()

    @property
    def format(self):
        return _text(_lib.ups_profile_get_text, self, _ffi.ProfileText.FORMAT)

    def intensity_cd(self, directions):
        """In each direction of an (n, 3) array, in the profile's frame: nadir -Z, C0 +X, C90 +Y."""
        d = _array(directions, np.float32, (-1, 3), "directions")
        out = np.empty(len(d), dtype=np.float32)
        _check(_lib.ups_profile_eval(self, _pointer(d, ctypes.c_float), len(d), _pointer(out, ctypes.c_float)))
        return out


class Scene(_Handle):
    """Description of what there is. add_* return ids of this scene; changes take effect at the next commit."""

    def __init__(self, context):
        super().__init__(_create(_lib.ups_scene_create, context), _lib.ups_scene_destroy)
        self._shapes = {}  # of each sensor's results: (height, width) or (count,)

    def _add(self, function, id_type, desc):
        out = id_type()
        _check(function(self, byref(desc), byref(out)))
        return out

    def add_texture(self, texels):
        """Of shape (height, width) or (height, width, channels); linear; row 0 first."""
        t = np.ascontiguousarray(texels, dtype=np.float32)
        t = _array(t[:, :, None] if t.ndim == 2 else t, np.float32, (-1, -1, -1), "texels")
        desc = _describe(_ffi.TextureDesc, {"width": t.shape[1], "height": t.shape[0], "channel_count": t.shape[2],
                                            "texels": _pointer(t, ctypes.c_float)})
        return self._add(_lib.ups_scene_add_texture, _ffi.TextureId, desc)

    def add_material(self, **fields):
        return self._add(_lib.ups_scene_add_material, _ffi.MaterialId, _describe(_ffi.MaterialDesc, fields))

    def add_mesh(self, positions_m, indices, material, normals=None, uvs=None, tangents=None):
        """positions_m and normals (n, 3), uvs (n, 2), tangents (n, 4); indices (triangles, 3), counter-clockwise."""
        p = _array(positions_m, np.float32, (-1, 3), "positions_m")
        i = _array(indices, np.uint32, (-1, 3), "indices")
        fields = {"vertex_count": len(p), "triangle_count": len(i), "material": material,
                  "positions_m": _pointer(p, ctypes.c_float), "indices": _pointer(i, ctypes.c_uint32)}
        keep = []  # alive until the library has copied them
        for name, values, width in (("normals", normals, 3), ("uvs", uvs, 2), ("tangents", tangents, 4)):
            if values is not None:
                keep.append(_array(values, np.float32, (len(p), width), name))
                fields[name] = _pointer(keep[-1], ctypes.c_float)
        return self._add(_lib.ups_scene_add_mesh, _ffi.MeshId, _describe(_ffi.MeshDesc, fields))

    def add_instance(self, mesh, **fields):
        desc = _describe(_ffi.InstanceDesc, {"mesh": mesh, **fields})
        return self._add(_lib.ups_scene_add_instance, _ffi.InstanceId, desc)

    def add_light(self, **fields):
        return self._add(_lib.ups_scene_add_light, _ffi.LuminaireId, _describe(_ffi.LightDesc, fields))

    def add_luminaire(self, profile, **fields):
        desc = _describe(_ffi.LuminaireDesc, {"profile": profile._as_parameter_, **fields})
        return self._add(_lib.ups_scene_add_luminaire, _ffi.LuminaireId, desc)

    def add_camera(self, width, height, **fields):
        desc = _describe(_ffi.CameraDesc, {"width": width, "height": height, **fields})
        sensor = self._add(_lib.ups_scene_add_camera, _ffi.SensorId, desc)
        self._shapes[sensor.v] = (height, width)
        return sensor

    def add_meters(self, positions_m, normals, tangents=None, **fields):
        """All three (n, 3); one normal may stand for all meters. Readings keep the order."""
        p = _array(positions_m, np.float64, (-1, 3), "positions_m")
        n = _array(np.broadcast_to(np.asarray(normals, np.float32), p.shape), np.float32, (-1, 3), "normals")
        t = None
        if tangents is not None:
            t = _array(np.broadcast_to(np.asarray(tangents, np.float32), p.shape), np.float32, (-1, 3), "tangents")
        desc = _describe(_ffi.MeterDesc, {"positions_m": _pointer(p, ctypes.c_double),
                                          "normals": _pointer(n, ctypes.c_float), "count": len(p), **fields})
        if t is not None:
            desc.tangents = _pointer(t, ctypes.c_float)
        sensor = self._add(_lib.ups_scene_add_meters, _ffi.SensorId, desc)
        self._shapes[sensor.v] = (len(p),)
        return sensor

    def set_material(self, material, **fields):
        """Fields that are not given take the library's defaults."""
        _check(_lib.ups_scene_set_material(self, material, byref(_describe(_ffi.MaterialDesc, fields))))

    def set_transform(self, instance, to_world):
        _check(_lib.ups_scene_set_transform(self, instance, _pointer(_matrix(to_world), ctypes.c_double)))

    def set_dimming(self, luminaire, dimming):
        _check(_lib.ups_scene_set_dimming(self, luminaire, dimming))

    def remove_instance(self, instance):
        _check(_lib.ups_scene_remove_instance(self, instance))

    def remove_luminaire(self, luminaire):
        _check(_lib.ups_scene_remove_luminaire(self, luminaire))

    def remove_sensor(self, sensor):
        _check(_lib.ups_scene_remove_sensor(self, sensor))

    def commit(self):
        _check(_lib.ups_scene_commit(self))

    @property
    def info(self):
        return _info(_ffi.SceneInfo, _lib.ups_scene_get_info, self)

    def text(self, topic=SceneText.WARNINGS):
        return _text(_lib.ups_scene_get_text, self, topic)

    def render(self, **fields):
        """Blocks until a limit or the target is met; an interrupt of the program waits as long. See start."""
        desc = _describe(_ffi.RenderDesc, fields)
        return Result(_create(_lib.ups_render, self, byref(desc)), dict(self._shapes))

    def start(self, **fields):
        """The same as a Job, which can be watched and cancelled."""
        desc = _describe(_ffi.RenderDesc, fields)
        return Job(_create(_lib.ups_job_start, self, byref(desc)), dict(self._shapes))


class Job(_Handle):
    """A render on the library's own threads; any thread may call. Closing it cancels it."""

    def __init__(self, pointer, shapes):
        super().__init__(pointer, _lib.ups_job_destroy)
        self._shapes = shapes

    def poll(self):
        return _info(_ffi.Progress, _lib.ups_job_poll, self)

    def wait(self, timeout_s=None):
        """Status.OK, TIMEOUT or CANCELLED; raises the job's own error. Without a timeout, an interrupt gets through."""
        if timeout_s is not None:
            return _check(_lib.ups_job_wait(self, min(max(0, round(timeout_s * 1000)), 0xFFFFFFFF)))
        while True:
            status = _check(_lib.ups_job_wait(self, 100))
            if status != Status.TIMEOUT:
                return status

    def cancel(self):
        _lib.ups_job_cancel(self)

    def result(self):
        """What is there after the last whole iteration."""
        return Result(_create(_lib.ups_job_result, self), self._shapes)


class Result(_Handle):
    """What a render has found so far; immutable."""

    def __init__(self, pointer, shapes):
        super().__init__(pointer, _lib.ups_result_destroy)
        self._shapes = shapes

    def _shape(self, sensor, dimensions, what):
        shape = self._shapes.get(sensor.v, ())
        if len(shape) != dimensions:
            raise ValueError(f"sensor {sensor.v} is not {what} of the rendered scene")
        return shape

    @property
    def info(self):
        return _info(_ffi.ResultInfo, _lib.ups_result_get_info, self)

    def meters(self, sensor):
        """A record array with a field for each of ups_meter_reading: illuminance_lx, standard_error_lx, ..."""
        out = np.empty(self._shape(sensor, 1, "a set of meters"), dtype=np.dtype(_ffi.MeterReading))
        _check(_lib.ups_result_read_meters(self, sensor, _pointer(out, _ffi.MeterReading), len(out)))
        return out

    def statistics(self, sensor):
        return _info(_ffi.MeterStatistics, _lib.ups_result_get_meter_statistics, self, sensor)

    def image(self, camera, channel=Channel.LUMINANCE_RGB):
        """(height, width, 3), or (height, width) for the illuminance; row 0 is the image's top."""
        shape = self._shape(camera, 2, "a camera")
        out = np.empty(shape if channel == Channel.ILLUMINANCE else shape + (3,), dtype=np.float32)
        _check(_lib.ups_result_read_image(self, camera, channel, _pointer(out, ctypes.c_float), 0, out.nbytes))
        return out

    def techniques(self, camera):
        """A ups_technique_info of each technique that has an image; empty without technique_images in the render's
        description. The position in the list is the index for technique_image()."""
        count = ctypes.c_uint32()
        _check(_lib.ups_result_get_technique_count(self, camera, byref(count)))
        found = []
        for index in range(count.value):
            info = _ffi.TechniqueInfo(struct_size=ctypes.sizeof(_ffi.TechniqueInfo))
            _check(_lib.ups_result_get_technique(self, camera, index, byref(info)))
            found.append(info)
        return found

    def technique_image(self, camera, index, contribution=Contribution.WEIGHTED):
        """(height, width, 3) of the technique with that index in techniques()."""
        out = np.empty(self._shape(camera, 2, "a camera") + (3,), dtype=np.float32)
        _check(_lib.ups_result_read_technique(self, camera, index, contribution, _pointer(out, ctypes.c_float), 0,
                                              out.nbytes))
        return out

    def convergence(self):
        """What accuracy cost: a record array with a field for each of ups_convergence_point."""
        needed = ctypes.c_size_t()
        status = _lib.ups_result_read_convergence(self, None, 0, byref(needed))
        if status != Status.ERROR_BUFFER_TOO_SMALL:
            _check(status)
        out = np.empty(needed.value, dtype=np.dtype(_ffi.ConvergencePoint))
        if len(out):
            points = _pointer(out, _ffi.ConvergencePoint)
            _check(_lib.ups_result_read_convergence(self, points, len(out), byref(needed)))
        return out

    def text(self, topic=ResultText.WARNINGS):
        return _text(_lib.ups_result_get_text, self, topic)
