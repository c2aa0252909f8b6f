"""Does the Python binding work: values in and out, errors, lifetimes, jobs."""
import gc
import math
import os
import subprocess
import sys

import numpy as np
import pytest
import ups
from expect_lx import expect_lx
from ups import _library


def uniform_profile(context, intensity_cd=100.0):
    return ups.Profile.from_table(context, [0], np.linspace(0, 180, 19), np.full((1, 19), intensity_cd))


def lamp_over_floor(context, reflectance=0.0, intensity_cd=400.0):
    """A point 2 m above a meter that sees no other surface: 100 lx."""
    scene = ups.Scene(context)
    material = scene.add_material(reflectance_rgb=[reflectance] * 3)
    mesh = scene.add_mesh([(-5, -5, 0), (5, -5, 0), (5, 5, 0), (-5, 5, 0)], [(0, 1, 2), (0, 2, 3)], material)
    instance = scene.add_instance(mesh)
    light = scene.add_light(kind=ups.LightKind.POINT, intensity_rgb=[intensity_cd] * 3,
                            to_world=ups.translation(0, 0, 2.5))
    meters = scene.add_meters([(0, 0, 0.5), (1, 0, 0.5)], normals=(0, 0, 1))
    return scene, meters, light, instance


def test_version_is_that_of_the_headers():
    assert ups.version() == ups._ffi.HEADER_VERSION


def test_context_has_the_threads_asked_for():
    processors = len(os.sched_getaffinity(0))
    with ups.Context(thread_count=processors) as context:
        assert context.thread_count == processors
        assert context.pop_log() == []
    with ups.Context(thread_count=processors + 1) as context:
        assert context.thread_count == processors, "no more than run"
        assert len(context.pop_log()) == 1


def test_an_error_has_status_and_text(context):
    with pytest.raises(ups.Error) as caught:
        ups.Context(thread_count=-1)
    assert caught.value.status == ups.Status.ERROR_INVALID_ARGUMENT
    assert "thread_count" in str(caught.value)
    with pytest.raises(ups.Error) as caught:
        ups.Profile.parse(context, b"IESNA:LM-63-2002\nTILT=NONE\n1 2 three\n", ups.ProfileFormat.IES_LM63)
    assert caught.value.status == ups.Status.ERROR_PARSE


def test_profile_flux_is_four_pi_times_a_uniform_intensity(context):
    profile = uniform_profile(context, 100.0)
    # Linear between the table's gammas and uniform: the integral over the sphere is exact but for float rounding.
    assert profile.info.interpolated_flux_lm == pytest.approx(4 * math.pi * 100, rel=1e-5)
    assert profile.info.peak_cd == 100.0
    assert np.array_equal(profile.intensity_cd([(0, 0, -1), (3, 0, 0), (0, 1, 1)]), np.full(3, 100, np.float32))


def test_profile_from_bytes(context):
    ies = b"IESNA:LM-63-2002\n[MANUFAC] A\xc3\xa9\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 20\n0 45 90\n0\n50 40 0\n"
    profile = ups.Profile.parse(context, ies)
    assert profile.format == "IES LM-63-2002"
    assert "MANUFAC=Aé" in profile.keywords
    assert np.allclose(profile.intensity_cd([(0, 0, -1), (1, 0, -1), (0, 0, 1)]), (50, 40, 0), atol=1e-4)


def test_arrays_of_the_wrong_shape_are_refused(context):
    scene = ups.Scene(context)
    material = scene.add_material()
    with pytest.raises(ValueError, match="positions_m"):
        scene.add_mesh([(0, 0), (1, 0), (1, 1)], [(0, 1, 2)], material)
    with pytest.raises(ValueError, match="reflectance_rgb"):
        scene.add_material(reflectance_rgb=(1, 1))
    with pytest.raises(TypeError, match="no_such_field"):
        scene.add_material(no_such_field=1)
    with pytest.raises(ValueError, match="to_world"):
        scene.add_light(to_world=np.eye(3))


def test_libraries_are_named_as_each_system_names_them():
    assert _library._names("ups_exr", "linux") == ("libups_exr.so.0.1", "libups_exr.so")
    assert _library._names("ups_exr", "darwin") == ("libups_exr.0.1.dylib", "libups_exr.dylib")
    assert _library._names("ups_exr", "win32") == ("ups_exr.dll",)


@pytest.mark.parametrize("variable, name", [("UPS_LIBRARY", "libups.so"),
                                            ("LD_LIBRARY_PATH", _library._names("ups")[0])])  # before the system's
def test_a_library_of_another_abi_is_refused(tmp_path, variable, name):
    """Though it has every function: its structs may be laid out otherwise."""
    major, minor, patch = ups._ffi.HEADER_VERSION
    source, library = tmp_path / "stub.c", tmp_path / name
    answers = {**dict.fromkeys(ups._ffi.PROTOTYPES["ups"], 0), "ups_version": major * 10000 + (minor + 1) * 100}
    source.write_text("".join(f"int {function}(void) {{ return {answer}; }}\n" for function, answer in answers.items()))
    environment = {k: v for k, v in os.environ.items() if k not in ("LD_PRELOAD", "UPS_LIBRARY")}
    subprocess.run(["cc", "-shared", "-fPIC", source, "-o", library], check=True, env=environment)
    done = subprocess.run([sys.executable, "-c", "import ups"], capture_output=True, text=True,
                          env={**environment, variable: str(tmp_path)})
    assert done.returncode == 1 and f"ImportError: {library} is UPS {major}.{minor + 1}.0, " in done.stderr, done
    assert f" of UPS {major}.{minor}.{patch} " in done.stderr


def test_the_abi_is_the_sonames():
    assert [_library._abi(v) for v in ((0, 1, 0), (0, 1, 7), (0, 2, 0), (1, 0, 0), (1, 4, 2), (2, 1, 0))] == [
        "0.1", "0.1", "0.2", "1", "1", "2"]


def test_an_index_out_of_range_is_refused_by_the_library(context):
    scene = ups.Scene(context)
    with pytest.raises(ups.Error) as caught:
        scene.add_mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0)], [(0, 1, 3)], scene.add_material())
    assert caught.value.status == ups.Status.ERROR_INVALID_ARGUMENT


def test_scene_reports_what_it_holds(context):
    scene, _, _, _ = lamp_over_floor(context)
    with pytest.raises(ups.Error) as caught:
        scene.info
    assert caught.value.status == ups.Status.ERROR_INVALID_STATE
    scene.commit()
    info = scene.info
    assert (info.triangle_count, info.light_count, info.meter_count) == (2, 1, 2)
    assert info.emitted_flux_lm == pytest.approx(4 * math.pi * 400, rel=1e-5)
    assert list(info.bounds_max_m) == [5, 5, 0]
    assert scene.text(ups.SceneText.TECHNIQUES)


def test_the_light_vector_points_at_the_lamp(context):
    scene, _, _, _ = lamp_over_floor(context)
    meters = scene.add_meters([(0, 0, 0.5), (1, 0, 0.5)], normals=(0, 0, 1), kind=ups.MeterKind.VECTOR)
    scene.commit()
    result = scene.render(iteration_count=16)
    vectors = result.vectors(meters)
    # I / d^2 with d^2 = 4 and 5, from the meter to the lamp.
    assert vectors["vector_lx"][0] == pytest.approx([0, 0, 100], abs=0.01)
    assert vectors["vector_lx"][1] == pytest.approx([-80 / 5 ** 0.5, 0, 160 / 5 ** 0.5], abs=0.01)
    assert (vectors["standard_error_lx"] == 0).all()
    parts = {part: result.vector_part(meters, part) for part in ups.LightPart}
    assert parts[ups.LightPart.DIRECT]["vector_lx"] == pytest.approx(vectors["vector_lx"], abs=1e-3)
    assert parts[ups.LightPart.INDIRECT]["vector_lx"] == pytest.approx(0, abs=1e-3)
    for field in ("vector_lx", "standard_error_lx", "error_bound_lx"):
        assert (parts[ups.LightPart.ALL][field] == vectors[field]).all()
    assert (parts[ups.LightPart.ALL]["bias_lx"] == 0).all()
    assert result.meters(meters)["illuminance_lx"] == pytest.approx([100, 80], rel=1e-4)


def test_meters_under_a_lamp_follow_the_inverse_square_law(context):
    scene, meters, _, _ = lamp_over_floor(context)
    scene.commit()
    readings = scene.render(iteration_count=16).meters(meters)
    # I cos(a) / d^2 with d^2 = 4 and 5. The meters see the point source alone: no noise, only float rounding.
    assert np.allclose(readings["illuminance_lx"], (100, 400 * 2 / 5**1.5), rtol=1e-4)
    assert np.allclose(readings["direct_lx"], readings["illuminance_lx"], rtol=1e-4)


def test_changes_show_after_a_commit(context):
    scene, meters, light, instance = lamp_over_floor(context)
    scene.set_dimming(light, 0.5)
    scene.commit()
    assert scene.render(iteration_count=4).meters(meters)["illuminance_lx"][0] == pytest.approx(50, rel=1e-4)
    # The floor moved to between lamp and meter takes the light away.
    scene.set_transform(instance, ups.translation(0, 0, 1))
    scene.commit()
    assert scene.render(iteration_count=4).meters(meters)["illuminance_lx"][0] == 0
    scene.remove_instance(instance)
    scene.commit()
    assert scene.render(iteration_count=4).meters(meters)["illuminance_lx"][0] == pytest.approx(50, rel=1e-4)
    scene.remove_sensor(meters)
    with pytest.raises(ups.Error):
        scene.remove_sensor(meters)


def test_image_of_a_lit_floor(context):
    scene, _, _, _ = lamp_over_floor(context, reflectance=0.5)
    # From above, looking down: local -Z is down without a turn. 2 m over the floor, pixels near the middle.
    camera = scene.add_camera(6, 4, to_world=ups.translation(0, 0, 2), vertical_fov_rad=0.1, illuminance=1)
    scene.commit()
    result = scene.render(iteration_count=16)
    image, illuminance = result.image(camera), result.image(camera, ups.Channel.ILLUMINANCE)
    assert image.shape == (4, 6, 3) and illuminance.shape == (4, 6)
    # E = I h / d^3 in a pixel's middle, L = reflectance E / pi. Within one E changes by less than 0.3 % to each side.
    side = 2 * 2 * math.tan(0.05) / 4
    x, y = np.meshgrid(side * (np.arange(6) - 2.5), side * (np.arange(4) - 1.5))
    expected = 400 * 2.5 / (x**2 + y**2 + 2.5**2) ** 1.5
    assert np.allclose(illuminance, expected, rtol=2e-3)
    assert np.allclose(image, 0.5 * expected[..., None] / math.pi, rtol=2e-3)
    assert result.image(camera, ups.Channel.STANDARD_ERROR_RGB).shape == (4, 6, 3)
    assert result.techniques(camera) == []
    apart = scene.render(method=ups.Method.UPS, iteration_count=16, technique_images=2)
    techniques = apart.techniques(camera)
    assert [(t.light_vertices, t.eye_vertices) for t in techniques] == [(0, 2), (1, 1), (0, 3), (1, 2), (2, 1), (2, 2)]
    # A floor under a point: next-event estimation is the picture.
    direct = apart.technique_image(camera, 3)
    assert np.allclose(direct, apart.image(camera), rtol=1e-5) and direct.min() > 0
    assert np.allclose(apart.technique_image(camera, 3, ups.Contribution.UNWEIGHTED), direct, rtol=1e-5)
    assert np.allclose(apart.image(camera, ups.Channel.PATH_INTEGRATION_RGB), direct, rtol=1e-5)


def test_fisheye_and_its_layers(context):
    scene, _, _, instance = lamp_over_floor(context, reflectance=0.5)
    layers = ups.Layer.ALBEDO | ups.Layer.NORMAL | ups.Layer.DEPTH | ups.Layer.ID
    camera = scene.add_camera(12, 8, to_world=ups.translation(0, 0, 2), projection=ups.Projection.EQUISOLID,
                              layers=layers)
    scene.commit()
    result = scene.render(iteration_count=16)
    assert (result.image(camera)[:, :2] == 0).all()  # beside the image circle
    assert (result.image(camera, ups.Channel.STANDARD_ERROR_RGB)[:, :2] == 0).all()
    depth, number = result.image(camera, ups.Channel.DEPTH), result.image(camera, ups.Channel.ID)
    assert depth.shape == number.shape == (8, 12)
    assert depth[4, 6] == pytest.approx(2.05, abs=0.05) and (depth[:, :2] == -1).all()
    assert number[4, 6] == instance.v & 0xffffff and (number[:, :2] == 0).all()
    assert np.allclose(result.image(camera, ups.Channel.ALBEDO_RGB)[4, 6], 0.5)
    assert np.allclose(result.image(camera, ups.Channel.NORMAL)[4, 6], (0, 0, 1))


def test_job_and_render_give_the_same_bits(context):
    scene, meters, _, _ = lamp_over_floor(context, reflectance=0.8)
    scene.commit()
    with scene.start(iteration_count=8, seed=3) as job:
        assert job.wait() == ups.Status.OK
        progress = job.poll()
        assert (progress.state, progress.iterations_done) == (ups.JobState.FINISHED, 8)
        from_job = job.result().meters(meters)
    assert from_job.tobytes() == scene.render(iteration_count=8, seed=3).meters(meters).tobytes()


def test_a_job_can_be_cancelled(context):
    scene, meters, _, _ = lamp_over_floor(context, reflectance=0.8)
    scene.commit()
    job = scene.start(iteration_count=0, time_limit_s=600)
    assert job.wait(0) == ups.Status.TIMEOUT
    while job.poll().iterations_done == 0:
        assert job.wait(0.05) == ups.Status.TIMEOUT
    job.cancel()
    assert job.wait() == ups.Status.CANCELLED
    assert job.result().info.iterations >= 1


def test_results_report_their_render(context):
    scene, meters, _, _ = lamp_over_floor(context, reflectance=0.8)
    scene.commit()
    result = scene.render(iteration_count=32, seed=11, flux_paths=4096)
    info = result.info
    assert (info.iterations, info.seed, info.threads) == (32, 11, min(2, len(os.sched_getaffinity(0))))
    assert info.method != ups.Method.AUTO and info.dropped_samples == 0
    assert info.flux_balance_standard_error_lm >= 0
    statistics = result.statistics(meters)
    readings = result.meters(meters)["illuminance_lx"]
    assert statistics.count == 2
    assert statistics.min_lx == pytest.approx(readings.min()) and statistics.max_lx == pytest.approx(readings.max())
    steps = result.convergence()["iterations"]
    assert len(steps) > 0 and np.all(np.diff(steps.astype(int)) > 0) and steps[-1] <= 32
    assert isinstance(result.text(ups.ResultText.TECHNIQUES), str)


def test_statistics_of_areas(context):
    scene, meters, _, _ = lamp_over_floor(context, reflectance=0.8)
    other = scene.add_meters([(1, 0, 0.5), (0, 1, 0.5)], [(0, 0, 1)] * 2)
    scene.commit()
    result = scene.render(iteration_count=32)
    readings, others = result.meters(meters)["illuminance_lx"], result.meters(other)["illuminance_lx"]
    least = result.percentile(meters, 0)
    assert least.low <= least.value <= least.high and least.value == pytest.approx(readings.min())
    share = result.share_above(meters, float(readings.mean()))
    assert share.value == 0.5 and share.low <= 0.5 <= share.high
    assert result.ratio(meters, other).value == pytest.approx(readings.mean() / others.mean(), rel=1e-5)
    np.testing.assert_allclose(result.ratios(meters, other)["value"], readings / others, rtol=1e-5)
    with pytest.raises(ups.Error, match="share is 2"):
        result.percentile(meters, 2)


def test_maintained_values(context):
    scene, meters, _, _ = lamp_over_floor(context, reflectance=0.8)
    with pytest.raises(ups.Error, match="above 0 and at most 1"):
        scene.set_maintenance_factor(1.5)
    scene.set_maintenance_factor(0.8)
    scene.commit()
    assert scene.render(iteration_count=1).info.maintenance_factor == 0.8


def test_a_sample_is_traced_again(context):
    scene, meters, _, _ = lamp_over_floor(context, reflectance=0.8)
    instance = scene.add_instance(scene.add_mesh([(-9, -9, 4), (9, -9, 4), (0, 9, 4)], [(0, 1, 2)],
                                                 scene.add_material(reflectance_rgb=[0.8] * 3)))
    scene.commit()
    settings = {"method": ups.Method.PATH_TRACING, "iteration_count": 20, "seed": 7}
    samples = scene.render(**settings).largest_samples(meters)
    assert len(samples) == 2 and np.all(np.diff(samples["share"]) <= 0) and np.all(samples["seed"] == 7)
    for sample in samples:
        with scene.replay(sample, **settings) as path:
            assert path.info.value == pytest.approx(sample["value"], rel=1e-5)
            found, vertices = path.contributions(), path.vertices()
            assert found["value"].sum() == pytest.approx(sample["value"], rel=1e-4)
            assert set(found["technique"]) <= {ups.Technique.LIGHT_SAMPLE, ups.Technique.EMITTER_HIT}
            assert vertices[0]["event"] == ups.PathEvent.START
            assert vertices[1]["instance"]["v"] == instance.v  # the meters look up, to the ceiling
            assert "next-event estimation" in path.text()
    with pytest.raises(ups.Error, match="index is 9"):
        wrong = samples[0].copy()
        wrong["index"] = 9
        scene.replay(wrong, **settings)


def test_a_section_is_where_a_plane_cuts(context):
    scene, _, _, _ = lamp_over_floor(context)
    scene.commit()
    lines = scene.section((1, 0, 0), (1, 0, 0))
    assert lines.shape == (2, 2, 3) and np.allclose(lines[:, :, 0], 1) and np.allclose(lines[:, :, 2], 0)
    assert np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1).sum() == pytest.approx(10)
    edges = scene.outlines((0, 0, 1), (0, 0, 1))
    assert np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1).sum() == pytest.approx(40)
    assert scene.outlines((0, 0, 1), (0, 0, 1), 0.5).shape == (0, 2, 3)


def test_meters_on_surfaces_and_their_places(context):
    scene, points, _, instance = lamp_over_floor(context)
    white = scene.add_material(reflectance_rgb=[0.5] * 3)
    mesh = scene.add_mesh([(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], [(0, 1, 2), (0, 2, 3)], white,
                          uvs=[(0, 0), (1, 0), (1, 1), (0, 1)])
    table = scene.add_instance(mesh)
    triangles = scene.add_surface_meters([instance, table])
    beneath = scene.add_surface_meters([table], back=1)
    texels = scene.add_lightmap([table], 3, 2)
    discs = scene.add_meters([(0, 0, 1.5)], normals=(0, 0, 1), footprint_m=0.2)
    scene.commit()
    places = scene.meter_places(triangles)
    assert np.all(places["valid"] == 1) and list(places["triangle"]) == [0, 1, 2, 3]
    assert places["area_m2"] == pytest.approx([50, 50, 0.5, 0.5])
    assert np.allclose(scene.meter_places(beneath)["normal"], (0, 0, -1))
    assert scene.meter_places(texels)["position_m"][5] == pytest.approx((5 / 6, 0.75, 1))
    assert scene.meter_places(discs)["area_m2"][0] == pytest.approx(math.pi * 0.01)
    assert scene.meter_places(points)["position_m"][1] == pytest.approx((1, 0, 0.5))
    result = scene.render(iteration_count=64)
    assert len(result.meters(triangles)) == 4 and len(result.meters(texels)) == 6
    # Through the 1 m2 of the table, whose corner lies 1.5 m below the lamp: its intensity times its solid angle.
    flux = 400 * math.atan(1 / (1.5 * math.sqrt(1 + 1 + 1.5**2)))
    for name, area, readings in (("texels", scene.meter_places(texels)["area_m2"], result.meters(texels)),
                                 ("triangles", places["area_m2"][2:], result.meters(triangles)[2:])):
        errors = area * readings["standard_error_lx"]  # meters have eye paths of their own
        assert errors.min() >= 0
        expect_lx((area * readings["illuminance_lx"]).sum(), np.linalg.norm(errors), flux, name, 0.001)
    with pytest.raises(ups.Error, match="no uvs"):
        scene.add_lightmap([instance], 4, 4)


@pytest.mark.parametrize("kind", ["triangle without area", "empty texels"])
def test_meters_that_measure_nothing_are_counted(context, kind):
    """Every answer about a set has an element for each of its meters, at the same place."""
    scene = ups.Scene(context)
    mesh = scene.add_mesh([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [(0, 0, 0), (0, 1, 2), (0, 2, 3)],
                          scene.add_material(reflectance_rgb=[0.5] * 3), uvs=[(0, 0), (0.5, 0), (0.5, 1), (0, 1)])
    instance = scene.add_instance(mesh)
    scene.add_light(to_world=ups.translation(0, 0, 2), intensity_rgb=(100, 100, 100))
    if kind == "empty texels":
        meters, valid = scene.add_lightmap([instance], 4, 3), [True, True, False, False] * 3
    else:
        meters, valid = scene.add_surface_meters([instance]), [False, True, True]
    scene.commit()
    assert (scene.meter_places(meters)["valid"] == 1).tolist() == valid
    result = scene.render(iteration_count=16, separation=ups.Separation.LUMINAIRES)
    count, readings, view = len(valid), result.meters(meters), result.view_meters(meters)
    assert readings.shape == view.shape == (count,) and readings.tobytes() == view.tobytes()
    assert result.meters(meters, out=np.empty_like(view)).tobytes() == view.tobytes()
    assert (readings["illuminance_lx"] > 0).tolist() == valid
    assert not any(np.any(readings[name][np.logical_not(valid)]) for name in readings.dtype.names), "0 throughout"
    assert result.meter_flags(meters).shape == result.ratios(meters, meters).shape == (count,)
    sources = result.source_meters(meters)
    assert sources.shape == (1, count)
    assert sources["illuminance_lx"][0] == pytest.approx(readings["illuminance_lx"], rel=1e-5)
    for part in ups.LightPart:
        assert result.meter_part(meters, part).shape == (count,)
    assert result.meter_part(meters, ups.LightPart.ALL)["illuminance_lx"] == pytest.approx(readings["illuminance_lx"])
    assert result.statistics(meters).count == count


def test_the_grid_of_en_12464():
    points, info = ups.en12464_grid([(0, 0), (11, 0), (11, 3), (0, 3)])
    assert (info.columns, info.rows, info.point_count) == (31, 7, 217) and len(points) == 217
    assert points["x_m"][0] == pytest.approx(0.5 + 10 / 62)
    fewer, info = ups.en12464_grid([(0, 0), (11, 0), (11, 3), (0, 3)], holes_m=[[(5, 1), (6, 1), (6, 2), (5, 2)]],
                                   border_m=0.25)
    assert len(fewer) == info.point_count < info.columns * info.rows
    with pytest.raises(ups.Error, match="cross"):
        ups.en12464_grid([(0, 0), (4, 4), (4, 0), (0, 4)])


def test_what_emits_is_listed(context):
    scene, _, light, _ = lamp_over_floor(context)
    luminaire = scene.add_luminaire(uniform_profile(context), to_world=ups.translation(1, 0, 2), flux_lm=500)
    scene.commit()
    first, second = scene.sources()
    assert (first.id, first.light_kind) == (light.v, ups.LightKind.POINT)
    assert first.flux_lm == pytest.approx(4 * math.pi * 400, rel=1e-5)
    assert (second.id, second.light_kind, second.kind) == (luminaire.v, -1, ups.SourceKind.LUMINAIRE)
    assert list(second.bounds_max_m) == [1, 0, 2] and second.to_world[11] == 2
    assert second.flux_lm == pytest.approx(500, rel=1e-4)
    assert scene.source_profile(1).info.flux_lm == pytest.approx(uniform_profile(context).info.flux_lm)
    with pytest.raises(ups.Error, match="no luminaire"):
        scene.source_profile(0)


def test_accuracy_and_its_cost(context):
    scene, meters, _, _ = lamp_over_floor(context, reflectance=0.8)
    scene.add_instance(scene.add_mesh([(-9, -9, 4), (9, -9, 4), (0, 9, 4)], [(0, 1, 2)],
                                      scene.add_material(reflectance_rgb=[0.8] * 3)))  # what it reflects has noise
    scene.commit()
    with scene.start(iteration_count=40, target_criterion=ups.Criterion.MEAN) as job:
        job.wait()
        result, looks, error = job.result(), job.curve(), job.largest_error()
        foretold = job.predict(1e-5)
    assert [p.iterations for p in looks] == [p.iterations for p in result.curve()] == [16, 20, 25, 32, 40]
    assert all(a.rays < b.rays for a, b in zip(looks, looks[1:])) and looks[-1].resident_bytes > 0
    assert error.sensor.v == result.largest_error().sensor.v == meters.v
    assert error.relative_error == looks[-1].worst_relative_error > 0
    for p in (foretold, result.predict(1e-5)):
        assert p.limited_by == ups.Limit.NOISE and p.iterations > 40
        assert p.seconds_low < p.seconds and (p.seconds < p.seconds_high or p.seconds_high == -1)
    with pytest.raises(ups.Error, match="relative_error"):
        result.predict(0)


def test_memory_is_known_before_and_limited(context):
    scene, meters, _, _ = lamp_over_floor(context, reflectance=0.8)
    scene.add_camera(640, 480, vertical_fov_rad=1, to_world=ups.translation(0, 0, 2))
    scene.commit()
    fields = dict(iteration_count=2, method=ups.Method.UPS)
    estimate = scene.estimate_memory(**fields)
    assert estimate.scene_bytes + estimate.result_bytes < estimate.peak_bytes < estimate.allowed_bytes
    assert 0 < estimate.light_bytes < estimate.working_bytes
    with scene.start(memory_limit_bytes=2 * estimate.peak_bytes, **fields) as job:
        assert job.wait() == ups.Status.OK
        assert job.memory().allowed_bytes == 2 * estimate.peak_bytes
        assert job.memory().peak_bytes == estimate.peak_bytes
    with pytest.raises(ups.Error, match="memory_limit_bytes allows") as refused:
        scene.render(memory_limit_bytes=estimate.peak_bytes // 2, **fields)
    assert refused.value.status == ups.Status.ERROR_OUT_OF_MEMORY


def test_results_tell_how_light_is_found(context):
    scene, meters, _, _ = lamp_over_floor(context, reflectance=0.8)
    camera = scene.add_camera(2, 2, vertical_fov_rad=1, to_world=ups.translation(0, 0, 2))
    scene.commit()
    result = scene.render(iteration_count=2, method=ups.Method.UPS, light_paths_per_iteration=4096)
    for sensor in (meters, camera):
        choice = result.choice(sensor)
        assert (choice.photons, choice.light_paths_per_iteration) == (ups.Photons.ALL, 4096)
        assert choice.techniques & ups.Technique.MERGE and choice.predicted_gain == 1
    eye = scene.render(iteration_count=2, method=ups.Method.PATH_TRACING).choice(meters)
    assert eye.techniques == ups.Technique.EMITTER_HIT | ups.Technique.LIGHT_SAMPLE
    assert (eye.photons, eye.light_paths_per_iteration) == (ups.Photons.NONE, 0)


def test_readings_of_each_source_add_up(context):
    scene, meters, light, _ = lamp_over_floor(context, reflectance=0.5)
    second = scene.add_light(kind=ups.LightKind.POINT, intensity_rgb=[200] * 3, to_world=ups.translation(0, 0, 2.5),
                             group=7)
    scene.commit()
    assert scene.render(iteration_count=1).sources() == []
    result = scene.render(iteration_count=64, seed=2, separation=ups.Separation.LUMINAIRES)
    direct, indirect = (result.meter_part(meters, part) for part in (ups.LightPart.DIRECT, ups.LightPart.INDIRECT))
    whole, statistics = result.meters(meters), result.statistics(meters)
    assert np.allclose(direct["illuminance_lx"] + indirect["illuminance_lx"], whole["illuminance_lx"], rtol=1e-6)
    assert np.all(direct["standard_error_lx"] <= whole["illuminance_lx"])
    flags = result.meter_flags(meters)
    assert flags.shape == (2,)
    assert np.array_equal(flags & ups.Reading.FEW_PATHS != 0, whole["standard_error_lx"] < 0)
    assert 0 <= statistics.uniformity_low <= statistics.uniformity <= statistics.uniformity_high <= 1
    assert statistics.mean_error_bound_lx >= 0 and statistics.percentile_5_lx >= statistics.min_lx
    sources, lamp = result.sources(), ups.SourceKind.LUMINAIRE
    assert [(s.kind, s.id) for s in sources] == [(lamp, light.v), (lamp, second.v)]
    assert [s.flux_lm for s in sources] == pytest.approx([4 * math.pi * 400, 4 * math.pi * 200], rel=1e-5)
    readings = result.source_meters(meters)
    assert readings.shape == (2, 2)
    assert np.allclose(readings["illuminance_lx"].sum(axis=0), result.meters(meters)["illuminance_lx"], rtol=1e-5)
    # 400 and 200 cd from 2 m above, by exact shadow rays; no path brings other light, so that its error is not known.
    off = np.abs(readings["illuminance_lx"][:, 0] - (100, 50))
    assert np.all(off <= readings["error_bound_lx"][:, 0]) and np.all(off < 1e-3)
    assert np.all(readings["standard_error_lx"] == -1) and np.all(readings["error_bound_lx"] > 0)
    by_group = scene.render(iteration_count=8, separation=ups.Separation.GROUPS)
    assert [(s.kind, s.id) for s in by_group.sources()] == [(ups.SourceKind.GROUP, 0), (ups.SourceKind.GROUP, 7)]
    with pytest.raises(ups.Error, match="not a meter set"):
        result.source_meters(scene.add_camera(2, 2, vertical_fov_rad=1))


def test_a_sensor_of_the_other_kind_is_refused(context):
    scene, meters, _, _ = lamp_over_floor(context)
    camera = scene.add_camera(2, 2, vertical_fov_rad=1)
    scene.commit()
    result = scene.render(iteration_count=1)
    with pytest.raises(ups.Error, match="not a camera"):
        result.image(meters)
    with pytest.raises(ups.Error, match="not a meter set"):
        result.meters(camera)


def test_owners_may_go_before_what_they_made():
    context = ups.Context()
    scene, meters, _, _ = lamp_over_floor(context)
    profile = uniform_profile(context)
    scene.add_luminaire(profile, to_world=ups.translation(0, 0, 2.5), flux_lm=4 * math.pi * 400)
    profile.close()
    scene.commit()
    job = scene.start(iteration_count=16)
    context.close()
    scene.close()
    job.wait()
    result = job.result()
    job.close()
    gc.collect()
    assert result.meters(meters)["illuminance_lx"][0] == pytest.approx(200, rel=1e-3)


def test_a_closed_object_is_an_error_and_no_crash(context):
    scene, _, _, _ = lamp_over_floor(context)
    scene.close()
    scene.close()
    with pytest.raises(ups.Error):
        scene.commit()
