"""What was added to a scene is set, asked for and removed; commits run as jobs."""
import numpy as np
import pytest
import ups
from rooms import box


def lit_floor(context):
    """A square of 2 m, a lamp of 400 cd 2 m above it, a meter in its middle: (scene, {name: id})."""
    scene = ups.Scene(context)
    ids = {"material": scene.add_material(reflectance_rgb=(0.5, 0.5, 0.5), roughness=0.3)}
    ids["mesh"] = scene.add_mesh([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [(0, 1, 2), (0, 2, 3)],
                                 ids["material"], uvs=[(0, 0), (1, 0), (1, 1), (0, 1)])
    ids["instance"] = scene.add_instance(ids["mesh"])
    ids["light"] = scene.add_light(intensity_rgb=(400, 400, 400), to_world=ups.translation(0, 0, 2.5))
    ids["meters"] = scene.add_meters([(0, 0, 0.5)], (0, 0, 1))
    scene.commit()
    return scene, ids


def first_lx(scene, meters):
    return float(scene.render(iteration_count=4).meters(meters)["illuminance_lx"][0])


def test_what_is_not_given_stays(context):
    scene, ids = lit_floor(context)
    assert not scene.is_dirty
    scene.set_material(ids["material"], roughness=0.7)
    material = scene.get_material(ids["material"])
    assert material.roughness == np.float32(0.7) and list(material.reflectance_rgb) == [0.5, 0.5, 0.5]
    assert scene.is_dirty
    scene.set_light(ids["light"], group=3)
    assert list(scene.get_light(ids["light"]).intensity_rgb) == [400, 400, 400]
    scene.set_instance(ids["instance"], to_world=ups.translation(0, 0, 1))
    assert scene.get_instance(ids["instance"]).mesh == ids["mesh"]
    scene.set_luminaire_transform(ids["light"], ups.translation(0, 0, 4.5))
    scene.set_dimming(ids["light"], 0.5)
    assert scene.get_dimming(ids["light"]) == 0.5
    scene.commit()
    assert not scene.is_dirty and first_lx(scene, ids["meters"]) == 0  # the floor is above it now
    scene.set_transform(ids["instance"], ups.translation(0, 0, 0))
    scene.commit()
    assert first_lx(scene, ids["meters"]) == pytest.approx(0.5 * 400 / 16, rel=1e-4)


def test_meshes(context):
    scene, ids = lit_floor(context)
    moved = np.array([(-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)], np.float32)
    scene.set_mesh_vertices(ids["mesh"], moved)
    got = scene.get_mesh(ids["mesh"])
    assert np.array_equal(got.arrays["positions_m"], moved) and got.arrays["indices"].tolist() == [[0, 1, 2], [0, 2, 3]]
    assert got.arrays["uvs"].shape == (4, 2) and "normals" not in got.arrays and got.material == ids["material"]
    got.arrays["positions_m"][:] = moved  # the caller's own, not the scene's
    scene.set_mesh(ids["mesh"], moved[:3], [(0, 1, 2)])
    with pytest.raises(ups.Error):
        scene.set_mesh_vertices(ids["mesh"], moved)  # one more than it has now
    assert np.array_equal(got.arrays["positions_m"], moved), "a copy"
    scene.commit()
    assert scene.info.triangle_count == 1 and scene.get_mesh(ids["mesh"]).arrays["positions_m"].shape == (3, 3)


def test_a_scene_that_is_closed_stays_until_its_arrays_are_copied(context):
    scene, ids = lit_floor(context)

    def get_and_close(*arguments):
        status = ups._convert.lib.ups_scene_get_mesh(*arguments)
        scene.close()  # as another thread may, between the call and the copy
        assert scene._end.alive
        return status

    got = scene._get(get_and_close, ups._ffi.MeshDesc, ids["mesh"])
    assert got.arrays["positions_m"].shape == (4, 3)
    assert not scene._end.alive


def test_sensors_keep_their_size_until_the_commit(context):
    scene, ids = lit_floor(context)
    camera = scene.add_camera(4, 2, vertical_fov_rad=1, to_world=ups.translation(0, 0, 2))
    scene.commit()
    scene.set_camera(camera, width=6)
    scene.set_meters(ids["meters"], [(0, 0, 0.5), (1, 0, 0.5)], (0, 0, 1))
    before = scene.render(iteration_count=1)
    assert before.image(camera).shape == (2, 4, 3) and len(before.meters(ids["meters"])) == 1
    scene.commit()
    after = scene.render(iteration_count=1)
    assert after.image(camera).shape == (2, 6, 3) and len(after.meters(ids["meters"])) == 2
    assert before.image(camera).shape == (2, 4, 3)
    assert scene.get_meters(ids["meters"]).arrays["positions_m"].tolist() == [[0, 0, 0.5], [1, 0, 0.5]]
    scene.set_meters(ids["meters"], kind=ups.MeterKind.SPHERICAL)
    assert scene.get_meters(ids["meters"]).count == 2
    for wrong in ({"count": 1000}, {"positions_m": [(0, 0, 0)]}):
        with pytest.raises(TypeError):
            scene.set_meters(ids["meters"], **wrong)
    with pytest.raises(TypeError, match="pane_angle_count"):
        scene.set_material(ids["material"], pane_angle_count=1000)


def test_sensors_on_surfaces_and_by_direction(context):
    scene, ids = lit_floor(context)
    triangles = scene.add_surface_meters([ids["instance"]])
    texels = scene.add_lightmap([ids["instance"]], 2, 3)
    directions = scene.add_goniometer(c_deg=[0, 90, 180, 270], gamma_deg=[0, 90, 180])
    eye = scene.add_observer(to_world=ups.translation(0, 0, 1))
    with pytest.raises(TypeError, match="c_count"):  # an array has its own
        scene.add_goniometer(c_deg=[0, 90], gamma_deg=[0, 90, 180], c_count=1000)
    scene.set_surface_meters(triangles, back=1)
    scene.set_lightmap(texels, width=4)
    scene.set_goniometer(directions, gamma_count=5)
    scene.set_observer(eye, to_world=ups.translation(0, 0, 1.5))
    surface, goniometer = scene.get_surface_meters(triangles), scene.get_goniometer(directions)
    assert surface.back == 1 and surface.instances[0] == ids["instance"]
    assert surface.arrays["instances"]["v"].tolist() == [ids["instance"].v]
    assert (scene.get_lightmap(texels).width, scene.get_lightmap(texels).height) == (4, 3)
    assert goniometer.arrays["c_deg"].tolist() == [0, 90, 180, 270] and goniometer.gamma_count == 5
    assert scene.get_observer(eye).to_world[11] == 1.5
    scene.commit()
    result = scene.render(iteration_count=1)
    assert len(result.meters(texels)) == 12 and result.goniometer(directions).shape == (4, 5)


def test_textures_luminaires_and_fixtures(context):
    scene, ids = lit_floor(context)
    texture = scene.add_texture(np.ones((2, 3)))
    texels = np.random.default_rng(3).random((4, 5, 3), np.float32)
    scene.set_texture(texture, texels)
    assert np.array_equal(scene.get_texture(texture), texels)
    table = [[100] * 19]
    profile = ups.Profile.from_table(context, [0], np.linspace(0, 180, 19), table)
    luminaire = scene.add_luminaire(profile, flux_lm=500, to_world=ups.translation(0, 0, 2))
    scene.set_luminaire(luminaire, group=2)
    got = scene.get_luminaire(luminaire)
    assert (got.flux_lm, got.group, got.to_world[11]) == (500, 2, 2)
    scene.set_luminaire(luminaire, ups.Profile.from_table(context, [0], np.linspace(0, 180, 19), [[50] * 19]))
    assert scene.get_luminaire_profile(luminaire).info.peak_cd == 50
    scene.set_maintenance_factor(0.8)
    assert scene.get_maintenance_factor() == 0.8
    fixture = ups.Fixture(context)
    fixture.add_emitter(flux_lm=100, radius_m=0.01)
    placed = scene.add_fixture(fixture, to_world=ups.translation(0, 0, 2))
    scene.set_fixture(placed, dimming=0.25)
    assert scene.get_fixture(placed).dimming == 0.25 and scene.get_fixture(placed).to_world[11] == 2
    scene.remove_texture(texture)


def test_what_is_needed_is_not_removed(context):
    scene, ids = lit_floor(context)
    with pytest.raises(ups.Error, match="mesh 1"):
        scene.remove_material(ids["material"])
    scene.remove_instance(ids["instance"])
    scene.remove_mesh(ids["mesh"])
    scene.remove_material(ids["material"])
    with pytest.raises(ups.Error, match="removed"):
        scene.get_mesh(ids["mesh"])
    scene.commit()
    assert first_lx(scene, ids["meters"]) == pytest.approx(100, rel=1e-4)


def test_a_commit_runs_as_a_job(context):
    scene, ids = lit_floor(context)
    scene.set_dimming(ids["light"], 0.25)
    scene.set_meters(ids["meters"], [(0, 0, 0.5)] * 3, (0, 0, 1))
    with scene.start_commit() as job:
        scene.set_dimming(ids["light"], 1)  # belongs to the next
        assert job.watch(False) == ups.Status.OK and job.poll().state == ups.JobState.FINISHED
    assert scene.is_dirty
    result = scene.render(iteration_count=4)
    assert len(result.meters(ids["meters"])) == 3
    assert result.meters(ids["meters"])["illuminance_lx"][0] == pytest.approx(25, rel=1e-4)
    assert "commit" in result.text()


def ended(job):
    """By the library alone, as nobody waits for it."""
    while ups._convert.lib.ups_job_wait(job, 1000) == ups.Status.TIMEOUT:
        pass


def test_sizes_are_those_of_a_commit_that_nobody_waited_for(context):
    scene = ups.Scene(context)
    scene.add_instance(scene.add_mesh([(-1, -1, 0), (1, -1, 0), (1, 1, 0)], [(0, 1, 2)], scene.add_material()))
    scene.add_light(intensity_rgb=(400, 400, 400), to_world=ups.translation(0, 0, 2.5))
    camera = scene.add_camera(width=16, height=10, to_world=ups.translation(0, 0, 2))
    first = scene.start_commit()
    ended(first)
    assert scene.render(iteration_count=1).image(camera).shape == (10, 16, 3)
    scene.set_camera(camera, width=10, height=16)
    second = scene.start_commit()
    ended(second)
    assert scene.render(iteration_count=1).image(camera).shape == (16, 10, 3)
    scene.set_camera(camera, width=12, height=12)
    scene.commit()
    for earlier in (second, first):
        assert earlier.wait() == ups.Status.OK and earlier.poll().state == ups.JobState.FINISHED
    assert scene.render(iteration_count=1).image(camera).shape == (12, 12, 3)


def test_a_commit_that_is_closed_is_made_or_not(context):
    scene, ids = lit_floor(context)
    for count in range(2, 40):
        scene.set_meters(ids["meters"], [(0, 0, 0.5)] * count, (0, 0, 1))
        job = scene.start_commit()
        if count % 3:
            job.wait(0.0005 * (count % 7))
        if count % 2:
            job.close()
        else:
            del job
        readings = scene.render(iteration_count=1).meters(ids["meters"])
        assert len(readings) == count or scene.is_dirty
        assert np.all(readings["illuminance_lx"] == readings["illuminance_lx"][0])


def test_a_commits_job_has_a_thread_limit_and_a_priority(context):
    scene, ids = lit_floor(context)
    scene.set_dimming(ids["light"], 0.25)
    with scene.start_commit(thread_limit=1, priority=ups.Priority.LOW) as job:
        assert job.watch(False) == ups.Status.OK
    assert not scene.is_dirty
    with pytest.raises(ups.Error, match="priority"):
        scene.start_commit(priority=2)
    with pytest.raises(TypeError):
        scene.start_commit(threads=1)


def test_a_commit_is_held_to_its_memory(context):
    scene, ids = lit_floor(context)
    before = first_lx(scene, ids["meters"])
    side = 200
    y, x = np.mgrid[0:side, 0:side]
    points = np.stack([x / side, y / side, np.sin(x + y) * 1e-3], axis=-1).reshape(-1, 3)
    corner = (y * side + x)[:-1, :-1].ravel()
    triangles = np.concatenate([corner[:, None] + (0, 1, side), corner[:, None] + (1, side + 1, side)])
    scene.add_instance(scene.add_mesh(points, triangles, ids["material"]))
    scene.set_dimming(ids["light"], 0.5)
    with scene.start_commit(memory_limit_bytes=1 << 20) as job:
        with pytest.raises(ups.Error, match="memory_limit_bytes") as refused:
            job.wait()
    assert refused.value.status == ups.Status.ERROR_OUT_OF_MEMORY
    assert scene.is_dirty and first_lx(scene, ids["meters"]) == before
    with scene.start_commit(memory_limit_bytes=1 << 28) as job:
        assert job.wait() == ups.Status.OK
    assert first_lx(scene, ids["meters"]) == pytest.approx(before / 2, rel=1e-3)


def test_jobs_have_a_thread_limit_and_a_priority(context):
    scene, meters = box(context)
    limited = scene.render(iteration_count=4, seed=1, thread_limit=1, priority=ups.Priority.LOW)
    assert limited.meters(meters).tobytes() == scene.render(iteration_count=4, seed=1).meters(meters).tobytes()
