"""A glTF file as the content of a scene, and what it named. Needs the library ups_gltf.

Used by programs, as ups.GltfImport and ups.GltfSensor, which Scene.import_gltf makes.
"""
from __future__ import annotations

import ctypes
import dataclasses
import functools
import os
from collections.abc import Mapping
from ctypes import byref
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _ffi
from ._convert import c_path, describe, lines_of, read_text, target
from ._core import Context, Handle
from ._ffi import GltfLayout, GltfPart, GltfSensorKind, SensorId, SourceKind
from ._library import load
from ._status import check

if TYPE_CHECKING:
    from numpy.typing import NDArray


_check = functools.partial(check, library="ups_gltf")


@dataclasses.dataclass(frozen=True)
class GltfSensor:
    """A sensor of the file: `id` is what the methods of a Result take. info: ups_gltf_sensor_info."""
    name: str
    kind: GltfSensorKind
    id: SensorId
    info: _ffi.GltfSensorInfo

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the readings as an array: (height, width), (rows, columns) of a full grid, else (meters,)."""
        i = self.info
        if self.kind == GltfSensorKind.CAMERA or i.layout == GltfLayout.LIGHTMAP:
            return i.height, i.width
        if self.kind == GltfSensorKind.GONIOMETER:
            return i.columns, i.rows
        return (i.rows, i.columns) if i.rows and i.columns else (max(i.meter_count, 1),)


class GltfImport(Handle):
    """What the file named: immutable; the scene keeps what was added. context: that of the scene."""
    _check = staticmethod(_check)

    def __init__(self, context: Context | ctypes.c_void_p | None, scene: Handle, path: str | os.PathLike[str],
                 fields: Mapping[str, Any]):
        self._lib = load("ups_gltf")
        self._destroy = self._lib.ups_gltf_import_destroy
        desc = describe(_ffi.GltfImportDesc, fields, self._lib)
        super().__init__(self._lib.ups_gltf_import_file, context, c_path(path), byref(desc), scene)
        count = ctypes.c_uint32()
        _check(self._lib.ups_gltf_get_sensor_count(self, byref(count)))
        self.sensors = [self._sensor(i) for i in range(count.value)]

    def _sensor(self, index: int) -> GltfSensor:
        info = _ffi.GltfSensorInfo()
        info.struct_size = ctypes.sizeof(info)
        _check(self._lib.ups_gltf_get_sensor(self, index, byref(info)))
        name = read_text(self._lib.ups_gltf_get_sensor_name, self, index, checked=_check)
        return GltfSensor(name, GltfSensorKind(info.kind), SensorId(info.sensor.v), info)

    def __getitem__(self, name: str) -> GltfSensor:
        """The sensor of that name. Errors: KeyError, which has the names that there are."""
        for sensor in self.sensors:
            if sensor.name == name:
                return sensor
        raise KeyError(f"no sensor {name!r}; there are: {', '.join(s.name for s in self.sensors)}")

    def places(self, sensor: GltfSensor) -> tuple[NDArray[np.float64], NDArray[np.float32]]:
        """(positions_m, normals) of meters or of an observer, (n, 3) each. Of surfaces and lightmaps
        Scene.meter_places."""
        count = max(sensor.info.meter_count, 1)
        positions, normals = np.empty((count, 3)), np.empty((count, 3), np.float32)
        index = [s.id for s in self.sensors].index(sensor.id)
        _check(self._lib.ups_gltf_read_meters(self, index, target(positions, ctypes.c_double),
                                              target(normals, ctypes.c_float), count))
        return positions, normals

    def source_name(self, kind: SourceKind, id: int) -> str:
        """Of a source as Result.sources and Scene.sources tell it."""
        return read_text(self._lib.ups_gltf_get_source_name, self, kind, id, checked=_check)

    def source_file(self, kind: SourceKind, id: int) -> str:
        """The photometric file of a luminaire as the scene file names it; empty: none, or within the scene file."""
        return read_text(self._lib.ups_gltf_get_source_file, self, kind, id, checked=_check)

    def place(self, part: GltfPart, id: int) -> str:
        """Where in the file a part of the scene stands, 'node 7 "Tap"'; id: its own, or its number in a message of the
        core. Errors: ups.Error for what the file did not add."""
        return read_text(self._lib.ups_gltf_get_place, self, part, id, checked=_check)

    @property
    def warnings(self) -> list[str]:
        return lines_of(read_text(self._lib.ups_gltf_get_warnings, self, checked=_check))
