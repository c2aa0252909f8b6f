/* Fixtures: a downlight of parts, and where it stands. */
#include "example.h"

static ups_fixture_part_id add_parts(ups_fixture *fixture) {
  /* [ups_fixture_emitter_desc_init ups_fixture_add_emitter] */
  ups_fixture_emitter_desc cob;
  ups_fixture_part_id chip;
  ups_fixture_emitter_desc_init(&cob, sizeof cob); /* a disc that shines along -Z */
  cob.radius_m = 0.0045;
  cob.flux_lm = 1000;
  check(ups_fixture_add_emitter(fixture, &cob, &chip));
  /* [end] */

  /* [ups_reflector_desc_init ups_fixture_add_reflector] */
  ups_reflector_desc cup;
  ups_reflector_desc_init(&cup, sizeof cup); /* a paraboloid of specular aluminium, its focus at the origin */
  cup.focal_length_m = 0.004;
  cup.inner_radius_m = 0.008;
  cup.aperture_radius_m = 0.025;
  check(ups_fixture_add_reflector(fixture, &cup, NULL)); /* NULL: nobody asks for its number */
  /* [end] */

  /* [ups_lens_desc_init ups_fixture_add_lens] */
  ups_lens_desc cover;
  ups_lens_desc_init(&cover, sizeof cover); /* flat faces: a plate */
  cover.finish = UPS_FINISH_FROSTED_PMMA;
  cover.radius_m = 0.026;
  cover.thickness_m = 0.002;
  cover.to_fixture[11] = -0.0351; /* below the reflector */
  check(ups_fixture_add_lens(fixture, &cover, NULL));
  /* [end] */

  /* [ups_fixture_part_desc_init ups_fixture_add_part] */
  const float corners[9] = {-0.05f, -0.05f, 0.01f, 0.05f, -0.05f, 0.01f, 0, 0.05f, 0.01f};
  const uint32_t triangle[3] = {0, 1, 2};
  ups_mesh_desc mesh;
  ups_fixture_part_desc plate;
  ups_mesh_desc_init(&mesh, sizeof mesh);
  mesh.vertex_count = 3, mesh.triangle_count = 1, mesh.positions_m = corners, mesh.indices = triangle;
  ups_fixture_part_desc_init(&plate, sizeof plate);
  plate.finish = UPS_FINISH_BLACK;
  plate.mesh = &mesh; /* m, in the fixture's frame */
  check(ups_fixture_add_part(fixture, &plate, NULL));
  /* [end] */
  return chip;
}

static void collimator(ups_context *context) {
  ups_fixture *fixture;
  check(ups_fixture_create(context, &fixture));
  /* [ups_collimator_desc_init ups_fixture_add_collimator] */
  ups_collimator_desc lens;
  ups_collimator_desc_init(&lens, sizeof lens); /* PMMA; wall and lens turn light of the origin parallel */
  lens.cavity_radius_m = 0.003;
  lens.cavity_depth_m = 0.005;
  lens.wall_thickness_m = 0.001;
  check(ups_fixture_add_collimator(fixture, &lens, NULL));
  /* [end] */
  ups_fixture_destroy(fixture);
}

int main(void) {
  ups_context *context;
  ups_scene *scene;
  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  collimator(context);

  /* [ups_fixture_create] */
  ups_fixture *fixture;
  check(ups_fixture_create(context, &fixture)); /* then its parts */
  /* [end] */
  const ups_fixture_part_id chip = add_parts(fixture);

  /* [ups_fixture_get_info] */
  ups_fixture_info info;
  info.struct_size = sizeof info;
  check(ups_fixture_get_info(fixture, &info));
  printf("%u parts, %.0f lm\n", info.part_count, info.flux_lm);
  /* [end] */
  expect(info.part_count == 4 && near(info.flux_lm, 1000, 1e-3));

  /* [ups_fixture_instance_desc_init ups_scene_add_fixture] */
  ups_fixture_instance_desc place;
  ups_fixture_id placed;
  ups_fixture_instance_desc_init(&place, sizeof place);
  place.to_world[11] = 2.5; /* m; light leaves along local -Z */
  check(ups_scene_add_fixture(scene, fixture, &place, &placed));
  /* [end] */

  /* [ups_fixture_destroy] */
  ups_fixture_destroy(fixture); /* what was placed stays */
  /* [end] */

  /* [ups_scene_get_fixture ups_scene_set_fixture] */
  place.struct_size = sizeof place;
  check(ups_scene_get_fixture(scene, placed, &place));
  place.flux_lm = 800; /* all emitters together */
  check(ups_scene_set_fixture(scene, placed, &place));
  /* [end] */

  /* [ups_scene_set_fixture_dimming ups_scene_set_fixture_transform] */
  const double lower[12] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 2.2};
  check(ups_scene_set_fixture_dimming(scene, placed, 0.5f));
  check(ups_scene_set_fixture_transform(scene, placed, lower));
  /* [end] */

  /* [ups_scene_get_fixture_instance] */
  ups_instance_id instance;
  check(ups_scene_get_fixture_instance(scene, placed, chip, &instance)); /* UPS_SEPARATE_LUMINAIRES tells it apart */
  /* [end] */
  expect(instance.v != 0);
  check(ups_scene_commit(scene));
  ups_scene_info committed;
  committed.struct_size = sizeof committed;
  check(ups_scene_get_info(scene, &committed));
  expect(near(committed.emitted_flux_lm, 400, 0.1) && committed.effects & UPS_EFFECT_CAUSTICS);

  /* [ups_scene_remove_fixture] */
  check(ups_scene_remove_fixture(scene, placed));
  /* [end] */
  check(ups_scene_commit(scene));
  check(ups_scene_get_info(scene, &committed));
  expect(committed.emitted_flux_lm == 0);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
