/* How sure: statistics, errors, predictions, and what found the light. */
#include "example.h"

static void statistics(const ups_result *result, ups_sensor_id desk, ups_sensor_id faces) {
  /* [ups_result_get_meter_statistics] */
  ups_meter_statistics s;
  s.struct_size = sizeof s;
  check(ups_result_get_meter_statistics(result, desk, &s));
  printf("mean %.1f lx within %.1f lx, U0 %.2f (95 %%: %.2f to %.2f)\n", s.mean_lx, s.mean_error_bound_lx, s.uniformity,
         s.uniformity_low, s.uniformity_high);
  /* [end] */
  expect(s.count == METERS && s.uniformity_low <= s.uniformity && s.mean_error_bound_lx > 0);

  /* [ups_result_get_meter_percentile] */
  ups_interval median;
  check(ups_result_get_meter_percentile(result, desk, 0.5, &median));
  /* [end] */
  expect(s.min_lx < median.value && median.value < s.max_lx && median.low <= median.value);

  /* [ups_result_get_meter_share] */
  ups_interval share;
  check(ups_result_get_meter_share(result, desk, 100, &share)); /* of the meters with at least 100 lx */
  if (share.low > 0.9) puts("nine tenths have 100 lx, surely");
  /* [end] */
  expect(share.value >= 0 && share.value <= 1);

  /* [ups_result_get_meter_ratio] */
  ups_interval ratio;
  check(ups_result_get_meter_ratio(result, faces, desk, &ratio)); /* mean over mean */
  /* [end] */

  /* [ups_result_read_meter_ratios] */
  ups_interval modelling[METERS]; /* cylindrical over horizontal, meter by meter */
  check(ups_result_read_meter_ratios(result, faces, desk, modelling, METERS));
  /* [end] */
  expect(ratio.value > 0.1 && ratio.value < 1 && modelling[0].low <= modelling[0].value);
}

static void errors(const ups_result *result) {
  /* [ups_result_get_prediction] */
  ups_prediction prediction;
  prediction.struct_size = sizeof prediction;
  check(ups_result_get_prediction(result, 0.01, &prediction)); /* what would 1 % have taken? */
  if (prediction.limited_by == UPS_LIMIT_BIAS) puts("bias is in the way: time alone helps slowly");
  /* [end] */
  expect(prediction.limited_by != UPS_LIMIT_UNKNOWN);

  /* [ups_result_get_curve_count ups_result_get_curve_point] */
  uint32_t looks;
  check(ups_result_get_curve_count(result, &looks));
  for (uint32_t i = 0; i < looks; ++i) {
    ups_curve_point point;
    point.struct_size = sizeof point;
    check(ups_result_get_curve_point(result, i, &point));
    printf("%u iterations: worst %.1f %%\n", point.iterations, 100 * point.worst_relative_error);
  }
  /* [end] */

  /* [ups_result_read_convergence] */
  size_t count;
  check(ups_result_read_convergence(result, NULL, 0, &count)); /* how many */
  ups_convergence_point *points = malloc(count * sizeof *points);
  check(ups_result_read_convergence(result, points, count, &count));
  /* [end] */
  expect(looks >= 2 && count == looks && points[count - 1].iterations == 20);
  free(points);

  /* [ups_result_get_largest_error] */
  ups_largest_error worst;
  worst.struct_size = sizeof worst;
  check(ups_result_get_largest_error(result, &worst));
  printf("meter %u of sensor %u at %.1f, %.1f: %.1f %%\n", worst.index, worst.sensor.v, worst.position_m[0],
         worst.position_m[1], 100 * worst.relative_error);
  /* [end] */
  expect(worst.index < METERS && worst.relative_error > 0);
}

static void techniques(const ups_result *result, ups_sensor_id camera) {
  /* [ups_result_get_choice] */
  ups_sensor_choice choice;
  choice.struct_size = sizeof choice;
  check(ups_result_get_choice(result, camera, &choice));
  if (choice.techniques & UPS_TECHNIQUE_MERGE) puts("photons are merged in some part of the image");
  /* [end] */
  expect(choice.techniques & UPS_TECHNIQUE_LIGHT_SAMPLE);

  double direct = 0;
  /* [ups_result_get_technique_count ups_result_get_technique ups_result_read_technique] */
  uint32_t count;
  check(ups_result_get_technique_count(result, camera, &count)); /* 0 without ups_render_desc.technique_images */
  for (uint32_t i = 0; i < count; ++i) {
    ups_technique_info info;
    float image[18][24][3];
    info.struct_size = sizeof info;
    check(ups_result_get_technique(result, camera, i, &info));
    check(ups_result_read_technique(result, camera, i, UPS_CONTRIBUTION_WEIGHTED, &image[0][0][0], 0, sizeof image));
    if (info.edges == 2) direct += image[16][12][1]; /* eye, surface, emitter */
  }
  /* [end] */
  expect(count > 0 && direct > 0);
}

int main(void) {
  ups_context *context;
  ups_scene *scene;
  ups_result *result;
  ups_render_desc desc;
  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  add_room(scene);
  add_downlight(context, scene, 2, 1.5);
  const ups_sensor_id desk = add_grid(scene, UPS_METER_PLANAR), faces = add_grid(scene, UPS_METER_CYLINDRICAL);
  const ups_sensor_id camera = add_view(scene, 0);
  check(ups_scene_commit(scene));
  ups_render_desc_init(&desc, sizeof desc);
  desc.iteration_count = 20;
  desc.technique_images = 3;
  check(ups_render(scene, &desc, &result));
  statistics(result, desk, faces);
  errors(result);
  techniques(result, camera);
  ups_result_destroy(result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
