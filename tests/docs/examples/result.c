/* Results: readings and images. */
#include "example.h"

static void read_meters(const ups_result *result, ups_sensor_id meters) {
  /* [ups_result_read_meters] */
  ups_meter_reading readings[METERS]; /* as many as the set has */
  check(ups_result_read_meters(result, meters, readings, METERS));
  for (int i = 0; i < METERS; ++i)
    printf("%.1f lx, within %.1f lx by 95 %%\n", readings[i].illuminance_lx, readings[i].error_bound_lx);
  /* [end] */

  /* [ups_result_view_meters] */
  const ups_meter_reading *own; /* until ups_result_destroy */
  size_t meter_count;
  check(ups_result_view_meters(result, meters, &own, &meter_count));
  for (size_t i = 0; i < meter_count; ++i) printf("%.1f lx\n", own[i].illuminance_lx);
  /* [end] */
  expect(meter_count == METERS && memcmp(own, readings, sizeof readings) == 0);

  /* [ups_result_read_meter_part] */
  ups_meter_part_reading indirect[METERS];
  check(ups_result_read_meter_part(result, meters, UPS_LIGHT_PART_INDIRECT, indirect, METERS));
  /* [end] */
  for (int i = 0; i < METERS; ++i) expect(near(indirect[i].illuminance_lx, readings[i].indirect_lx, 1e-3));

  /* [ups_result_read_meter_flags] */
  uint32_t flags[METERS];
  check(ups_result_read_meter_flags(result, meters, flags, METERS));
  for (int i = 0; i < METERS; ++i)
    if (flags[i] & (UPS_READING_SINGLE_PATH | UPS_READING_HEAVY_TAIL)) printf("meter %d: an unsure interval\n", i);
  /* [end] */
  for (int i = 0; i < METERS; ++i) expect(!(flags[i] & UPS_READING_UNKNOWN));

  double sum_lx = 0, meter_lx = readings[0].illuminance_lx;
  /* [ups_result_get_source_count ups_result_get_source ups_result_read_source_meters] */
  uint32_t count;
  check(ups_result_get_source_count(result, &count)); /* 0 without ups_render_desc.separation */
  for (uint32_t s = 0; s < count; ++s) {
    ups_source_info source;
    ups_meter_reading part[METERS];
    source.struct_size = sizeof source;
    check(ups_result_get_source(result, s, &source));
    check(ups_result_read_source_meters(result, s, meters, part, METERS));
    printf("source %u, %.0f lm: %.1f lx at the first meter\n", source.id, source.flux_lm, part[0].illuminance_lx);
    sum_lx += part[0].illuminance_lx;
  }
  /* [end] */
  expect(count == 2 && near(sum_lx, meter_lx, 1e-4 * meter_lx));
}

static void read_vectors(const ups_result *result, ups_sensor_id vectors) {
  /* [ups_result_read_vectors] */
  ups_vector_reading light[METERS];
  check(ups_result_read_vectors(result, vectors, light, METERS)); /* towards the light, in the world's axes */
  printf("%.1f lx upwards\n", light[0].vector_lx[2]);
  /* [end] */
  expect(light[0].vector_lx[2] > 0);
  /* [ups_result_read_vector_part] */
  ups_vector_part_reading straight[METERS];
  check(ups_result_read_vector_part(result, vectors, UPS_LIGHT_PART_DIRECT, straight, METERS));
  printf("%.1f lx upwards straight from emitters\n", straight[0].vector_lx[2]);
  /* [end] */
  expect(straight[0].vector_lx[2] > light[0].vector_lx[2]); /* the floor sends light up */
}

static void read_image(const ups_result *result, ups_sensor_id camera) {
  /* [ups_result_read_image] */
  float pixels[18][24][3]; /* cd/m^2, row 0 at the top */
  check(ups_result_read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB, &pixels[0][0][0], 0, sizeof pixels));
  /* [end] */
  expect(pixels[9][12][0] > 0);
  expect(ups_result_read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB, &pixels[0][0][0], 0, 8) ==
         UPS_ERROR_BUFFER_TOO_SMALL);

  /* [ups_result_view_image] */
  const float *own; /* until ups_result_destroy; 3 a pixel of this channel, row after row */
  uint32_t width, height;
  check(ups_result_view_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB, &own, &width, &height));
  printf("%ux%u pixels, %.1f cd/m^2 of red at the top left\n", width, height, own[0]);
  /* [end] */
  expect(width == 24 && height == 18 && memcmp(own, pixels, sizeof pixels) == 0);
}

static void read_goniometer(const ups_result *result, ups_sensor_id goniometer) {
  /* [ups_result_get_goniometer_info ups_result_get_goniometer_angles ups_result_read_goniometer] */
  ups_goniometer_info info;
  info.struct_size = sizeof info;
  check(ups_result_get_goniometer_info(result, goniometer, &info));
  const size_t nodes = (size_t)info.c_count * info.gamma_count;
  float *c_deg = malloc(info.c_count * sizeof *c_deg), *gamma_deg = malloc(info.gamma_count * sizeof *gamma_deg);
  ups_intensity_reading *intensities = malloc(nodes * sizeof *intensities);
  check(ups_result_get_goniometer_angles(result, goniometer, c_deg, info.c_count, gamma_deg, info.gamma_count));
  check(ups_result_read_goniometer(result, goniometer, intensities, nodes)); /* gamma fastest */
  printf("C%.0f, gamma %.0f: %.1f cd\n", c_deg[0], gamma_deg[1], intensities[1].intensity_cd);
  /* [end] */
  expect(near(info.light_output_ratio, 1, 1e-3) && gamma_deg[1] == 5); /* nothing takes the light away */
  expect(near(intensities[0].intensity_cd, 1000, 100));
  free(c_deg), free(gamma_deg), free(intensities);

  /* [ups_result_get_goniometer_beam] */
  ups_goniometer_beam beam;
  beam.struct_size = sizeof beam;
  check(ups_result_get_goniometer_beam(result, goniometer, 0, 0.5f, &beam));
  printf("beam angle %.1f degrees, 95 %%: %.1f to %.1f\n", beam.angle_deg, beam.low_deg, beam.high_deg);
  /* [end] */
  expect(beam.low_deg <= 96.3f && 95.7f <= beam.high_deg); /* the table falls to a half at 48 degrees */

  /* [ups_result_get_goniometer_profile] */
  ups_profile *profile;
  check(ups_result_get_goniometer_profile(result, goniometer, &profile)); /* for ups_profile_write, or luminaires */
  /* [end] */
  ups_profile_destroy(profile);
}

static void measure_downlight(ups_context *context) {
  ups_scene *scene;
  ups_goniometer_desc desc;
  ups_sensor_id goniometer;
  ups_render_desc render;
  ups_result *result;
  check(ups_scene_create(context, &scene));
  add_downlight(context, scene, 0, 0);
  ups_goniometer_desc_init(&desc, sizeof desc);
  desc.symmetry = UPS_SYMMETRY_AXIAL, desc.c_count = 1, desc.gamma_count = 37;
  check(ups_scene_add_goniometer(scene, &desc, &goniometer));
  check(ups_scene_commit(scene));
  ups_render_desc_init(&render, sizeof render);
  render.iteration_count = 8;
  check(ups_render(scene, &render, &result));
  read_goniometer(result, goniometer);
  ups_result_destroy(result);
  ups_scene_destroy(scene);
}

int main(void) {
  ups_context *context;
  ups_scene *scene;
  ups_result *result;
  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  add_room(scene);
  add_downlight(context, scene, 1, 1.5);
  add_downlight(context, scene, 3, 1.5);
  const ups_sensor_id meters = add_grid(scene, UPS_METER_PLANAR), vectors = add_grid(scene, UPS_METER_VECTOR);
  const ups_sensor_id camera = add_view(scene, 0);
  check(ups_scene_commit(scene));
  ups_render_desc desc;
  ups_render_desc_init(&desc, sizeof desc);
  desc.iteration_count = 6;
  desc.separation = UPS_SEPARATE_LUMINAIRES;
  check(ups_render(scene, &desc, &result));

  /* [ups_result_get_info] */
  ups_result_info info;
  info.struct_size = sizeof info;
  check(ups_result_get_info(result, &info));
  printf("%u iterations, %.2f s, %.0f lm emitted\n", info.iterations, info.elapsed_s, info.emitted_flux_lm);
  /* [end] */
  expect(info.iterations == 6 && info.method != UPS_METHOD_AUTO && info.dropped_samples == 0);

  /* [ups_result_get_text] */
  size_t needed;
  check(ups_result_get_text(result, UPS_TEXT_WARNINGS, NULL, 0, &needed)); /* how much */
  char *warnings = malloc(needed);
  check(ups_result_get_text(result, UPS_TEXT_WARNINGS, warnings, needed, NULL));
  if (warnings[0]) printf("%s\n", warnings); /* a line each: show them with the numbers */
  char techniques[2048];
  check(ups_result_get_text(result, UPS_TEXT_TECHNIQUES, techniques, sizeof techniques, NULL)); /* how light was found */
  /* [end] */
  expect(techniques[0]);
  free(warnings);
  read_meters(result, meters);
  read_vectors(result, vectors);
  read_image(result, camera);
  measure_downlight(context);

  /* [ups_result_destroy] */
  ups_result_destroy(result); /* what was read from it stays */
  /* [end] */
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
