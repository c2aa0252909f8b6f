"""glTF into a scene, OpenEXR and PNG out of a result."""
import base64
import copy
import json

import numpy as np
import pytest
import ups
from expect_lx import expect_lx
from matplotlib.image import imread


@pytest.fixture
def gltf_file(tmp_path):
    """A square of 2 m under a grid of meters and a camera, whose +Y is up."""
    data = np.array([(-1, 0, -1), (-1, 0, 1), (1, 0, 1), (1, 0, -1)], "<f4").tobytes()
    data += np.array([0, 1, 2, 0, 2, 3], "<u4").tobytes()
    grid = {"name": "desk", "width_m": 2, "height_m": 1, "columns": 3, "rows": 2}
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3]}],
        "nodes": [{"mesh": 0}, {"name": "table", "translation": [0, 1, 0],
                                "rotation": [-0.70710678, 0, 0, 0.70710678], "extras": {"ups": {"meters": grid}}},
                  {"name": "view", "camera": 0, "translation": [0, 1, 0], "extras": {"ups": {"width": 8, "height": 6}}},
                  {"name": "lamp", "translation": [0, 2, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 100}]}},
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"extras": {"ups": {"model": "matte", "reflectance": [0, 0, 0]}}}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, 0, -1],
                       "max": [1, 0, 1]}, {"bufferView": 1, "componentType": 5125, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}
    path = tmp_path / "röom.gltf"
    path.write_text(json.dumps(document))
    return path


def test_a_gltf_file_becomes_a_scene(context, gltf_file):
    scene = ups.Scene(context)
    imported = scene.import_gltf(gltf_file, camera_width=5, camera_height=4)
    assert [(s.name, s.kind.name, s.shape) for s in imported.sensors] == [("desk", "METERS", (2, 3)),
                                                                         ("view", "CAMERA", (4, 5))]
    positions, normals = imported.places(imported["desk"])
    assert np.allclose(positions[:, 2], 1) and np.allclose(normals, (0, 0, 1), atol=1e-6)
    scene.commit()
    result = scene.render(iteration_count=2)
    desk, view = imported["desk"], imported["view"]
    readings = result.meters(desk.id)["illuminance_lx"].reshape(desk.shape)
    distance = np.linalg.norm(positions - (0, 0, 2), axis=1).reshape(2, 3)
    assert np.allclose(readings, 100 / distance**3, rtol=1e-3)  # I cos / d^2, the lamp 1 m above
    assert result.image(view.id).shape == (4, 5, 3)
    source = scene.sources()[0]
    assert imported.source_name(ups.SourceKind(source.kind), source.id) == "lamp"
    assert imported.place(ups.GltfPart.LUMINAIRE, source.id).endswith('"lamp"')
    assert imported.source_file(ups.SourceKind(source.kind), source.id) == "" and imported.warnings == []
    with pytest.raises(KeyError, match="there are: desk, view"):
        imported["chair"]


def test_a_broken_gltf_file_says_where(context, tmp_path):
    (tmp_path / "broken.gltf").write_text('{"asset": {"version": "2.0"}, "nodes": 3}')
    with pytest.raises(ups.Error, match="broken.gltf") as caught:
        ups.Scene(context).import_gltf(tmp_path / "broken.gltf")
    assert caught.value.status == ups.Status.ERROR_PARSE
    with pytest.raises(ups.Error) as caught:
        ups.Scene(context).import_gltf(tmp_path / "none.gltf")
    assert caught.value.status == ups.Status.ERROR_IO


def test_exr_channels_come_back_bit_by_bit(tmp_path):
    image = np.random.default_rng(1).random((5, 7, 3), np.float32)
    planes = {name: image[..., i] for i, name in enumerate("RGB")}  # strided: not copied
    more = {"depth.Z": image[::-1, ::-1, 0], "double.Y": image[..., 1].astype(float)}
    ups.write_exr(tmp_path / "a.exr", {**planes, **more}, {"unit": "cd/m^2"})
    with ups.read_exr(tmp_path / "a.exr") as read:
        assert read.shape == (5, 7) and set(read.channels) == {"R", "G", "B", "depth.Z", "double.Y"}
        assert np.array_equal(read.rgb(), image) and np.array_equal(read["depth.Z"], image[::-1, ::-1, 0])
        assert np.array_equal(read["double.Y"], image[..., 1]) and read.attribute("unit") == "cd/m^2"
        with pytest.raises(ups.Error, match="depth.Z"):
            read["A"]
    with pytest.raises(ValueError, match="one shape"):
        ups.write_exr(tmp_path / "b.exr", {"R": image[..., 0], "G": image[1:, :, 0]})
    with pytest.raises(ValueError, match="channel 'R'"):
        ups.write_exr(tmp_path / "b.exr", {"R": image})
    with pytest.raises(ups.Error) as caught:
        ups.read_exr(tmp_path / "b.exr")
    assert caught.value.status == ups.Status.ERROR_IO


def test_pictures(tmp_path):
    luminance = np.full((4, 6, 3), 50.0)
    assert ups.choose_exposure(luminance) == pytest.approx(0.26 / 50, rel=1e-5)
    ups.write_png(tmp_path / "a.png", luminance)
    ups.write_png(tmp_path / "b.png", luminance, exposure=0.26 / 50)
    ups.write_png(tmp_path / "c.png", luminance, exposure=0.52 / 50)
    pixels = [imread(tmp_path / f"{n}.png")[..., :3] for n in "abc"]
    assert pixels[0].shape == (4, 6, 3) and np.array_equal(pixels[0], pixels[1]) and pixels[2].min() > pixels[0].max()
    assert ups.ev100(0.26 / 50) == pytest.approx(np.log2(8 * 50))
    assert ups.exposure_of_ev100(ups.ev100(0.26 / 50)) == pytest.approx(0.26 / 50)
    ups.write_png(tmp_path / "e.png", luminance, exposure=0.26 / 50, exposure_chosen=True)
    assert [b"geometric mean" in (tmp_path / f"{n}.png").read_bytes() for n in "abe"] == [True, False, True]
    with pytest.raises(ups.Error):
        ups.exposure_of_ev100(101)
    ups.write_false_color_png(tmp_path / "d.png", luminance[..., 0], title="a wall", unit="cd/m^2", scale=(0, 100))
    assert (tmp_path / "d.png").read_bytes()[:4] == b"\x89PNG"
    with pytest.raises(ups.Error) as caught:
        ups.write_png(tmp_path / "none" / "a.png", luminance)
    assert caught.value.status == ups.Status.ERROR_IO


def test_smoothing_takes_noise_and_keeps_light():
    depth, normal = np.full((24, 24), 2.0), np.broadcast_to((0, 0, 1), (24, 24, 3))
    kept = []
    for seed in range(16):
        noisy = np.random.default_rng(seed).normal(100, 20, (24, 24, 3)).astype(np.float32)
        albedo = np.full(noisy.shape, 0.5)
        smoothed = ups.smooth(noisy, np.full(noisy.shape, 20), albedo_rgb=albedo, normal=normal, depth=depth)
        assert smoothed.std() < noisy.std() / 3
        kept.append(smoothed.mean() / noisy.mean())
    # 0.1 % each: pixels near the border count for more. Half a percent is far beyond that; 1 % is always found.
    expect_lx(np.mean(kept), np.std(kept, ddof=1) / 4, 1, "light kept", 0.001)
    with pytest.raises(ValueError, match="depth: expected an array of shape"):
        ups.smooth(noisy, noisy, depth=noisy)


def test_a_folder_is_no_image_and_no_channels_make_none(tmp_path):
    with pytest.raises(ups.Error, match="it is a folder, not a file") as refused:
        ups.read_exr(tmp_path)
    assert refused.value.status == ups.Status.ERROR_IO
    with pytest.raises(ups.Error, match="no channels are given"):
        ups.write_exr(tmp_path / "none.exr", {})
    assert not list(tmp_path.iterdir())


def test_channels_may_have_any_names(tmp_path):
    path = tmp_path / "a.exr"
    ups.write_exr(path, {"ab": np.full((2, 3), 7, np.float32)})
    path.write_bytes(path.read_bytes().replace(b"ab\0", b"a\xe9\0"))  # Latin-1
    image = ups.read_exr(path)
    assert [image[name][0, 0] for name in image.channels] == [7]


def test_a_scene_imports_after_its_context_was_closed(gltf_file):
    with ups.Context() as own:
        scene = ups.Scene(own)
    imported = scene.import_gltf(gltf_file)
    for sensor in imported.sensors:
        if sensor.kind not in (ups.GltfSensorKind.CAMERA, ups.GltfSensorKind.GONIOMETER):
            assert np.array_equal(imported.places(copy.copy(sensor))[0], imported.places(sensor)[0])
            assert np.array_equal(imported.places(copy.deepcopy(sensor))[0], imported.places(sensor)[0])


def test_the_library_that_is_named_is_the_one_that_is_loaded(tmp_path, monkeypatch):
    file = tmp_path / ups._library._names("ups")[0]
    file.touch()
    monkeypatch.chdir(tmp_path)
    assert ups._library._chosen(file.name, "ups") == ups._library._chosen(".", "ups") == [str(file)]
