/* Commit, and what a committed scene shows. */
#include "example.h"

static void show(const ups_scene *scene) {
  /* [ups_scene_get_info] */
  ups_scene_info info;
  info.struct_size = sizeof info;
  check(ups_scene_get_info(scene, &info));
  printf("%llu triangles, %.0f lm, %s caustics\n", (unsigned long long)info.triangle_count, info.emitted_flux_lm,
         info.effects & UPS_EFFECT_CAUSTICS ? "with" : "without");
  /* [end] */
  expect(info.triangle_count == 12 && info.meter_count == METERS && !(info.effects & UPS_EFFECT_CAUSTICS));
  expect(info.effects & UPS_EFFECT_INTERREFLECTION && near(info.emitted_flux_lm, 2405, 1));

  /* [ups_scene_get_text] */
  size_t needed;
  check(ups_scene_get_text(scene, UPS_SCENE_TEXT_TECHNIQUES, NULL, 0, &needed)); /* how much */
  char *text = malloc(needed);
  check(ups_scene_get_text(scene, UPS_SCENE_TEXT_TECHNIQUES, text, needed, NULL));
  puts(text); /* which are on or off, and why */
  /* [end] */
  expect(strlen(text) > 0);
  free(text);

  /* [ups_scene_read_section] */
  const double at[3] = {0, 1.5, 0}, along_y[3] = {0, 1, 0};
  size_t count;
  check(ups_scene_read_section(scene, at, along_y, NULL, 0, &count)); /* how many */
  ups_segment *section = malloc(count * sizeof *section);
  check(ups_scene_read_section(scene, at, along_y, section, count, &count));
  /* [end] */
  double length = 0;
  for (size_t i = 0; i < count; ++i)
    length += hypot(section[i].to_m[0] - section[i].from_m[0], section[i].to_m[2] - section[i].from_m[2]);
  expect(near(length, 2 * (4 + 2.5), 1e-6)); /* once around floor, walls and ceiling */
  free(section);

  /* [ups_scene_read_outlines] */
  const double beneath_ceiling[3] = {0, 0, 2.4}, up[3] = {0, 0, 1};
  ups_segment edges[64];
  check(ups_scene_read_outlines(scene, beneath_ceiling, up, INFINITY, edges, 64, &count)); /* a plan */
  /* [end] */
  expect(count >= 4);
}

int main(void) {
  ups_context *context;
  ups_scene *scene;
  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  const ups_instance_id room = add_room(scene);
  add_downlight(context, scene, 2, 1.5);
  add_grid(scene, UPS_METER_PLANAR);
  ups_scene_info none;
  none.struct_size = sizeof none;
  expect(ups_scene_get_info(scene, &none) == UPS_ERROR_INVALID_STATE); /* never committed */

  /* [ups_scene_commit] */
  check(ups_scene_commit(scene)); /* edits take effect; renders that run keep what they started with */
  /* [end] */
  show(scene);

  const double moved[12] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0};
  check(ups_scene_set_transform(scene, room, moved));
  /* [ups_scene_is_dirty] */
  int32_t dirty;
  check(ups_scene_is_dirty(scene, &dirty));
  if (dirty) puts("a render would show the scene as it was at the last commit");
  /* [end] */
  expect(dirty == 1);

  /* [ups_scene_start_commit] */
  ups_job *job;
  check(ups_scene_start_commit(scene, &job)); /* returns at once */
  check(ups_job_wait(job, 10000));            /* or ups_job_poll meanwhile, as for a render */
  ups_job_destroy(job);
  /* [end] */
  check(ups_scene_is_dirty(scene, &dirty));
  expect(dirty == 0);

  /* [ups_commit_desc_init ups_scene_start_commit_with] */
  ups_commit_desc desc;
  ups_commit_desc_init(&desc, sizeof desc);
  desc.priority = UPS_PRIORITY_LOW; /* what the window draws comes first */
  ups_job *humble;
  check(ups_scene_start_commit_with(scene, &desc, &humble));
  check(ups_job_wait(humble, 10000));
  ups_job_destroy(humble);
  /* [end] */
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
