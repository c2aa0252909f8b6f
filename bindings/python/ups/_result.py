"""What has a render found: readings, images, sources apart, measured distributions; and paths traced again.

Used by programs, as ups.Result, which Scene.render and Job.result make.
"""
from __future__ import annotations

import ctypes
import math
from ctypes import POINTER, addressof, byref
from typing import TYPE_CHECKING, Any, Callable

import numpy as np

from . import _ffi
from ._convert import dtype_of, lib, output, read_array, read_count, read_info, read_text, target
from ._core import Handle
from ._ffi import Channel, Contribution, LightPart, ResultText, SensorId
from ._profile import Profile
from ._status import check

if TYPE_CHECKING:
    from numpy.typing import NDArray

SINGLE_CHANNELS = (Channel.ILLUMINANCE, Channel.ILLUMINANCE_STANDARD_ERROR, Channel.ILLUMINANCE_BIAS,
                   Channel.ILLUMINANCE_ERROR_BOUND, Channel.BIAS, Channel.ERROR_BOUND, Channel.DEPTH, Channel.ID)


def read_curve(count_of: Callable[..., int], point_of: Callable[..., int], owner: Handle) -> list[_ffi.CurvePoint]:
    return [read_info(_ffi.CurvePoint, point_of, owner, i) for i in range(read_count(count_of, owner))]


class Result(Handle):
    """What a render has found so far; immutable. interrupted: Ctrl-C ended it before a limit or the target. The arrays
    that reading methods return are new ones, or `out`, where the library writes into the caller's own; those of
    view_meters() and view_image() are the result's own memory, read-only, which stays as long as they do, even when the
    result is closed."""

    _destroy = lib.ups_result_destroy
    interrupted = False

    def _view(self, owner: ctypes.c_void_p | None, first: Any, dtype: Any, shape: tuple[int, ...]) -> NDArray[Any]:
        """An array of what `first` points to, which the owner, held since before it was asked for, has."""
        if not first:
            return np.empty(shape, dtype)
        values: Any = (ctypes.c_char * (math.prod(shape) * dtype.itemsize)).from_address(addressof(first.contents))
        values.owner = owner
        return np.frombuffer(memoryview(values).toreadonly(), dtype).reshape(shape)

    def _meter_count(self, sensor: SensorId) -> int:
        first, count = POINTER(_ffi.MeterReading)(), ctypes.c_size_t()
        check(lib.ups_result_view_meters(self, sensor, byref(first), byref(count)))
        return count.value

    @property
    def info(self) -> _ffi.ResultInfo:
        return read_info(_ffi.ResultInfo, lib.ups_result_get_info, self)

    def choice(self, sensor: SensorId) -> _ffi.SensorChoice:
        """How the light of a camera, a meter set or a goniometer is found, as ups_sensor_choice."""
        return read_info(_ffi.SensorChoice, lib.ups_result_get_choice, self, sensor)

    def meters(self, sensor: SensorId, out: NDArray[np.void] | None = None) -> NDArray[np.void]:
        """A record array with a field for each of ups_meter_reading: illuminance_lx, standard_error_lx, ... Light that
        no path has found, or few, has standard error -1 beside a positive bound; both are -1 where nothing is known
        yet."""
        own = self.view_meters(sensor)
        out = output(out, own)
        ctypes.memmove(out.ctypes.data, own.ctypes.data, own.nbytes)  # NumPy copies records field by field
        return out

    def view_meters(self, sensor: SensorId) -> NDArray[np.void]:
        """As meters(), but the result's own memory: read-only, and nothing is copied."""
        owner, first, count = self._as_parameter_, POINTER(_ffi.MeterReading)(), ctypes.c_size_t()
        check(lib.ups_result_view_meters(self, sensor, byref(first), byref(count)))
        return self._view(owner, first, dtype_of(_ffi.MeterReading), (count.value,))

    def vectors(self, sensor: SensorId) -> NDArray[np.void]:
        """Of meters of kind MeterKind.VECTOR: a record array with the fields vector_lx, standard_error_lx and
        error_bound_lx, three numbers each, x, y and z of the world. meters() has the vectors' lengths."""
        out = np.empty(self._meter_count(sensor), dtype=dtype_of(_ffi.VectorReading))
        check(lib.ups_result_read_vectors(self, sensor, target(out, _ffi.VectorReading), len(out)))
        return out

    def vector_part(self, sensor: SensorId, part: LightPart) -> NDArray[np.void]:
        """As vectors(), of LightPart.DIRECT, INDIRECT or ALL, with the field bias_lx besides."""
        out = np.empty(self._meter_count(sensor), dtype=dtype_of(_ffi.VectorPartReading))
        check(lib.ups_result_read_vector_part(self, sensor, part, target(out, _ffi.VectorPartReading), len(out)))
        return out

    def meter_part(self, sensor: SensorId, part: LightPart) -> NDArray[np.void]:
        """The LightPart.DIRECT, INDIRECT or ALL light of each meter, with errors of its own: as ups_meter_part_reading."""
        out = np.empty(self._meter_count(sensor), dtype=dtype_of(_ffi.MeterPartReading))
        check(lib.ups_result_read_meter_part(self, sensor, part, target(out, _ffi.MeterPartReading), len(out)))
        return out

    def meter_flags(self, sensor: SensorId) -> NDArray[np.uint32]:
        """Reading.EXACT, UNKNOWN, FEW_PATHS, SINGLE_PATH, HEAVY_TAIL of each meter, or-ed in an array of integers."""
        out = np.empty(self._meter_count(sensor), dtype=np.uint32)
        check(lib.ups_result_read_meter_flags(self, sensor, target(out, ctypes.c_uint32), len(out)))
        return out

    def statistics(self, sensor: SensorId) -> _ffi.MeterStatistics:
        return read_info(_ffi.MeterStatistics, lib.ups_result_get_meter_statistics, self, sensor)

    def percentile(self, sensor: SensorId, share: float) -> _ffi.Interval:
        """A ups_interval (value, low, high), lx: `share` (0 to 1) of the meters are below. 0.5: the median."""
        return self._interval(lib.ups_result_get_meter_percentile, sensor, share)

    def share_above(self, sensor: SensorId, threshold_lx: float) -> _ffi.Interval:
        """A ups_interval, 0 to 1: of the meters with at least so much."""
        return self._interval(lib.ups_result_get_meter_share, sensor, threshold_lx)

    def ratio(self, numerator: SensorId, denominator: SensorId) -> _ffi.Interval:
        """A ups_interval: the mean of one set of meters over that of another; -1 where it is not known."""
        return self._interval(lib.ups_result_get_meter_ratio, numerator, denominator)

    def _interval(self, function: Callable[..., int], *arguments: Any) -> _ffi.Interval:
        out = _ffi.Interval()
        check(function(self, *arguments, byref(out)))
        return out

    def ratios(self, numerator: SensorId, denominator: SensorId) -> NDArray[np.void]:
        """Meter by meter: a record array with the fields value, low, high. Of cylindrical meters over horizontal ones at
        the same places: the modelling index."""
        out = np.empty(self._meter_count(numerator), dtype=dtype_of(_ffi.Interval))
        check(lib.ups_result_read_meter_ratios(self, numerator, denominator, target(out, _ffi.Interval), len(out)))
        return out

    def sources(self) -> list[_ffi.SourceInfo]:
        """A ups_source_info of each source that `separation` in the render's description tells apart, else empty: kind,
        id (of a luminaire or instance, or the group), flux_lm."""
        count = read_count(lib.ups_result_get_source_count, self)
        return [read_info(_ffi.SourceInfo, lib.ups_result_get_source, self, i) for i in range(count)]

    def source_meters(self, sensor: SensorId) -> NDArray[np.void]:
        """What each source contributes to each meter: a record array (sources, meters), rows in the order of sources(),
        fields as of meters(), to whose illuminance the rows add up."""
        shape = len(self.sources()), self._meter_count(sensor)
        out = np.empty(shape, dtype=dtype_of(_ffi.MeterReading))
        for source, row in enumerate(out):
            check(lib.ups_result_read_source_meters(self, source, sensor, target(row, _ffi.MeterReading), len(row)))
        return out

    def observer(self, sensor: SensorId) -> _ffi.ObserverReading:
        """UGR with its error and background, as ups_observer_reading."""
        return read_info(_ffi.ObserverReading, lib.ups_result_get_observer, self, sensor)

    def glare_sources(self, sensor: SensorId) -> list[_ffi.GlareSource]:
        """The sources of an observer's rating, the worst first, each as ups_glare_source."""
        return [read_info(_ffi.GlareSource, lib.ups_result_get_glare_source, self, sensor, i)
                for i in range(self.observer(sensor).source_count)]

    def goniometer_info(self, sensor: SensorId) -> _ffi.GoniometerInfo:
        """Flux, light output ratio and accuracy, as ups_goniometer_info."""
        return read_info(_ffi.GoniometerInfo, lib.ups_result_get_goniometer_info, self, sensor)

    def goniometer(self, sensor: SensorId) -> NDArray[np.void]:
        """A record array (planes C, gammas) with a field for each of ups_intensity_reading: intensity_cd, ..."""
        info = self.goniometer_info(sensor)
        out = np.empty((info.c_count, info.gamma_count), dtype=dtype_of(_ffi.IntensityReading))
        check(lib.ups_result_read_goniometer(self, sensor, target(out, _ffi.IntensityReading), out.size))
        return out

    def goniometer_angles(self, sensor: SensorId) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """(c_deg, gamma_deg) of the readings: two arrays (planes C,), (gammas,)."""
        info = self.goniometer_info(sensor)
        c, gamma = np.empty(info.c_count, np.float32), np.empty(info.gamma_count, np.float32)
        check(lib.ups_result_get_goniometer_angles(self, sensor, target(c, ctypes.c_float), len(c),
                                                   target(gamma, ctypes.c_float), len(gamma)))
        return c, gamma

    def goniometer_beam(self, sensor: SensorId, c_deg: float = 0, fraction: float = 0.5) -> _ffi.GoniometerBeam:
        """The beam angle (fraction 0.5) or field angle (0.1) in the plane C / C + 180 with its error, as
        ups_goniometer_beam."""
        return read_info(_ffi.GoniometerBeam, lib.ups_result_get_goniometer_beam, self, sensor, c_deg, fraction)

    def goniometer_profile(self, sensor: SensorId) -> Profile:
        """The distribution as a Profile: for luminaires, and to write a photometric file."""
        return Profile(lib.ups_result_get_goniometer_profile, self, sensor)

    def image(self, camera: SensorId, channel: Channel = Channel.LUMINANCE_RGB,
              out: NDArray[np.float32] | None = None) -> NDArray[np.float32]:
        """(height, width, 3), or (height, width) for ILLUMINANCE and its errors, BIAS, ERROR_BOUND, DEPTH and ID; row
        0 is the image's top. The camera's layers (add_camera(layers=Layer.ALBEDO | Layer.DEPTH)) are channels too."""
        out = output(out, self.view_image(camera, channel))
        check(lib.ups_result_read_image(self, camera, channel, target(out, ctypes.c_float), 0, out.nbytes))
        return out

    def view_image(self, camera: SensorId, channel: Channel = Channel.LUMINANCE_RGB) -> NDArray[np.float32]:
        """As image(), but the result's own memory: read-only, and nothing is copied."""
        owner, first = self._as_parameter_, POINTER(ctypes.c_float)()
        width, height = ctypes.c_uint32(), ctypes.c_uint32()
        check(lib.ups_result_view_image(self, camera, channel, byref(first), byref(width), byref(height)))
        shape = height.value, width.value
        return self._view(owner, first, np.dtype(np.float32), shape if channel in SINGLE_CHANNELS else shape + (3,))

    def techniques(self, camera: SensorId) -> list[_ffi.TechniqueInfo]:
        """A ups_technique_info of each technique that has an image; empty without technique_images in the render's
        description. The position in the list is the index for technique_image()."""
        count, function = ctypes.c_uint32(), lib.ups_result_get_technique
        check(lib.ups_result_get_technique_count(self, camera, byref(count)))
        return [read_info(_ffi.TechniqueInfo, function, self, camera, i) for i in range(count.value)]

    def technique_image(self, camera: SensorId, index: int,
                        contribution: Contribution = Contribution.WEIGHTED) -> NDArray[np.float32]:
        """(height, width, 3) of the technique with that index in techniques()."""
        out = np.empty_like(self.view_image(camera))
        check(lib.ups_result_read_technique(self, camera, index, contribution, target(out, ctypes.c_float), 0,
                                            out.nbytes))
        return out

    def predict(self, relative_error: float) -> _ffi.Prediction:
        """As Job.predict."""
        return read_info(_ffi.Prediction, lib.ups_result_get_prediction, self, relative_error)

    def curve(self) -> list[_ffi.CurvePoint]:
        """What accuracy cost: a ups_curve_point of each look at the error: time, errors, rays, paths, memory."""
        return read_curve(lib.ups_result_get_curve_count, lib.ups_result_get_curve_point, self)

    def largest_error(self) -> _ffi.LargestError:
        """The meter that had it at the last look, as ups_largest_error."""
        return read_info(_ffi.LargestError, lib.ups_result_get_largest_error, self)

    def convergence(self) -> NDArray[np.void]:
        """The part of curve() that there has always been: a record array with a field for each of
        ups_convergence_point."""
        return read_array(_ffi.ConvergencePoint, lib.ups_result_read_convergence, self)

    def largest_samples(self, sensor: SensorId) -> NDArray[np.void]:
        """The samples that weigh most in a camera's image or a set of meters, the largest share first: a record array
        with a field for each of ups_sample. Scene.replay traces one of them again."""
        return read_array(_ffi.Sample, lib.ups_result_read_largest_samples, self, sensor)

    def text(self, topic: ResultText = ResultText.WARNINGS) -> str:
        return read_text(lib.ups_result_get_text, self, topic)


class ReplayedPath(Handle):
    """A sample of a render, traced again by Scene.replay."""

    _destroy = lib.ups_path_destroy

    @property
    def info(self) -> _ffi.PathInfo:
        return read_info(_ffi.PathInfo, lib.ups_path_get_info, self)

    def vertices(self) -> NDArray[np.void]:
        """Walk by walk: a record array with a field for each of ups_path_vertex."""
        return read_array(_ffi.PathVertex, lib.ups_path_read_vertices, self)

    def contributions(self) -> NDArray[np.void]:
        """The largest first: a record array with a field for each of ups_path_contribution."""
        return read_array(_ffi.PathContribution, lib.ups_path_read_contributions, self)

    def text(self) -> str:
        """All that is known of the path, for people."""
        return read_text(lib.ups_path_get_text, self)
