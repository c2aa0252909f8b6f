"""Images in files: OpenEXR with numbers, PNG for looking at. Need the libraries ups_exr and ups_ocio.

Used by programs: ups.read_exr, ups.write_exr, ups.write_png, ups.write_false_color_png, ups.choose_exposure,
ups.ev100, ups.exposure_of_ev100, ups.smooth.
"""
from __future__ import annotations

import ctypes
import functools
import os
from collections.abc import Mapping
from ctypes import byref
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _ffi
from ._convert import address, as_array, c_path, c_text, describe, read_bytes, read_text, real, target
from ._core import Handle
from ._library import load
from ._status import check

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_check_exr = functools.partial(check, library="ups_exr")
_check_ocio = functools.partial(check, library="ups_ocio")
_NAMES = "utf-8", "surrogateescape"  # of channels in files: what is not UTF-8 comes back as it was


def _as_plane(values: ArrayLike, name: str) -> NDArray[np.float32]:
    """(height, width), with any strides that go forward: a channel of an interleaved image is not copied."""
    a = np.asarray(real(values, f"channel {name!r}"), dtype=np.float32)
    if a.ndim != 2:
        raise ValueError(f"channel {name!r}: expected an array of shape (height, width), got {a.shape}")
    return a if a.flags.aligned and all(s >= 4 for s in a.strides) else as_array(a, np.float32, (-1, -1), name)


def write_exr(path: str | os.PathLike[str], channels: Mapping[str, ArrayLike],
              attributes: Mapping[str, str] | None = None) -> None:
    """Channels of 32-bit floats by name ("R", "standard_error.R", "illuminance.Y"), each (height, width), row 0 at the
    top; attributes: strings for the file's header, such as {"unit.R": "cd/m^2"}. The file appears whole or not at
    all."""
    planes = {name: _as_plane(values, name) for name, values in channels.items()}
    shapes = {a.shape for a in planes.values()}
    if len(shapes) > 1:
        raise ValueError(f"channels must have one shape, got {sorted(shapes)}")
    height, width = shapes.pop() if shapes else (0, 0)
    c_channels = (_ffi.ExrChannel * len(planes))(*[
        _ffi.ExrChannel(c_text(name), address(a, ctypes.c_float), a.strides[1], a.strides[0])
        for name, a in planes.items()])
    own = attributes or {}
    c_attributes = (_ffi.ExrAttribute * len(own))(*[_ffi.ExrAttribute(c_text(k), c_text(v)) for k, v in own.items()])
    _check_exr(load("ups_exr").ups_exr_write(c_path(path), width, height, c_channels, len(planes), c_attributes,
                                             len(own)))


class ExrImage(Handle):
    """An OpenEXR file that was read: image["R"] is a channel, (height, width), row 0 at the top."""
    _check = staticmethod(_check_exr)

    def __init__(self, path: str | os.PathLike[str]):
        self._lib = load("ups_exr")
        self._destroy = self._lib.ups_exr_image_destroy
        super().__init__(self._lib.ups_exr_read, c_path(path))
        width, height, count = ctypes.c_uint32(), ctypes.c_uint32(), ctypes.c_uint32()
        _check_exr(self._lib.ups_exr_get_size(self, byref(width), byref(height)))
        _check_exr(self._lib.ups_exr_get_channel_count(self, byref(count)))
        self.shape = height.value, width.value
        self.channels = [read_bytes(self._lib.ups_exr_get_channel_name, self, i, checked=_check_exr).decode(*_NAMES)
                         for i in range(count.value)]

    def __getitem__(self, channel: str) -> NDArray[np.float32]:
        out = np.empty(self.shape, np.float32)
        _check_exr(self._lib.ups_exr_read_channel(self, c_text(channel, _NAMES), target(out, ctypes.c_float), out.size))
        return out

    def rgb(self, prefix: str = "") -> NDArray[np.float32]:
        """(height, width, 3) of the channels R, G and B, or of those of a layer: "standard_error."."""
        return np.stack([self[prefix + name] for name in "RGB"], axis=-1)

    def attribute(self, name: str) -> str:
        """A string of the file's header."""
        return read_text(self._lib.ups_exr_get_attribute, self, c_text(name), checked=_check_exr)


def read_exr(path: str | os.PathLike[str]) -> ExrImage:
    """Of a file's first part."""
    return ExrImage(path)


# ---- for looking at


def _as_picture(values: ArrayLike, name: str) -> NDArray[np.float32]:
    return as_array(values, np.float32, (-1, -1, 3), name)


def choose_exposure(luminance_rgb: ArrayLike) -> float:
    """The factor from luminance (height, width, 3), cd/m^2, to what the view transform shows; always the same of the
    same image."""
    a, out = _as_picture(luminance_rgb, "luminance_rgb"), ctypes.c_double()
    _check_ocio(load("ups_ocio").ups_ocio_choose_exposure(address(a, ctypes.c_float), a.shape[1], a.shape[0],
                                                          byref(out)))
    return out.value


def ev100(exposure: float) -> float:
    """The exposure value at ISO 100 of such a factor."""
    out = ctypes.c_double()
    _check_ocio(load("ups_ocio").ups_ocio_get_ev100(exposure, byref(out)))
    return out.value


def exposure_of_ev100(ev100: float) -> float:
    """The other way round; ev100 within -100 and 100."""
    out = ctypes.c_double()
    _check_ocio(load("ups_ocio").ups_ocio_get_exposure(ev100, byref(out)))
    return out.value


def write_png(path: str | os.PathLike[str], luminance_rgb: ArrayLike, exposure: float = 0, smoothed: bool = False,
              exposure_chosen: bool = False) -> None:
    """Luminance (height, width, 3), cd/m^2, through the ACES view for an sRGB display. exposure: a factor, 0: chosen
    from the image; the file says which. exposure_chosen: it is what choose_exposure gave, as the file then says.
    smoothed: the picture says that it is."""
    a, lib = _as_picture(luminance_rgb, "luminance_rgb"), load("ups_ocio")
    desc = describe(_ffi.OcioPictureDesc, {"width": a.shape[1], "height": a.shape[0], "smoothed": smoothed,
                                           "exposure_chosen": exposure_chosen, "exposure": exposure,
                                           "luminance_rgb": address(a, ctypes.c_float)}, lib)
    _check_ocio(lib.ups_ocio_write_picture_png(c_path(path), byref(desc)))


def write_false_color_png(path: str | os.PathLike[str], values: ArrayLike, title: str | None = None, unit: str = "lx",
                          scale: tuple[float, float] = (0, 0), first_row_at_bottom: bool = False) -> None:
    """Values (rows, columns) in false colours beside their scale; below 0 or not finite: not known, grey. title, unit:
    ASCII. scale: both 0: to the 99th percentile. first_row_at_bottom: grids of meters; images have it at the top."""
    a, lib = as_array(values, np.float32, (-1, -1), "values"), load("ups_ocio")
    desc = describe(_ffi.OcioFalseColorDesc, {
        "columns": a.shape[1], "rows": a.shape[0], "first_row_at_bottom": first_row_at_bottom,
        "values": address(a, ctypes.c_float), "title": None if title is None else c_text(title), "unit": c_text(unit),
        "scale_min": scale[0], "scale_max": scale[1]}, lib)
    _check_ocio(lib.ups_ocio_write_false_color_png(c_path(path), byref(desc)))


def smooth(luminance_rgb: ArrayLike, standard_error_rgb: ArrayLike, albedo_rgb: ArrayLike | None = None,
           normal: ArrayLike | None = None, depth: ArrayLike | None = None) -> NDArray[np.float32]:
    """The same image with less noise, for looking at and never for numbers, by what Result.image has of those channels:
    (height, width, 3) each, depth (height, width). Takes about 10 s a million pixels."""
    a, lib = _as_picture(luminance_rgb, "luminance_rgb"), load("ups_ocio")
    fields: dict[str, Any] = {"width": a.shape[1], "height": a.shape[0], "luminance_rgb": address(a, ctypes.c_float)}
    for name, values, shape in (("standard_error_rgb", standard_error_rgb, a.shape),
                                ("albedo_rgb", albedo_rgb, a.shape), ("normal", normal, a.shape),
                                ("depth", depth, a.shape[:2])):
        if values is not None:
            fields[name] = address(as_array(values, np.float32, shape, name), ctypes.c_float)
    out = np.empty_like(a)
    desc = describe(_ffi.OcioSmoothDesc, fields, lib)
    _check_ocio(lib.ups_ocio_smooth(byref(desc), target(out, ctypes.c_float)))
    return out
