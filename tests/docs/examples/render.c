/* Renders and jobs. */
#include "example.h"

static ups_result *render(const ups_scene *scene, ups_sensor_id meters) {
  /* [ups_render_desc_init ups_render] */
  ups_render_desc desc;
  ups_result *result;
  ups_render_desc_init(&desc, sizeof desc); /* UPS_METHOD_AUTO, every processor */
  desc.target_relative_error = 0.05f;       /* of the worst meter, */
  desc.time_limit_s = 20;                   /* but no longer than this */
  check(ups_render(scene, &desc, &result)); /* waits */
  /* [end] */
  ups_meter_reading readings[METERS];
  check(ups_result_read_meters(result, meters, readings, METERS));
  for (int i = 0; i < METERS; ++i) expect(readings[i].illuminance_lx > 10 && readings[i].error_bound_lx > 0);
  return result;
}

static void watch(const ups_job *job) {
  /* [ups_job_poll] */
  ups_progress progress;
  progress.struct_size = sizeof progress;
  check(ups_job_poll(job, &progress)); /* at once */
  printf("%.0f %%, %u iterations\n", 100 * progress.fraction, progress.iterations_done);
  /* [end] */

  /* [ups_job_get_prediction] */
  ups_prediction prediction;
  prediction.struct_size = sizeof prediction;
  check(ups_job_get_prediction(job, 0.02, &prediction)); /* when will 2 % be reached? */
  if (prediction.seconds >= 0) printf("%.1f s, 95 %%: %.1f to %.1f s\n", prediction.seconds, prediction.seconds_low,
                                      prediction.seconds_high);
  /* [end] */
  expect(prediction.limited_by >= UPS_LIMIT_UNKNOWN);
}

static void look_at_errors(const ups_job *job) {
  /* [ups_job_get_curve_count ups_job_get_curve_point] */
  uint32_t looks;
  check(ups_job_get_curve_count(job, &looks));
  if (looks > 0) { /* none before the first look */
    ups_curve_point last;
    last.struct_size = sizeof last;
    check(ups_job_get_curve_point(job, looks - 1, &last));
    printf("median error %.1f %% after %.1f s\n", 100 * last.median_relative_error, last.elapsed_s);
  }
  /* [end] */

  /* [ups_job_get_largest_error] */
  ups_largest_error worst;
  worst.struct_size = sizeof worst;
  if (ups_job_get_largest_error(job, &worst) == UPS_OK) /* INVALID_STATE before the first look */
    printf("worst: meter %u, %.1f %%\n", worst.index, 100 * worst.relative_error);
  /* [end] */
  expect(looks > 0 && worst.index < METERS);
}

int main(void) {
  ups_context *context;
  ups_scene *scene;
  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  add_room(scene);
  add_downlight(context, scene, 2, 1.5);
  const ups_sensor_id meters = add_grid(scene, UPS_METER_PLANAR);
  check(ups_scene_commit(scene));
  ups_result_destroy(render(scene, meters));

  ups_render_desc desc;
  ups_render_desc_init(&desc, sizeof desc);
  ups_result *none;
  expect(ups_render(scene, &desc, &none) == UPS_ERROR_INVALID_ARGUMENT); /* neither limit nor target */
  desc.time_limit_s = 60;

  /* [ups_scene_estimate_memory] */
  ups_memory_estimate estimate;
  estimate.struct_size = sizeof estimate;
  check(ups_scene_estimate_memory(scene, &desc, &estimate));
  if (estimate.peak_bytes > estimate.allowed_bytes) puts("ups_render would refuse it");
  /* [end] */
  expect(estimate.peak_bytes > 0 && estimate.peak_bytes < estimate.allowed_bytes);

  /* [ups_job_start] */
  ups_job *job;
  check(ups_job_start(scene, &desc, &job)); /* returns at once */
  /* [end] */
  ups_progress progress;
  progress.struct_size = sizeof progress;
  do check(ups_job_poll(job, &progress));
  while (progress.iterations_done < 20 && progress.state == UPS_JOB_RUNNING);

  /* [ups_job_get_memory_estimate] */
  ups_memory_estimate taken;
  taken.struct_size = sizeof taken;
  if (ups_job_get_memory_estimate(job, &taken) == UPS_OK) /* INVALID_STATE while it prepares */
    printf("%.1f MB\n", 1e-6 * (double)taken.peak_bytes);
  /* [end] */
  watch(job);

  /* [ups_job_result] */
  ups_result *result;
  check(ups_job_result(job, &result)); /* what is there by now; the render goes on */
  /* [end] */

  /* [ups_job_wait] */
  const ups_status status = ups_job_wait(job, 100); /* ms */
  if (status == UPS_TIMEOUT) puts("it still renders");
  /* [end] */
  expect(status == UPS_TIMEOUT);

  /* [ups_job_cancel] */
  ups_job_cancel(job); /* asks, and returns at once */
  /* [end] */
  expect(ups_job_wait(job, 10000) == UPS_CANCELLED);
  look_at_errors(job);

  /* [ups_job_destroy] */
  ups_job_destroy(job); /* cancels one that runs, and waits for its end */
  /* [end] */
  ups_result_info info;
  info.struct_size = sizeof info;
  check(ups_result_get_info(result, &info));
  expect(info.iterations >= 20);
  ups_result_destroy(result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
