"""Do profiles work in the Python binding: files read with options, answers to questions, written files."""
import math

import numpy as np
import pytest
import ups

IES = (b"IESNA:LM-63-2002\n[MANUFAC] maker\n[OTHER] first\n[OTHER] second\nTILT=hid.tlt\n"
       b"2 500 1 3 1 1 2 0.2 0.4 0\n1 1 25\n0 60 90\n0\n100 40 0\n")
TILT_FILE = b"1 2 0 90 1 0.5"


def eulumdat_of_two_lamp_sets():
    sizes = "600 300 50 600 300 0 0 0 0 100 0 1 0 2".split()
    lamps = "1 small 1000 3000 80 10 1 large 2000 3000 80 20".split()
    lines = ["maker", "1", "1", "1", "0", "2", "90", "report", "name", "number", "file", "date", *sizes, *lamps]
    return "\n".join([*lines, *["0"] * 10, "0", "0", "90", "100", "100", ""]).encode()


def triangle_profile(context, **fields):
    """Intensity falls linearly from 600 cd at the nadir to 0 at gamma 60, alike in all planes."""
    gamma = np.linspace(0, 90, 91)
    return ups.Profile.from_table(context, [0], gamma, np.maximum(600 - 10 * gamma, 0)[None], **fields)


def test_keywords_by_name(context):
    profile = ups.Profile.parse(context, IES)
    assert profile.keyword("manufac") == "maker"
    assert profile.keyword("OTHER").splitlines() == ["first", "second"]
    assert profile.keyword("LUMCAT") == ""
    again = ups.Profile.parse(context, profile.with_keyword("lumcat", "DL 50").write())
    assert (again.keyword("LUMCAT"), again.keyword("MANUFAC")) == ("DL 50", "maker")


def test_texts_keep_to_their_lines(context):
    """Whatever a file has in them: a line feed, or what str.splitlines() takes for the end of a line."""
    profile = ups.Profile.parse(context, IES.replace(b"first", b"fi\x85r\x0cst"))
    assert profile.keywords == ["MANUFAC=maker", "OTHER=fi\x85r\x0cst", "OTHER=second"]
    tm33 = (b"<IESTM33-22><Header><Manufacturer>A</Manufacturer><Description>one&#10;MANUFAC=X</Description></Header>"
            b"<Emitter><LuminousData><LuminousIntensity><IntData h='0' v='0'>2</IntData>"
            b"<IntData h='0' v='90'>1</IntData></LuminousIntensity></LuminousData></Emitter></IESTM33-22>")
    profile = ups.Profile.parse(context, tm33)
    assert profile.keywords == ["MANUFAC=A", "LUMINAIRE=one MANUFAC=X"]
    assert profile.keyword("MANUFAC") == "A"


def test_a_tilt_file_is_asked_for_and_applied(context):
    plain = ups.Profile.parse(context, IES)
    assert plain.tilt_file == "hid.tlt"
    tilted = ups.Profile.parse(context, IES, tilt_file=TILT_FILE, tilt_deg=45)  # halfway from a factor 1 to 0.5
    assert tilted.info.flux_lm == pytest.approx(0.75 * plain.info.flux_lm, rel=1e-12)
    with pytest.raises(TypeError, match="tilt_degrees"):
        ups.Profile.parse(context, IES, tilt_degrees=45)


def test_a_lamp_set_is_chosen(context):
    data = eulumdat_of_two_lamp_sets()
    small = ups.Profile.parse(context, data).info
    large = ups.Profile.parse(context, data, ups.ProfileFormat.EULUMDAT, lamp_set=1).info
    assert (small.lamp_set_count, small.rated_flux_lm, large.rated_flux_lm) == (2, 1000, 2000)
    assert large.flux_lm == pytest.approx(2 * small.flux_lm, rel=1e-12)
    with pytest.raises(ups.Error, match="lamp_set"):
        ups.Profile.parse(context, data, lamp_set=2)


def test_lamp_sets_are_told(context):
    small, large = ups.Profile.parse(context, eulumdat_of_two_lamp_sets(), lamp_set=1).lamp_sets
    assert (small.type, small.count, small.flux_lm, small.input_power_w, small.chosen) == ("small", 1, 1000, 10, 0)
    assert (large.type, large.colour_temperature_k, large.colour_rendering_index, large.chosen) == ("large", 3000, 80, 1)


# EULUMDAT has six characters for an intensity: half a unit of the fifth digit.
@pytest.mark.parametrize("format, name, rounding", [(ups.ProfileFormat.IES_LM63, "IES LM-63-2019", 1e-6),
                                                    (ups.ProfileFormat.EULUMDAT, "EULUMDAT", 5.1e-5)])
def test_a_written_file_reads_the_same(context, format, name, rounding):
    profile = triangle_profile(context)
    again = ups.Profile.parse(context, profile.write(format))
    assert again.format == name
    assert profile.write_warnings(format) == []
    assert again.info.flux_lm == pytest.approx(profile.info.flux_lm, rel=rounding)
    directions = np.random.default_rng(1).normal(size=(50, 3))
    assert np.allclose(again.intensity_cd(directions), profile.intensity_cd(directions), rtol=1e-5,
                       atol=600 * rounding)


def test_only_formats_that_are_built_are_written(context):
    with pytest.raises(ups.Error) as caught:
        triangle_profile(context).write(ups.ProfileFormat.TM33_XML)
    assert caught.value.status == ups.Status.ERROR_UNSUPPORTED


def test_zonal_flux_of_a_uniform_intensity(context):
    profile = ups.Profile.from_table(context, [0], np.linspace(0, 180, 181), np.full((1, 181), 100))
    edges = np.array([0, 30, 60, 97.5, 180])
    zones = profile.zonal_flux_lm(edges)
    # 2 pi I (cos a - cos b) for each zone; the band rule is exact for a uniform intensity.
    assert np.allclose(zones, -200 * math.pi * np.diff(np.cos(np.radians(edges))), rtol=1e-5)
    assert zones.sum() == pytest.approx(profile.info.flux_lm, rel=1e-9)
    with pytest.raises(ups.Error):
        profile.zonal_flux_lm([30, 0])


def test_the_beam_of_a_triangle(context):
    profile = triangle_profile(context)
    half, tenth = profile.beam(), profile.beam(c_deg=90, fraction=0.1)
    assert (half.peak_cd, half.peak_deg) == (600, 0)
    assert [half.from_deg, half.to_deg, half.angle_deg] == pytest.approx([-30, 30, 60], abs=1e-3)
    assert tenth.angle_deg == pytest.approx(108, abs=1e-3)
    assert profile.info.beam_angle_deg[0] == half.angle_deg


def test_luminance_of_a_rectangular_opening(context):
    profile = triangle_profile(context, opening_shape=ups.OpeningShape.RECTANGLE, opening_m=(0.2, 0.3, 0),
                               input_power_w=12)
    assert profile.info.input_power_w == 12
    slanted = np.radians(30)
    down, aside, edge_on = profile.luminance_cd_m2([(0, 0, -1), (math.sin(slanted), 0, -math.cos(slanted)), (1, 0, 0)])
    assert down == pytest.approx(600 / 0.06, rel=1e-5)
    assert aside == pytest.approx(300 / (0.06 * math.cos(slanted)), rel=1e-5)
    assert edge_on < 0
