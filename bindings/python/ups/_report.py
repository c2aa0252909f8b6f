"""What people read of a render: maps as PNG, SVG or PDF, and the lighting report as one HTML page. Needs the library
ups_report.

Used by programs: ups.write_map, ups.write_points_map, ups.write_image_map, ups.write_report, ups.Picture.
"""
from __future__ import annotations

import ctypes
import dataclasses
import functools
import os
from collections.abc import Iterable, Mapping, Sequence
from ctypes import byref
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _ffi
from ._convert import address, as_array, assign, c_path, c_text, describe, one_or_each
from ._core import Handle, pointer_of
from ._ffi import InstanceId, LuminaireId, ReportExposure, ReportQuantity, SensorId, SourceKind
from ._library import load
from ._result import Result
from ._scene import Scene
from ._status import check

if TYPE_CHECKING:
    from typing import Unpack

    from numpy.typing import ArrayLike

    from . import _fields

_check = functools.partial(check, library="ups_report")


def _text(value: str | None) -> bytes | None:
    return None if value is None else c_text(value)


def _style(fields: Mapping[str, Any]) -> Any:
    return ctypes.pointer(describe(_ffi.ReportStyleDesc, fields, load("ups_report")))


def _sensors(named: Mapping[str, SensorId]) -> Any:
    return (_ffi.ReportSensor * len(named))(*[_ffi.ReportSensor(i, 0, c_text(name)) for name, i in named.items()])


def _write_map(path: str | os.PathLike[str], fields: Mapping[str, Any]) -> None:
    lib = load("ups_report")
    _check(lib.ups_report_write_map(c_path(path), byref(describe(_ffi.ReportMapDesc, fields, lib))))


def write_map(path: str | os.PathLike[str], scene: Handle, result: Handle, sensor: SensorId, title: str | None = None,
              quantity: ReportQuantity = ReportQuantity.AUTO, observers: Mapping[str, SensorId] | None = None,
              **style: Unpack[_fields.ReportStyleDescFields]) -> None:
    """Of meters that lie in a plane, on the plan of the committed scene, or of a camera's image. path: ends in .png,
    .svg or .pdf. quantity: of a camera. observers: to draw, by their names. style: ups_report_style_desc."""
    named = observers or {}
    _write_map(path, {"scene": pointer_of(scene, Scene), "result": pointer_of(result, Result), "sensor": sensor,
                      "title": _text(title), "quantity": quantity, "sensors": _sensors(named),
                      "sensor_count": len(named), "style": _style(style)})


def write_points_map(path: str | os.PathLike[str], positions_m: ArrayLike, illuminance_lx: ArrayLike,
                     normals: ArrayLike = (0, 0, 1), error_bounds_lx: ArrayLike | None = None, columns: int = 0,
                     title: str | None = None, scene: Handle | None = None,
                     **style: Unpack[_fields.ReportStyleDescFields]) -> None:
    """Of points (n, 3) in a plane; illuminance_lx, error_bounds_lx (n,): below 0 or not finite: not known. One normal
    may stand for all. columns: of a grid, row by row; 0: found out. scene: committed, whose plan is drawn."""
    p = as_array(positions_m, np.float64, (-1, 3), "positions_m")
    n = one_or_each(normals, len(p), "normals")
    v = as_array(illuminance_lx, np.float32, (len(p),), "illuminance_lx")
    b = None if error_bounds_lx is None else as_array(error_bounds_lx, np.float32, (len(p),), "error_bounds_lx")
    _write_map(path, {"positions_m": address(p, ctypes.c_double), "normals": address(n, ctypes.c_float),
                      "values": address(v, ctypes.c_float), "error_bounds": address(b, ctypes.c_float),
                      "count": len(p), "columns": columns, "title": _text(title),
                      "scene": None if scene is None else pointer_of(scene, Scene), "style": _style(style)})


def write_image_map(path: str | os.PathLike[str], values: ArrayLike, error_bounds: ArrayLike | None = None,
                    quantity: ReportQuantity = ReportQuantity.LUMINANCE, title: str | None = None,
                    **style: Unpack[_fields.ReportStyleDescFields]) -> None:
    """Of an image (height, width), row 0 at the top: luminance, cd/m^2, or illuminance, lx."""
    v = as_array(values, np.float32, (-1, -1), "values")
    b = None if error_bounds is None else as_array(error_bounds, np.float32, v.shape, "error_bounds")
    _write_map(path, {"values": address(v, ctypes.c_float), "error_bounds": address(b, ctypes.c_float),
                      "count": v.size, "columns": v.shape[1], "quantity": quantity, "title": _text(title),
                      "style": _style(style)})


@dataclasses.dataclass(frozen=True)
class Picture:
    """A camera's image as a PNG: the file's path or its bytes. exposure: whether the page tells ev100, which it then
    needs (ups.ev100), and of what it says it is; smoothed: the page says that it is for looking at alone."""
    camera: SensorId
    png: bytes | str | os.PathLike[str]
    exposure: ReportExposure = ReportExposure.UNTOLD
    ev100: float | None = None
    smoothed: bool = False

    def _as_c(self) -> _ffi.ReportPicture:
        if self.ev100 is None and self.exposure != ReportExposure.UNTOLD:
            raise ValueError("ev100 is missing: the page is to tell the exposure")
        c = _ffi.ReportPicture()
        assign(c, {"camera": self.camera, "exposure": self.exposure, "ev100": self.ev100 or 0,
                   "smoothed": self.smoothed})
        if isinstance(self.png, bytes):
            c.png = ctypes.cast(ctypes.c_char_p(self.png), ctypes.POINTER(ctypes.c_uint8))
            c.png_size = len(self.png)
        else:
            c.path = c_path(self.png)
        return c


def _source(source: LuminaireId | InstanceId, words: str | tuple[str | None, str | None]) -> _ffi.ReportSource:
    if not isinstance(source, (LuminaireId, InstanceId)):
        raise TypeError(f"sources: expected a LuminaireId or an InstanceId, got {source!r}")
    kind = SourceKind.INSTANCE if isinstance(source, InstanceId) else SourceKind.LUMINAIRE
    name, file = (words, None) if isinstance(words, str) else words
    return _ffi.ReportSource(kind, source.v, _text(name), _text(file))


def write_report(path: str | os.PathLike[str], scene: Handle, result: Handle, sensors: Mapping[str, SensorId],
                 title: str | None = None, scene_name: str | None = None,
                 sources: Mapping[LuminaireId | InstanceId, str | tuple[str | None, str | None]] | None = None,
                 pictures: Iterable[Picture] = (), targets_json: str | None = None, targets_name: str | None = None,
                 targets_folder: str | os.PathLike[str] | None = None, repeat: str | None = None,
                 date: str | None = None, thresholds_lx: ArrayLike = (),
                 ratios: Sequence[tuple[SensorId, SensorId]] = (), target_relative_error: float = 0,
                 **style: Unpack[_fields.ReportStyleDescFields]) -> None:
    """The page of a committed scene and a result of it. sensors: that it tells of, by their names, which are what
    targets name. sources: names of luminaires and instances, or (name, photometric file). style: of the maps,
    ups_report_style_desc. Other arguments: fields of ups_report_page_desc."""
    lib, named = load("ups_report"), sources or {}
    thresholds = as_array(thresholds_lx, np.float64, (-1,), "thresholds_lx")
    c_pictures = [p._as_c() for p in pictures]
    desc = describe(_ffi.ReportPageDesc, {
        "scene": pointer_of(scene, Scene), "result": pointer_of(result, Result), "sensors": _sensors(sensors),
        "sensor_count": len(sensors),
        "sources": (_ffi.ReportSource * len(named))(*[_source(s, words) for s, words in named.items()]),
        "source_count": len(named), "pictures": (_ffi.ReportPicture * len(c_pictures))(*c_pictures),
        "picture_count": len(c_pictures), "title": _text(title), "scene_name": _text(scene_name),
        "repeat": _text(repeat), "date": _text(date), "targets_json": _text(targets_json),
        "targets_name": _text(targets_name),
        "targets_folder": None if targets_folder is None else c_path(targets_folder),
        "style": _style(style), "thresholds_lx": address(thresholds, ctypes.c_double),
        "threshold_count": len(thresholds),
        "ratios": (_ffi.ReportRatio * len(ratios))(*[_ffi.ReportRatio(a, b) for a, b in ratios]),
        "ratio_count": len(ratios), "target_relative_error": target_relative_error}, lib)
    _check(lib.ups_report_write_page(c_path(path), byref(desc)))
