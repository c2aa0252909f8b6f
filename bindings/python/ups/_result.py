"""What has a render found: jobs that are watched, readings, images, sources apart, measured distributions.

Used by programs, as ups.Job and ups.Result, which Scene.start and Scene.render make.
"""
import ctypes
from ctypes import byref

import numpy as np

from . import _ffi
from ._core import Handle, address, check, create, lib, read_array, read_info, read_text
from ._ffi import Channel, Contribution, ResultText, Status
from ._profile import Profile


def read_curve(count_of, point_of, owner):
    count = ctypes.c_uint32()
    check(count_of(owner, byref(count)))
    return [read_info(_ffi.CurvePoint, point_of, owner, i) for i in range(count.value)]


class Job(Handle):
    """A render on the library's own threads; any thread may call. Closing it cancels it."""

    def __init__(self, pointer, shapes):
        super().__init__(pointer, lib.ups_job_destroy)
        self._shapes = shapes

    def poll(self):
        return read_info(_ffi.Progress, lib.ups_job_poll, self)

    def wait(self, timeout_s=None):
        """Status.OK, TIMEOUT or CANCELLED; raises the job's own error. Without a timeout, an interrupt gets through."""
        if timeout_s is not None:
            return check(lib.ups_job_wait(self, min(max(0, round(timeout_s * 1000)), 0xFFFFFFFF)))
        while True:
            status = check(lib.ups_job_wait(self, 100))
            if status != Status.TIMEOUT:
                return status

    def predict(self, relative_error):
        """When the error by target_criterion is so small, of all looks at it so far, as ups_prediction: seconds from
        the start, seconds_low, seconds_high (95 %; -1: never at this rate), limited_by, iterations."""
        return read_info(_ffi.Prediction, lib.ups_job_get_prediction, self, relative_error)

    def curve(self):
        """What accuracy cost so far: a ups_curve_point of each look at the error."""
        return read_curve(lib.ups_job_get_curve_count, lib.ups_job_get_curve_point, self)

    def largest_error(self):
        """The meter that had it at the last look, as ups_largest_error."""
        return read_info(_ffi.LargestError, lib.ups_job_get_largest_error, self)

    def memory(self):
        """What the render takes, as estimated once it was prepared: ups_memory_estimate."""
        return read_info(_ffi.MemoryEstimate, lib.ups_job_get_memory_estimate, self)

    def cancel(self):
        lib.ups_job_cancel(self)

    def result(self):
        """What is there after the last whole iteration."""
        return Result(create(lib.ups_job_result, self), self._shapes)


class Result(Handle):
    """What a render has found so far; immutable."""

    def __init__(self, pointer, shapes):
        super().__init__(pointer, lib.ups_result_destroy)
        self._shapes = shapes

    def _shape(self, sensor, dimensions, what):
        shape = self._shapes.get(sensor.v, ())
        if len(shape) != dimensions:
            raise ValueError(f"sensor {sensor.v} is not {what} of the rendered scene")
        return shape

    @property
    def info(self):
        return read_info(_ffi.ResultInfo, lib.ups_result_get_info, self)

    def choice(self, sensor):
        """How the light of a camera, a meter set or a goniometer is found, as ups_sensor_choice."""
        return read_info(_ffi.SensorChoice, lib.ups_result_get_choice, self, sensor)

    def meters(self, sensor):
        """A record array with a field for each of ups_meter_reading: illuminance_lx, standard_error_lx, ... Light that
        no path has found, or few, has standard error -1 beside a positive bound; both are -1 where nothing is known
        yet."""
        out = np.empty(self._shape(sensor, 1, "a set of meters"), dtype=np.dtype(_ffi.MeterReading))
        check(lib.ups_result_read_meters(self, sensor, address(out, _ffi.MeterReading), len(out)))
        return out

    def meter_part(self, sensor, part):
        """The LightPart.DIRECT or INDIRECT light of each meter, with errors of its own: as ups_meter_part_reading."""
        out = np.empty(self._shape(sensor, 1, "a set of meters"), dtype=np.dtype(_ffi.MeterPartReading))
        check(lib.ups_result_read_meter_part(self, sensor, part, address(out, _ffi.MeterPartReading), len(out)))
        return out

    def meter_flags(self, sensor):
        """Reading.EXACT, UNKNOWN, FEW_PATHS, SINGLE_PATH, HEAVY_TAIL of each meter, or-ed in an array of integers."""
        out = np.empty(self._shape(sensor, 1, "a set of meters"), dtype=np.uint32)
        check(lib.ups_result_read_meter_flags(self, sensor, address(out, ctypes.c_uint32), len(out)))
        return out

    def statistics(self, sensor):
        return read_info(_ffi.MeterStatistics, lib.ups_result_get_meter_statistics, self, sensor)

    def percentile(self, sensor, share):
        """A ups_interval (value, low, high), lx: `share` (0 to 1) of the meters are below. 0.5: the median."""
        return self._interval(lib.ups_result_get_meter_percentile, sensor, share)

    def share_above(self, sensor, threshold_lx):
        """A ups_interval, 0 to 1: of the meters with at least so much."""
        return self._interval(lib.ups_result_get_meter_share, sensor, threshold_lx)

    def ratio(self, numerator, denominator):
        """A ups_interval: the mean of one set of meters over that of another; -1 where it is not known."""
        return self._interval(lib.ups_result_get_meter_ratio, numerator, denominator)

    def _interval(self, function, *arguments):
        out = _ffi.Interval()
        check(function(self, *arguments, byref(out)))
        return out

    def ratios(self, numerator, denominator):
        """Meter by meter: a record array with the fields value, low, high. Of cylindrical meters over horizontal ones at
        the same places: the modelling index."""
        out = np.empty(self._shape(numerator, 1, "a set of meters"), dtype=np.dtype(_ffi.Interval))
        check(lib.ups_result_read_meter_ratios(self, numerator, denominator, address(out, _ffi.Interval), len(out)))
        return out

    def sources(self):
        """A ups_source_info of each source that `separation` in the render's description tells apart, else empty: kind,
        id (of a luminaire or instance, or the group), flux_lm."""
        count = ctypes.c_uint32()
        check(lib.ups_result_get_source_count(self, byref(count)))
        return [read_info(_ffi.SourceInfo, lib.ups_result_get_source, self, i) for i in range(count.value)]

    def source_meters(self, sensor):
        """What each source contributes to each meter: a record array (sources, meters), rows in the order of sources(),
        fields as of meters(), to whose illuminance the rows add up."""
        shape = len(self.sources()), *self._shape(sensor, 1, "a set of meters")
        out = np.empty(shape, dtype=np.dtype(_ffi.MeterReading))
        for source, row in enumerate(out):
            check(lib.ups_result_read_source_meters(self, source, sensor, address(row, _ffi.MeterReading), len(row)))
        return out

    def goniometer_info(self, sensor):
        """Flux, light output ratio and accuracy, as ups_goniometer_info."""
        return read_info(_ffi.GoniometerInfo, lib.ups_result_get_goniometer_info, self, sensor)

    def goniometer(self, sensor):
        """A record array (planes C, gammas) with a field for each of ups_intensity_reading: intensity_cd, ..."""
        info = self.goniometer_info(sensor)
        out = np.empty((info.c_count, info.gamma_count), dtype=np.dtype(_ffi.IntensityReading))
        check(lib.ups_result_read_goniometer(self, sensor, address(out, _ffi.IntensityReading), out.size))
        return out

    def goniometer_angles(self, sensor):
        """(c_deg, gamma_deg) of the readings: two arrays (planes C,), (gammas,)."""
        info = self.goniometer_info(sensor)
        c, gamma = np.empty(info.c_count, np.float32), np.empty(info.gamma_count, np.float32)
        check(lib.ups_result_get_goniometer_angles(self, sensor, address(c, ctypes.c_float), len(c),
                                                   address(gamma, ctypes.c_float), len(gamma)))
        return c, gamma

    def goniometer_beam(self, sensor, c_deg=0, fraction=0.5):
        """The beam angle (fraction 0.5) or field angle (0.1) in the plane C / C + 180 with its error, as
        ups_goniometer_beam."""
        return read_info(_ffi.GoniometerBeam, lib.ups_result_get_goniometer_beam, self, sensor, c_deg, fraction)

    def goniometer_profile(self, sensor):
        """The distribution as a Profile: for luminaires, and to write a photometric file."""
        return Profile(create(lib.ups_result_get_goniometer_profile, self, sensor))

    def image(self, camera, channel=Channel.LUMINANCE_RGB):
        """(height, width, 3), or (height, width) for ILLUMINANCE and its error, BIAS and ERROR_BOUND; row 0 is the
        image's top."""
        shape = self._shape(camera, 2, "a camera")
        single = (Channel.ILLUMINANCE, Channel.ILLUMINANCE_STANDARD_ERROR, Channel.BIAS, Channel.ERROR_BOUND)
        out = np.empty(shape if channel in single else shape + (3,), dtype=np.float32)
        check(lib.ups_result_read_image(self, camera, channel, address(out, ctypes.c_float), 0, out.nbytes))
        return out

    def techniques(self, camera):
        """A ups_technique_info of each technique that has an image; empty without technique_images in the render's
        description. The position in the list is the index for technique_image()."""
        count = ctypes.c_uint32()
        check(lib.ups_result_get_technique_count(self, camera, byref(count)))
        function = lib.ups_result_get_technique
        return [read_info(_ffi.TechniqueInfo, function, self, camera, i) for i in range(count.value)]

    def technique_image(self, camera, index, contribution=Contribution.WEIGHTED):
        """(height, width, 3) of the technique with that index in techniques()."""
        out = np.empty(self._shape(camera, 2, "a camera") + (3,), dtype=np.float32)
        check(lib.ups_result_read_technique(self, camera, index, contribution, address(out, ctypes.c_float), 0,
                                            out.nbytes))
        return out

    def predict(self, relative_error):
        """As Job.predict."""
        return read_info(_ffi.Prediction, lib.ups_result_get_prediction, self, relative_error)

    def curve(self):
        """What accuracy cost: a ups_curve_point of each look at the error: time, errors, rays, paths, memory."""
        return read_curve(lib.ups_result_get_curve_count, lib.ups_result_get_curve_point, self)

    def largest_error(self):
        """The meter that had it at the last look, as ups_largest_error."""
        return read_info(_ffi.LargestError, lib.ups_result_get_largest_error, self)

    def convergence(self):
        """The part of curve() that there has always been: a record array with a field for each of
        ups_convergence_point."""
        return read_array(_ffi.ConvergencePoint, lib.ups_result_read_convergence, self)

    def largest_samples(self, sensor):
        """The samples that weigh most in a camera's image or a set of meters, the largest share first: a record array
        with a field for each of ups_sample. Scene.replay traces one of them again."""
        return read_array(_ffi.Sample, lib.ups_result_read_largest_samples, self, sensor)

    def text(self, topic=ResultText.WARNINGS):
        return read_text(lib.ups_result_get_text, self, topic)


class ReplayedPath(Handle):
    """A sample of a render, traced again by Scene.replay."""

    def __init__(self, pointer):
        super().__init__(pointer, lib.ups_path_destroy)

    @property
    def info(self):
        return read_info(_ffi.PathInfo, lib.ups_path_get_info, self)

    def vertices(self):
        """Walk by walk: a record array with a field for each of ups_path_vertex."""
        return read_array(_ffi.PathVertex, lib.ups_path_read_vertices, self)

    def contributions(self):
        """The largest first: a record array with a field for each of ups_path_contribution."""
        return read_array(_ffi.PathContribution, lib.ups_path_read_contributions, self)

    def text(self):
        """All that is known of the path, for people."""
        return read_text(lib.ups_path_get_text, self)
