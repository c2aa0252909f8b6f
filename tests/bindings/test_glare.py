"""Does glare work in the Python binding: tables of a profile, an observer whose rating is made again by hand."""
import numpy as np
import pytest
import ups


@pytest.fixture
def panel(context):
    """450 cd in all directions from 0.3 m x 0.3 m."""
    return ups.Profile.from_table(context, [0], [0, 90], [[450, 450]], opening_shape=ups.OpeningShape.RECTANGLE,
                                  opening_m=(0.3, 0.3, 0))


def test_tables_of_a_profile(context, panel):
    table, sheet, utilisation = panel.ugr_table(), panel.data_sheet(front_c_deg=90), panel.utilisation()
    assert table.crosswise[50] == pytest.approx(table.endwise[50], abs=1e-3)
    assert (table.room_across_h[10], table.room_along_h[10]) == (4, 8)
    assert sheet.flux_code[1] == pytest.approx(50, abs=0.01)
    assert (sheet.nema_horizontal, sheet.nema_vertical) == (7, 7)
    assert utilisation.factors[0] > utilisation.factors[9]
    point = ups.Profile.from_table(context, [0], [0, 90], [[450, 450]])
    with pytest.raises(ups.Error, match="opening"):
        point.ugr_table()


def test_an_observer(context, panel):
    scene = ups.Scene(context)
    mesh = scene.add_mesh([[-5, -5, -1], [5, -5, -1], [5, 5, -1], [-5, 5, -1]], [[0, 1, 2], [0, 2, 3]],
                          scene.add_material())
    scene.add_instance(mesh)
    lamp = scene.add_luminaire(panel, to_world=(1, 0, 0, 0, 0, 1, 0, 2, 0, 0, 1, 1), use_opening=1)
    eye = scene.add_observer(to_world=(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0))  # along +y, up +z
    scene.commit()
    result = scene.render(iteration_count=16, seed=1)
    reading, (source,) = result.observer(eye), result.glare_sources(eye)
    assert reading.flags == 0
    assert (source.kind, source.id) == (ups.SourceKind.LUMINAIRE, lamp.v)
    assert source.intensity_cd == pytest.approx(450, rel=1e-4)
    assert source.position_index == pytest.approx(2.86)  # H/R = 0.5
    assert ups.position_index([[0, 0.5, -1], [0, 0.5, 1]]) == pytest.approx([2.86, -1])
    by_hand = ups.ugr([source.luminance_cd_m2], [source.solid_angle_sr], [source.position_index],
                      reading.background_cd_m2)
    assert by_hand == pytest.approx(reading.ugr, abs=1e-4)
    assert np.pi * reading.background_cd_m2 == pytest.approx(result.meters(eye)["indirect_lx"][0], rel=1e-5)
