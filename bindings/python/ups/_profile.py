"""What does a luminaire send where: luminous intensity distributions, from files and tables, queried and written.

Used by programs, as ups.Profile.
"""
from __future__ import annotations

import ctypes
from ctypes import byref
from typing import TYPE_CHECKING, Any, Callable

import numpy as np

from . import _ffi
from ._convert import (address, as_array, c_text, describe, lib, lines_of, merged, read_bytes, read_info, read_text,
                       target)
from ._core import Context, Handle
from ._ffi import ProfileFormat, ProfileText
from ._status import check

if TYPE_CHECKING:
    from typing import Unpack

    from numpy.typing import ArrayLike, NDArray

    from . import _fields


class LampSet(_ffi.ProfileLampSet):
    """ups_profile_lamp_set (count, flux_lm, ...) with its texts."""
    type: str
    colour: str
    colour_rendering: str


class Profile(Handle):
    """One luminous intensity distribution; immutable. Made by parse or from_table."""

    _destroy = lib.ups_profile_destroy

    @classmethod
    def parse(cls, context: Context, data: bytes | bytearray | memoryview, format: ProfileFormat = ProfileFormat.AUTO,
              tilt_file: bytes | bytearray | memoryview | None = None,
              **fields: Unpack[_fields.ProfileParseDescFields]) -> Profile:
        """From the bytes of a photometric file. tilt_file: the bytes of the file that its TILT= names, see there;
        fields, of ups_profile_parse_desc: tilt_deg, lamp_set."""
        data = bytes(data)
        own: dict[str, Any] = {"format": format, "bytes": ctypes.cast(ctypes.c_char_p(data), ctypes.c_void_p),
                               "size": len(data)}
        if tilt_file is not None:
            tilt_file = bytes(tilt_file)
            own.update(tilt_file=ctypes.cast(ctypes.c_char_p(tilt_file), ctypes.c_void_p),
                       tilt_file_size=len(tilt_file))
        desc = describe(_ffi.ProfileParseDesc, merged(own, fields))
        return cls(lib.ups_profile_parse_with, context, byref(desc))

    @classmethod
    def from_table(cls, context: Context, c_deg: ArrayLike, gamma_deg: ArrayLike, intensity_cd: ArrayLike,
                   **fields: Unpack[_fields.ProfileDescFields]) -> Profile:
        """From intensities of shape (len(c_deg), len(gamma_deg)); fields, of ups_profile_desc: the luminous opening,
        the input power."""
        c, gamma = as_array(c_deg, np.float32, (-1,), "c_deg"), as_array(gamma_deg, np.float32, (-1,), "gamma_deg")
        table = as_array(intensity_cd, np.float32, (len(c), len(gamma)), "intensity_cd")
        own = {"c_count": len(c), "gamma_count": len(gamma), "c_deg": address(c, ctypes.c_float),
               "gamma_deg": address(gamma, ctypes.c_float), "intensity_cd": address(table, ctypes.c_float)}
        desc = describe(_ffi.ProfileDesc, merged(own, fields))
        return cls(lib.ups_profile_create, context, byref(desc))

    @property
    def info(self) -> _ffi.ProfileInfo:
        return read_info(_ffi.ProfileInfo, lib.ups_profile_get_info, self)

    @property
    def warnings(self) -> list[str]:
        return lines_of(read_text(lib.ups_profile_get_text, self, ProfileText.WARNINGS))

    @property
    def keywords(self) -> list[str]:
        """The file's keywords, a line each: MANUFAC=..."""
        return lines_of(read_text(lib.ups_profile_get_text, self, ProfileText.KEYWORDS))

    def keyword(self, name: str) -> str:
        """The values of one keyword, in any case: a line each where there are several, empty where there is none."""
        return read_text(lib.ups_profile_get_keyword, self, c_text(name))

    def with_keyword(self, name: str, value: str) -> Profile:
        """A copy in which the keyword has this value alone, for write."""
        return Profile(lib.ups_profile_with_keyword, self, c_text(name), c_text(value))

    @property
    def lamp_sets(self) -> list[LampSet]:
        """The lamp sets that the file states, each as ups_profile_lamp_set (count, flux_lm, ...) with the texts type,
        colour and colour_rendering."""
        texts = [read_text(lib.ups_profile_get_text, self, topic).split("\n")
                 for topic in (ProfileText.LAMP_TYPES, ProfileText.LAMP_COLOURS, ProfileText.LAMP_RENDERINGS)]
        sets = []
        for i in range(self.info.lamp_set_count):
            lamps = read_info(LampSet, lib.ups_profile_get_lamp_set, self, i)
            lamps.type, lamps.colour, lamps.colour_rendering = (text[i] for text in texts)
            sets.append(lamps)
        return sets

    @property
    def format(self) -> str:
        return read_text(lib.ups_profile_get_text, self, ProfileText.FORMAT)

    @property
    def tilt_file(self) -> str:
        """The name that the file's TILT= has, for parse(tilt_file=...); empty: it needs no file."""
        return read_text(lib.ups_profile_get_text, self, ProfileText.TILT_FILE)

    def write(self, format: ProfileFormat = ProfileFormat.IES_LM63) -> bytes:
        """The bytes of a photometric file, IES_LM63 or EULUMDAT, of the same distribution."""
        return read_bytes(lib.ups_profile_write, self, format)

    def write_warnings(self, format: ProfileFormat = ProfileFormat.IES_LM63) -> list[str]:
        """What the file that write makes does not hold as the profile has it: flux, peak, texts."""
        return lines_of(read_text(lib.ups_profile_get_write_warnings, self, format))

    def _eval(self, function: Callable[..., int], directions: ArrayLike) -> NDArray[np.float32]:
        d = as_array(directions, np.float32, (-1, 3), "directions")
        out = np.empty(len(d), dtype=np.float32)
        check(function(self, address(d, ctypes.c_float), len(d), target(out, ctypes.c_float)))
        return out

    def intensity_cd(self, directions: ArrayLike) -> NDArray[np.float32]:
        """In each direction of an (n, 3) array, in the profile's frame: nadir -Z, C0 +X, C90 +Y."""
        return self._eval(lib.ups_profile_eval, directions)

    def luminance_cd_m2(self, directions: ArrayLike) -> NDArray[np.float32]:
        """Mean over the luminous opening seen from each direction of an (n, 3) array; < 0: a point or an edge."""
        return self._eval(lib.ups_profile_get_luminance, directions)

    def zonal_flux_lm(self, gamma_deg: ArrayLike) -> NDArray[np.float64]:
        """Flux between each two of n ascending angles, in [0, 180]: n - 1 values."""
        gamma = as_array(gamma_deg, np.float32, (-1,), "gamma_deg")
        out = np.empty(max(len(gamma) - 1, 0), dtype=np.float64)
        check(lib.ups_profile_get_zonal_flux(self, address(gamma, ctypes.c_float), len(gamma),
                                             target(out, ctypes.c_double)))
        return out

    def beam(self, c_deg: float = 0, fraction: float = 0.5) -> _ffi.ProfileBeam:
        """The lobe around the peak of the plane C / C + 180 down to that fraction of it, as ups_profile_beam: peak_cd,
        angle_deg, ... 0.5 gives the beam angle, 0.1 the field angle."""
        return read_info(_ffi.ProfileBeam, lib.ups_profile_get_beam, self, c_deg, fraction)

    def ugr_table(self) -> _ffi.UgrTable:
        """By CIE 190, as ups_ugr_table: crosswise and endwise, room * 5 + set of reflectances."""
        return read_info(_ffi.UgrTable, lib.ups_profile_get_ugr_table, self)

    def data_sheet(self, front_c_deg: float = 0) -> _ffi.DataSheet:
        """CIE flux code, luminance limits, spacing criterion, NEMA type, BUG rating, as ups_data_sheet. front_c_deg:
        where the front of an outdoor luminaire faces."""
        return read_info(_ffi.DataSheet, lib.ups_profile_get_data_sheet, self, front_c_deg)

    def utilisation(self) -> _ffi.UtilisationTable:
        """Utilisation factors of ten rooms, as ups_utilisation_table: room * 10 + set of reflectances."""
        return read_info(_ffi.UtilisationTable, lib.ups_profile_get_utilisation, self)
