"""A render that goes on by itself: watched, cancelled, asked for what it has.

Used by programs, as ups.Job, which Scene.start makes.
"""
from __future__ import annotations

import atexit
import math
import os
import weakref
from typing import Any, Callable, Union

from . import _ffi
from ._convert import lib, read_info
from ._core import Handle
from ._ffi import Status
from ._progress import view_of
from ._result import Result, read_curve
from ._status import Error, check

_running: weakref.WeakSet[Job] = weakref.WeakSet()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_running.clear)  # their threads are the parent's


@atexit.register
def _end_jobs() -> None:
    """At the end of the program: the library's threads stop before it is taken down. Others may still wait for a job."""
    for job in list(_running):
        lib.ups_job_cancel(job)
        lib.ups_job_wait(job, 5000)


Watcher = Union[bool, Callable[[_ffi.Progress], object]]


class Job(Handle):
    """A render on the library's own threads; any thread may call. Closing it cancels it."""
    _destroy = lib.ups_job_destroy
    interrupted = False

    def __init__(self, function: Callable[..., int], *arguments: Any):
        super().__init__(function, *arguments)
        _running.add(self)

    def close(self) -> None:
        lib.ups_job_cancel(self)  # who waits in another thread gets CANCELLED, and what it waits for is destroyed then
        super().close()

    def poll(self) -> _ffi.Progress:
        return read_info(_ffi.Progress, lib.ups_job_poll, self)

    def wait(self, timeout_s: float | None = None) -> Status:
        """Status.OK, TIMEOUT or CANCELLED; raises the job's own error. Without a timeout, an interrupt gets through."""
        if timeout_s is not None and math.isnan(timeout_s):
            raise ValueError("timeout_s is nan; it must be a number of seconds, or None")
        if timeout_s is not None and timeout_s != math.inf:
            return check(lib.ups_job_wait(self, round(min(max(0, timeout_s * 1000), 0xFFFFFFFF))))
        while True:
            status = check(lib.ups_job_wait(self, 100))
            if status != Status.TIMEOUT:
                return status

    def watch(self, progress: Watcher = True) -> Status:
        """Waits for the end, and meanwhile shows how far it is: True, on the terminal or in the notebook; a function is
        called with a ups.Progress ten times a second; False shows nothing. Ctrl-C cancels the job, whose result holds
        what whole iterations have found, and the answer is Status.CANCELLED, or OK of one that has ended just then; the
        job is `interrupted` either way. A second one is raised at once."""
        with view_of(progress) as view:
            try:
                while (status := self.wait(0.1)) == Status.TIMEOUT:
                    view(self.poll())
            except KeyboardInterrupt:
                self.cancel()
                status = self.wait()
                self.interrupted = True
            except Error:
                if self._as_parameter_ is not None:
                    raise
                status = Status.CANCELLED  # by close() in another thread
            if self._as_parameter_ is not None:
                view(self.poll())
        return status

    def predict(self, relative_error: float) -> _ffi.Prediction:
        """When the error by target_criterion is so small, of all looks at it so far, as ups_prediction: seconds from
        the start, seconds_low, seconds_high (95 %; -1: never at this rate), limited_by, iterations."""
        return read_info(_ffi.Prediction, lib.ups_job_get_prediction, self, relative_error)

    def curve(self) -> list[_ffi.CurvePoint]:
        """What accuracy cost so far: a ups_curve_point of each look at the error."""
        return read_curve(lib.ups_job_get_curve_count, lib.ups_job_get_curve_point, self)

    def largest_error(self) -> _ffi.LargestError:
        """The meter that had it at the last look, as ups_largest_error."""
        return read_info(_ffi.LargestError, lib.ups_job_get_largest_error, self)

    def memory(self) -> _ffi.MemoryEstimate:
        """What the render takes, as estimated once it was prepared: ups_memory_estimate."""
        return read_info(_ffi.MemoryEstimate, lib.ups_job_get_memory_estimate, self)

    def cancel(self) -> None:
        lib.ups_job_cancel(self)

    def result(self) -> Result:
        """What is there after the last whole iteration."""
        return Result(lib.ups_job_result, self)


def render(job: Job, progress: Watcher) -> Result:
    """The job's end as the result of one call, see Scene.render."""
    with job:
        interrupted = job.watch(progress) == Status.CANCELLED or job.interrupted
        try:
            result = job.result()
        except Error as error:
            if interrupted and error.status == Status.ERROR_INVALID_STATE:  # before the first iteration
                raise KeyboardInterrupt from None
            raise
    result.interrupted = interrupted
    return result
