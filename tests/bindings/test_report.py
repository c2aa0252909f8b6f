"""Maps and the lighting report from Python. What they show is tested with the library; here that all of it arrives."""
import numpy as np
import pytest
import ups
from rooms import box

PNG = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\0IEND\xaeB`\x82"  # as far as it is looked at


@pytest.fixture(scope="module")
def lit(context):
    scene, meters = box(context)
    camera = scene.add_camera(8, 6, to_world=ups.translation(2, 2, 3))
    scene.commit()
    return scene, meters, camera, scene.render(iteration_count=4)


def test_maps_of_sensors(lit, tmp_path):
    scene, meters, camera, result = lit
    for ending, head in ((".png", PNG[:8]), (".svg", b"<?xml"), (".pdf", b"%PDF-")):
        ups.write_map(tmp_path / ("desk" + ending), scene, result, meters, title="Schreibtisch ä")
        assert (tmp_path / ("desk" + ending)).read_bytes().startswith(head)
    assert "Illuminance: Schreibtisch ä" in (tmp_path / "desk.svg").read_text(encoding="utf-8")
    ups.write_map(tmp_path / "view.svg", scene, result, camera)
    assert "Luminance: camera 2" in (tmp_path / "view.svg").read_text(encoding="utf-8")
    with pytest.raises(ups.Error, match="must end in .png, .svg or .pdf"):
        ups.write_map(tmp_path / "desk.gif", scene, result, meters)
    with pytest.raises(ups.Error, match="has no illuminance"):
        ups.write_map(tmp_path / "view.png", scene, result, camera, quantity=ups.ReportQuantity.ILLUMINANCE)
    with pytest.raises(TypeError, match="unknown field 'colors'"):
        ups.write_map(tmp_path / "desk.png", scene, result, meters, colors=1)


def test_maps_of_numbers(tmp_path):
    x, y = np.meshgrid(np.arange(6), np.arange(4))
    points = np.stack([x.ravel(), y.ravel(), np.full(24, 0.8)], axis=1)
    lx = 100.0 + 10 * x.ravel()
    ups.write_points_map(tmp_path / "a.svg", points, lx, error_bounds_lx=np.full(24, 2), threshold_lx=121)
    assert "Of 24 values, 121 lx is met at 12, not sure at 4, not met at 8" in (tmp_path / "a.svg").read_text(
        encoding="utf-8")
    ups.write_points_map(tmp_path / "b.svg", points, lx, columns=6, scale=ups.ReportScale.LOGARITHMIC, isolines=0)
    assert "lines at" not in (tmp_path / "b.svg").read_text(encoding="utf-8")
    ups.write_image_map(tmp_path / "c.svg", lx.reshape(4, 6), title="wall")
    assert "Luminance: wall" in (tmp_path / "c.svg").read_text(encoding="utf-8")
    with pytest.raises(ValueError, match="illuminance_lx: expected an array of shape"):
        ups.write_points_map(tmp_path / "d.svg", points, lx[:-1])
    with pytest.raises(ups.Error, match="one line") as caught:
        ups.write_points_map(tmp_path / "d.svg", points[:6], lx[:6])
    assert caught.value.status == ups.Status.ERROR_UNSUPPORTED and not (tmp_path / "d.svg").exists()


def test_the_page(lit, tmp_path):
    scene, meters, camera, result = lit
    image = result.image(camera)
    ups.write_png(tmp_path / "view.png", image)
    source = scene.sources()[0]
    lamp = ups.LuminaireId(source.id)
    for picture in (tmp_path / "view.png", (tmp_path / "view.png").read_bytes()):
        ups.write_report(
            tmp_path / "report.html", scene, result, {"desk": meters, "view": camera}, title="A <box>",
            scene_name="box.dwg", sources={lamp: ("point of light", None)}, repeat="button R", date="today",
            pictures=[ups.Picture(camera, picture, ups.ReportExposure.GIVEN, ev100=5)], thresholds_lx=[50],
            ratios=[(meters, meters)], targets_json='{"areas": [{"meters": "d*", "mean_lx": 1}]}')
        page = (tmp_path / "report.html").read_text(encoding="utf-8")
        for words in ("<h1>A &lt;box&gt;</h1>", "box.dwg", "point of light", "button R", "today", "EV100 5.0",
                      "data:image/png;base64,", "The requirement is met", "At least 50 lx", "desk"):
            assert words in page, words
    with pytest.raises(ups.Error, match="no meters 'chair'; it has desk") as caught:
        ups.write_report(tmp_path / "other.html", scene, result, {"desk": meters},
                         targets_json='{"areas": [{"meters": "chair", "mean_lx": 1}]}')
    assert caught.value.status == ups.Status.ERROR_INVALID_ARGUMENT and not (tmp_path / "other.html").exists()
    with pytest.raises(ups.Error, match="is no PNG"):
        ups.write_report(tmp_path / "other.html", scene, result, {"view": camera},
                         pictures=[ups.Picture(camera, b"GIF89a")])
    with pytest.raises(ValueError, match="ev100 is missing"):
        ups.write_report(tmp_path / "other.html", scene, result, {"view": camera},
                         pictures=[ups.Picture(camera, picture, ups.ReportExposure.CHOSEN)])


def test_a_nul_cuts_no_text_short(tmp_path):
    places, lx = [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [1, 2, 3]
    for path, title in ((str(tmp_path / "cut.png") + "\0.png", "map"), (tmp_path / "map.png", "a\0b")):
        with pytest.raises(ValueError, match="embedded null"):
            ups.write_points_map(path, places, lx, title=title)
    with pytest.raises(ValueError, match="embedded null"):
        ups.read_exr("a.exr\0")
    assert not list(tmp_path.iterdir())


def test_sources_are_luminaires_or_instances(lit, tmp_path):
    scene, _, _, result = lit
    with pytest.raises(TypeError, match="sources: expected a LuminaireId or an InstanceId, got FixtureId"):
        ups.write_report(tmp_path / "page.html", scene, result, {}, sources={ups.FixtureId(1): "lamp"})
    assert not (tmp_path / "page.html").exists()
