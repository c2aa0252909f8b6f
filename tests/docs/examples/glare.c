/* Glare, and what a luminaire's data sheet says. */
#include "example.h"

static ups_sensor_id observer(ups_scene *scene) {
  /* [ups_observer_desc_init ups_scene_add_observer] */
  const double eye[12] = {1, 0, 0, 2, 0, 0, -1, 0.3, 0, 1, 0, 1.2}; /* 1.2 m up, looking along +Y */
  ups_observer_desc desc;
  ups_sensor_id observer;
  ups_observer_desc_init(&desc, sizeof desc);
  memcpy(desc.to_world, eye, sizeof eye);
  check(ups_scene_add_observer(scene, &desc, &observer));
  /* [end] */

  /* [ups_scene_get_observer ups_scene_set_observer] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_observer(scene, observer, &desc));
  desc.position_index = UPS_POSITION_INDEX_GUTH;
  check(ups_scene_set_observer(scene, observer, &desc));
  /* [end] */
  check(ups_scene_get_observer(scene, observer, &desc));
  expect(desc.position_index == UPS_POSITION_INDEX_GUTH && desc.to_world[11] == 1.2);
  return observer;
}

static void rating(const ups_result *result, ups_sensor_id observer) {
  /* [ups_result_get_observer ups_result_get_glare_source] */
  ups_observer_reading glare;
  glare.struct_size = sizeof glare;
  check(ups_result_get_observer(result, observer, &glare));
  printf("UGR %.1f (95 %%: %.1f to %.1f)\n", glare.ugr, glare.ugr_low, glare.ugr_high);
  for (uint32_t i = 0; i < glare.source_count; ++i) { /* the worst first */
    ups_glare_source source;
    source.struct_size = sizeof source;
    check(ups_result_get_glare_source(result, observer, i, &source));
    printf("source %u: %.0f cd/m^2, %.0f %% of the glare\n", source.id, source.luminance_cd_m2, 100 * source.share);
  }
  /* [end] */
  expect(glare.source_count == 1 && glare.ugr > 5 && glare.ugr < 40 && glare.ugr_low <= glare.ugr);
}

static void data_sheet(const ups_profile *profile) {
  /* [ups_profile_get_ugr_table] */
  ups_ugr_table ugr;
  ugr.struct_size = sizeof ugr;
  check(ups_profile_get_ugr_table(profile, &ugr));
  printf("%.0fH x %.0fH, crosswise: %.1f\n", ugr.room_across_h[0], ugr.room_along_h[0], ugr.crosswise[0]);
  /* [end] */
  expect(ugr.crosswise[0] > 5 && ugr.crosswise[0] < 40 && near(ugr.crosswise[0], ugr.endwise[0], 0.1)); /* round */

  /* [ups_profile_get_data_sheet] */
  ups_data_sheet sheet;
  sheet.struct_size = sizeof sheet;
  check(ups_profile_get_data_sheet(profile, 0, &sheet));
  printf("at most %.0f cd/m^2 at 65 degrees\n", sheet.luminance_cd_m2[0]);
  /* [end] */
  expect(sheet.flux_code[3] == 100 && sheet.luminance_cd_m2[0] > sheet.luminance_cd_m2[2]);

  /* [ups_profile_get_utilisation] */
  ups_utilisation_table utilisation;
  utilisation.struct_size = sizeof utilisation;
  check(ups_profile_get_utilisation(profile, &utilisation));
  printf("room index %.2f: %.2f of the flux reaches the plane\n", utilisation.room_index[0], utilisation.factors[0]);
  /* [end] */
  expect(utilisation.factors[0] > 0.1 && utilisation.factors[99] < 1.2);
}

int main(void) {
  /* [ups_glare_get_position_index ups_glare_get_ugr] */
  const float directions[6] = {0, 0.4f, -1, 0.5f, 0.4f, -1}; /* of the eye's frame: it looks along -Z, +Y is up */
  const float luminance_cd_m2[2] = {3000, 3000}, solid_angle_sr[2] = {0.02f, 0.02f};
  float index[2], ugr;
  check(ups_glare_get_position_index(UPS_POSITION_INDEX_TABLE, directions, 2, index));
  check(ups_glare_get_ugr(luminance_cd_m2, solid_angle_sr, index, 2, 30, &ugr)); /* a background of 30 cd/m^2 */
  /* [end] */
  const double sum = 3000.0 * 3000 * 0.02 * (1 / (index[0] * index[0]) + 1 / (index[1] * index[1]));
  expect(index[0] >= 1 && index[1] > index[0] && near(ugr, 8 * log10(0.25 / 30 * sum), 1e-3));

  ups_context *context;
  ups_scene *scene;
  ups_result *result;
  ups_render_desc desc;
  check(ups_context_create(NULL, &context));
  ups_profile *profile = make_downlight(context);
  data_sheet(profile);
  ups_profile_destroy(profile);
  check(ups_scene_create(context, &scene));
  add_room(scene);
  add_downlight(context, scene, 2, 2);
  const ups_sensor_id eye = observer(scene);
  check(ups_scene_commit(scene));
  ups_render_desc_init(&desc, sizeof desc);
  desc.iteration_count = 16;
  check(ups_render(scene, &desc, &result));
  rating(result, eye);
  ups_result_destroy(result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
