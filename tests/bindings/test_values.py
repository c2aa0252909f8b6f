"""What goes into C descriptions and comes out: integers within their C range, arrays without copies, ids, panes."""
import contextlib
import ctypes
import gc
import math
import pickle
import threading
import time
import weakref

import numpy as np
import pytest
import ups
from rooms import box
from ups import _convert, _ffi

SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]


@pytest.mark.parametrize("fields, text", [
    ({"iteration_count": -1}, "iteration_count: expected an integer from 0 to 4294967295, got -1"),
    ({"iteration_count": 2**32 + 1}, "iteration_count: expected an integer from 0 to 4294967295, got 4294967297"),
    ({"seed": 2**64}, "seed: .* to 18446744073709551615"),
    ({"method": 2**31}, "method: .* from -2147483648 to 2147483647")])
def test_an_integer_that_c_would_cut_off_is_refused(context, fields, text):
    scene, _ = box(context)
    with pytest.raises(ValueError, match=text):
        scene.start(**{"iteration_count": 1, **fields})


def test_what_is_no_integer_is_refused(context):
    scene, meters = box(context)
    with pytest.raises(TypeError, match="iteration_count: expected an integer, got 1.5"):
        scene.start(iteration_count=1.5)
    with pytest.raises(TypeError, match="target_relative_error: .*"):
        scene.start(target_relative_error="small")
    with pytest.raises(TypeError, match="no_such_field"):
        scene.start(no_such_field=1)
    with pytest.raises(TypeError, match="unknown field 'struct_size'"):
        scene.start(struct_size=4)
    result = scene.render(iteration_count=np.int64(1), seed=np.uint8(3), max_path_length=True)
    assert (result.info.seed, result.info.iterations) == (3, 1)


def test_integers_of_calls_are_checked_too(context):
    scene, meters = box(context)
    with pytest.raises(ValueError, match="index: expected an integer from 0 to 4294967295, got -1"):
        scene.source_profile(-1)
    with pytest.raises(ValueError, match="part: "):
        scene.render(iteration_count=1).meter_part(meters, 2**32)
    with pytest.raises(ValueError, match="thread_count: "):
        ups.Context(2**31)


@pytest.mark.parametrize("indices, error", [([(0, 1, -1)], ValueError), ([(0, 1, 2**32)], ValueError),
                                            ([(0, 1, 2.5)], TypeError)])
def test_indices_are_not_cut_off_either(context, indices, error):
    scene = ups.Scene(context)
    with pytest.raises(error, match="indices: expected integers"):
        scene.add_mesh(SQUARE, indices, scene.add_material())


def test_arrays_are_read_where_they_are():
    vertices = np.zeros((4, 8), np.float32)  # positions, normals and uvs of each vertex together
    vertices[:, :3], vertices[:, 5] = SQUARE, 1
    indices = np.array([(0, 1, 2), (0, 2, 3)], np.uint32)
    desc = _convert.describe(_ffi.MeshDesc, _convert.mesh_fields(vertices[:, :3], indices, normals=vertices[:, 3:6],
                                                                 uvs=vertices[:, 6:]))
    start = vertices.ctypes.data
    assert [ctypes.addressof(p.contents) - start for p in (desc.positions_m, desc.normals, desc.uvs)] == [0, 12, 24]
    assert {desc.position_stride_bytes, desc.normal_stride_bytes, desc.uv_stride_bytes} == {32}
    assert ctypes.addressof(desc.indices.contents) == indices.ctypes.data


def test_a_mesh_of_interleaved_vertices_is_the_same_mesh(context):
    vertices = np.zeros((4, 8))
    vertices[:, :3] = SQUARE
    found = []
    for positions in (vertices[:, :3], vertices.astype(np.float32)[:, :3], vertices[::-1, :3][::-1].astype(np.float32)):
        scene = ups.Scene(context)
        scene.add_instance(scene.add_mesh(positions, [(0, 1, 2), (0, 2, 3)], scene.add_material()))
        scene.commit()
        found.append((list(scene.info.bounds_max_m), scene.section((0.5, 0.5, 0), (1, 0, 0)).tobytes()))
    assert found[0] == found[1] == found[2] and found[0][0] == [1, 1, 0]


def test_counts_are_those_of_the_arrays(context):
    """More would be read from beyond them."""
    scene = ups.Scene(context)
    instance = scene.add_instance(scene.add_mesh(SQUARE, [(0, 1, 2)], scene.add_material()))
    for add in (lambda: scene.add_meters([(0, 0, 1)], (0, 0, 1), count=1000),
                lambda: scene.add_surface_meters([instance], instance_count=9),
                lambda: scene.add_lightmap([instance], 4, 4, instance_count=9),
                lambda: ups.Profile.from_table(context, [0], [0, 90], [[1, 1]], gamma_count=100),
                lambda: ups.Profile.parse(context, b"IES", size=1000)):
        with pytest.raises(TypeError, match="(count|size): is told by the other arguments"):
            add()


def test_results_go_where_the_caller_wants_them(context):
    scene, meters = box(context)
    camera = scene.add_camera(3, 2, vertical_fov_rad=1, to_world=ups.translation(2, 2, 2))
    scene.commit()
    result = scene.render(iteration_count=4)
    readings, image = result.meters(meters), result.image(camera)
    ours, ours_too = np.zeros_like(readings), np.zeros_like(image)
    assert result.meters(meters, out=ours) is ours and ours.tobytes() == readings.tobytes()
    assert result.image(camera, out=ours_too) is ours_too and np.array_equal(image, ours_too) and image.max() > 0
    for out in (np.zeros((2, 3, 3)), np.zeros((3, 2, 3), np.float32), np.zeros((4, 3, 3), np.float32)[::2]):
        with pytest.raises(ValueError, match="out: expected a writeable, contiguous array"):
            result.image(camera, out=out)
    with pytest.raises(TypeError, match="out: expected an array, got list"):
        result.image(camera, out=[1])
    ours.flags.writeable = False
    with pytest.raises(ValueError, match="out:"):
        result.meters(meters, out=ours)


def test_views_are_the_results_own_memory_and_outlive_it(context):
    scene, meters = box(context)
    camera = scene.add_camera(3, 2, vertical_fov_rad=1, to_world=ups.translation(2, 2, 2))
    scene.commit()
    result = scene.render(iteration_count=4)
    readings, image, depth = result.view_meters(meters), result.view_image(camera), result.view_image(camera)[..., 0]
    assert readings.tobytes() == result.meters(meters).tobytes() and image.shape == (2, 3, 3)
    assert np.array_equal(image, result.image(camera)) and np.shares_memory(image, result.view_image(camera))
    copies = readings.copy(), image.copy()
    for view in (readings, image, depth):
        with pytest.raises(ValueError, match="read-only"):
            view[...] = 0
        with pytest.raises(ValueError, match="WRITEABLE"):
            view.flags.writeable = True
    result.close()
    with pytest.raises(ups.Error, match="result is None, or was closed"):
        result.view_meters(meters)
    others = [scene.render(iteration_count=4, seed=seed) for seed in range(2, 12)]  # would take its memory
    assert readings.tobytes() == copies[0].tobytes() and np.array_equal(image, copies[1])
    memory = weakref.ref(others[0]._as_parameter_)
    view = others[0].view_image(camera)[0]
    del others
    gc.collect()
    assert memory() is not None and view.max() > 0
    del view
    gc.collect()
    assert memory() is None, "the last view has the result destroyed"
    with pytest.raises(ups.Error, match="camera"):
        scene.render(iteration_count=1).view_image(meters)


@pytest.mark.parametrize("read", ["image", "view_image", "meters", "statistics", "text", "predict"])
def test_a_result_may_be_closed_while_another_thread_reads_it(context, read):
    scene, meters = box(context)
    camera = scene.add_camera(256, 256, vertical_fov_rad=1, to_world=ups.translation(2, 2, 2))
    scene.commit()
    arguments = {"text": (), "predict": (0.01,), "meters": (meters,), "statistics": (meters,)}.get(read, (camera,))
    with scene.start(iteration_count=1, method=ups.Method.PATH_TRACING) as job:
        job.wait()
        for _ in range(60):
            result = job.result()
            def read_on():
                with contextlib.suppress(ups.Error):  # INVALID_ARGUMENT: it is closed
                    while True:
                        getattr(result, read)(*arguments)
            threads = [threading.Thread(target=read_on) for _ in range(3)]
            for thread in threads:
                thread.start()
            time.sleep(0.002)
            result.close()
            for thread in threads:
                thread.join()


def test_a_job_that_is_closed_ends_for_who_waits(context):
    scene, _ = box(context)
    scene.commit()
    for _ in range(10):
        job, answers = scene.start(iteration_count=2**31), []
        def wait():
            try:
                answers.append(job.wait())
            except ups.Error as error:
                answers.append(error.status)
        threads = [threading.Thread(target=wait) for _ in range(2)]
        for thread in threads:
            thread.start()
        time.sleep(0.02)
        job.close()
        for thread in threads:
            thread.join(10)
        assert len(answers) == 2 and set(answers) <= {ups.Status.CANCELLED, ups.Status.ERROR_INVALID_ARGUMENT}


def test_what_is_no_handle_is_told(context):
    scene, meters = box(context)
    with pytest.raises(TypeError, match="expected a Profile, got NoneType"):
        scene.add_luminaire(None)
    with pytest.raises(TypeError, match="expected a Result, got str"):
        ups.write_map("map.svg", scene, "result", meters)


def test_what_was_closed_is_not_left_out(context, tmp_path):
    """NULL in a description may mean that a thing stays as it is; nobody means that by what was closed."""
    scene, meters = box(context)
    kept, closed = (ups.Profile.from_table(context, [0], [0, 90], [[peak, 50]]) for peak in (100, 10))
    lamp = scene.add_luminaire(kept)
    closed.close()
    for use in (lambda: scene.add_luminaire(closed), lambda: scene.set_luminaire(lamp, closed),
                lambda: scene.set_luminaire(lamp, profile=closed, dimming=0.5)):
        with pytest.raises(ups.Error, match="profile is None, or was closed") as caught:
            use()
        assert caught.value.status == ups.Status.ERROR_INVALID_ARGUMENT
    assert scene.get_luminaire_profile(lamp).info.peak_cd == 100 and scene.get_dimming(lamp) == 1
    scene.set_luminaire(lamp, profile=None, dimming=0.5)
    assert scene.get_luminaire_profile(lamp).info.peak_cd == 100 and scene.get_dimming(lamp) == 0.5
    fixture = ups.Fixture(context)
    fixture.close()
    with pytest.raises(ups.Error, match="fixture is None, or was closed"):
        scene.add_fixture(fixture)
    scene.commit()
    result, others = scene.render(iteration_count=1), ups.Scene(context)
    others.close()
    points, path = np.array(SQUARE, float), tmp_path / "map.svg"
    for use in (lambda: ups.write_map(path, others, result, meters),
                lambda: ups.write_points_map(path, points, np.ones(4), scene=others),
                lambda: ups.write_report(path, others, result, {})):
        with pytest.raises(ups.Error, match="scene is None, or was closed"):
            use()
    result.close()
    with pytest.raises(ups.Error, match="result is None, or was closed"):
        ups.write_map(path, scene, result, meters)
    assert not path.exists()


def test_an_argument_of_another_type_is_told(context):
    scene, meters = box(context)
    lamp, material = scene.add_light(), scene.add_material()
    result = scene.render(iteration_count=1)
    for use, text in (
            (lambda: scene.set_dimming(1, 0.5), r"ups_scene_set_dimming: argument 2: expected LuminaireId, got 1$"),
            (lambda: scene.set_dimming(lamp, "x"), r"ups_scene_set_dimming: argument 3: expected a number, got 'x'$"),
            (lambda: scene.set_dimming(lamp, None), r"argument 3: expected a number, got None$"),
            (lambda: scene.set_maintenance_factor("1"), r"set_maintenance_factor: argument 2: expected a number"),
            (lambda: scene.set_fixture_dimming(lamp, 1), r"argument 2: expected FixtureId, got LuminaireId\(\d+\)$"),
            (lambda: scene.remove_material(lamp), r"ups_scene_remove_material: argument 2: expected MaterialId"),
            (lambda: scene.get_mesh(material), r"ups_scene_get_mesh: argument 2: expected MeshId"),
            (lambda: result.meters("desk"), r"ups_result_view_meters: argument 2: expected SensorId, got 'desk'$"),
            (lambda: result.meter_part(1, ups.LightPart.ALL), r"argument 2: expected SensorId, got 1$"),
            (lambda: result.meter_part(meters, "all"), r"ups_result_read_meter_part: part: expected an integer"),
            (lambda: ups.Scene(1.5), r"ups_scene_create: argument 1: expected a handle, got 1.5$"),
            (lambda: ups.Fixture(8), r"ups_fixture_create: argument 1: expected a handle, got 8$"),
            (lambda: ups.Profile.parse("lamp.ies", b""), r"argument 1: expected a handle, got 'lamp.ies'$"),
            (lambda: ups.Profile.from_table(True, [0], [0, 90], [[1, 1]]), r"expected a handle, got True$"),
            (lambda: scene.add_fixture(3), r"ups_scene_add_fixture: argument 2: expected a handle, got 3$")):
        with pytest.raises(TypeError, match=text):
            use()
    scene.set_dimming(lamp, np.float32(0.5))
    assert scene.get_dimming(lamp) == 0.5


def test_no_number_is_a_context():
    for number in (8, True, np.int64(8)):  # as if it were the number of threads
        with pytest.raises((TypeError, AttributeError)):
            ups.Scene(number)


def test_one_direction_may_stand_for_all_and_one_number_may_not(context):
    scene, _ = box(context)
    points = np.array(SQUARE[:3], float)
    for normals in ((0, 0, 1), [(0, 0, 1)], np.tile((0, 0, 1), (3, 1))):
        scene.add_meters(points, normals)
    for normals in (1, np.ones((3, 1)), np.ones(1), np.ones((2, 3))):
        with pytest.raises(ValueError, match="normals: expected an array of shape"):
            scene.add_meters(points, normals)


def test_what_a_mask_hides_is_not_known(context):
    scene, _ = box(context)
    masked = np.ma.masked_less(np.ones((3, 3)) * [0, 1, 1], 0.5)
    with pytest.raises(TypeError, match="positions_m: a masked array"):
        scene.add_meters(masked, (0, 0, 1))
    with pytest.raises(TypeError, match="indices: .* a masked array"):
        scene.add_mesh(SQUARE, np.ma.masked_equal([(0, 1, 2)], 0), scene.add_material())
    scene.add_meters(np.ma.array(np.ones((3, 3))), (0, 0, 1))  # one that hides nothing
    with pytest.raises(TypeError, match="reflectance_rgb: a masked array"):
        scene.add_material(reflectance_rgb=np.ma.masked_less([0.5, 0.25, 0.1], 0.2))
    scene.add_material(reflectance_rgb=np.ma.array([0.5, 0.25, 0.1]))


def test_floats_that_are_not_aligned_are_copied(context):
    scene, _ = box(context)
    odd = np.frombuffer(b"x" + np.array(SQUARE, np.float32).tobytes(), np.float32, offset=1).reshape(4, 3)
    assert not odd.flags.aligned
    mesh = scene.add_mesh(odd, [(0, 1, 2), (0, 2, 3)], scene.add_material())
    assert np.array_equal(scene.get_mesh(mesh).arrays["positions_m"], SQUARE)


def test_one_sample_is_replayed_at_a_time(context):
    scene, meters = box(context)
    scene.commit()
    samples = scene.render(iteration_count=16, method=ups.Method.PATH_TRACING).largest_samples(meters)
    assert len(samples) > 1
    with pytest.raises(ValueError, match="expected one of Result.largest_samples"):
        scene.replay(samples, iteration_count=16, method=ups.Method.PATH_TRACING)


def test_an_interrupt_right_after_a_call_leaves_nothing_behind():
    made, gone = [], []

    class Interrupted(ups.Context):
        _destroy = staticmethod(lambda pointer: gone.append(pointer.value))

    def create(desc, out):
        status = _convert.lib.ups_context_create(desc, out)
        made.append(out._obj.value)
        _convert.lib.ups_context_destroy(out._obj)
        raise KeyboardInterrupt

    owner = Interrupted.__new__(Interrupted)
    with pytest.raises(KeyboardInterrupt):
        ups._core.Handle.__init__(owner, create, None)
    del owner
    gc.collect()
    assert made[0] and gone == made


def test_complex_numbers_are_no_coordinates(context):
    scene, _ = box(context)
    with pytest.raises(TypeError, match="positions_m: expected real numbers"):
        scene.add_mesh(np.array(SQUARE) * 1j, [(0, 1, 2)], scene.add_material())
    with pytest.raises(TypeError, match="normals: expected real numbers"):
        scene.add_meters([(1, 1, 1)], (0, 0, 1j))
    with pytest.raises(TypeError, match="texels: expected real numbers"):
        scene.add_texture(np.full((1, 1, 3), 0.25 + 5j))
    with pytest.raises(TypeError, match="to_world: expected real numbers"):
        scene.set_transform(ups.InstanceId(1), np.eye(3, 4) * 1j)
    with pytest.raises(TypeError, match="reflectance_rgb: expected real numbers"):
        scene.add_material(reflectance_rgb=np.full(3, 0.25 + 5j))


def test_a_job_is_waited_for_without_end(context):
    scene, _ = box(context)
    scene.commit()
    with scene.start(iteration_count=4) as job:
        with pytest.raises(ValueError, match="timeout_s is nan"):
            job.wait(math.nan)
        assert job.wait(math.inf) == ups.Status.OK


def test_ids_are_equal_where_they_name_the_same(context):
    scene, meters = box(context)
    assert meters == ups.SensorId(meters.v) and hash(meters) == hash(ups.SensorId(meters.v))
    assert meters != ups.MeshId(meters.v) and meters != meters.v and meters != ups.SensorId(0)
    assert repr(ups.SensorId(7)) == "SensorId(7)"
    with pytest.raises(TypeError, match="mesh: "):
        scene.add_instance(meters)


def test_an_error_survives_another_process():
    error = pickle.loads(pickle.dumps(ups.Error(ups.Status.ERROR_PARSE, "line 3")))
    assert error.status == ups.Status.ERROR_PARSE and str(error) == "ERROR_PARSE: line 3"


def test_a_pane_measured_by_angle(context):
    scene = ups.Scene(context)
    pane = dict(model=ups.MaterialModel.GLAZING, pane_angle_deg=[0, 45, 90], pane_transmittance=[0.8, 0.7, 0])
    scene.set_material(scene.add_material(pane_reflectance=[0.1, 0.15, 1], **pane), pane_reflectance=[0.2] * 3, **pane)
    with pytest.raises(ValueError, match="pane_reflectance: expected as many values as the others have, 3, got 2"):
        scene.add_material(pane_reflectance=[0.1, 1], **pane)


def test_keyword_types_know_every_field():
    """A TypedDict that lacks a field would let a type checker refuse a right program."""
    from ups import _fields
    own = {"ReflectorDesc": {"material"}, "MaterialDesc": set()}
    for cls in _ffi.INIT:
        plain = {n for n, kind in cls._fields_ if not hasattr(kind, "contents") and kind not in (ctypes.c_void_p,
                 ctypes.c_char_p) and n != "struct_size" and not n.startswith("reserved")}
        missing = plain - set(getattr(_fields, cls.__name__ + "Fields").__annotations__)
        assert all(n.endswith("count") or n in ("width", "height", "mesh", "size", "format", "tilt_file_size")
                   for n in missing - own.get(cls.__name__, set())), (cls.__name__, missing)
