/* The samples that weigh most, and one of them traced again. */
#include "example.h"

int main(void) {
  ups_context *context;
  ups_scene *scene;
  ups_result *result;
  ups_render_desc desc;
  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  add_room(scene);
  add_downlight(context, scene, 2, 1.5);
  const ups_sensor_id camera = add_view(scene, 0);
  check(ups_scene_commit(scene));
  ups_render_desc_init(&desc, sizeof desc);
  desc.iteration_count = 4;
  check(ups_render(scene, &desc, &result));

  /* [ups_result_read_largest_samples] */
  ups_sample samples[64]; /* never more */
  size_t count;
  check(ups_result_read_largest_samples(result, camera, samples, 64, &count)); /* the largest first */
  /* [end] */
  expect(count > 0 && samples[0].share >= samples[count - 1].share);

  /* [ups_replay] */
  ups_path *path;
  check(ups_replay(scene, &desc, &samples[0], &path)); /* desc as of the render */
  /* [end] */

  /* [ups_path_get_info ups_path_read_vertices] */
  ups_path_info info;
  ups_path_vertex vertices[64];
  size_t vertex_count;
  info.struct_size = sizeof info;
  check(ups_path_get_info(path, &info));
  check(ups_path_read_vertices(path, vertices, 64, &vertex_count)); /* BUFFER_TOO_SMALL: vertex_count says how many */
  /* [end] */
  expect(near(info.value, samples[0].value, 1e-4 * samples[0].value) && vertices[0].event == UPS_EVENT_START);

  /* [ups_path_read_contributions] */
  size_t contribution_count;
  check(ups_path_read_contributions(path, NULL, 0, &contribution_count)); /* how many */
  ups_path_contribution *contributions = malloc(contribution_count * sizeof *contributions);
  check(ups_path_read_contributions(path, contributions, contribution_count, &contribution_count));
  /* [end] */
  double sum = 0;
  for (size_t i = 0; i < contribution_count; ++i) sum += contributions[i].value;
  if (samples[0].walk == UPS_WALK_EYE) expect(near(sum, info.value, 1e-3 * info.value));
  free(contributions);

  /* [ups_path_get_text] */
  size_t needed;
  check(ups_path_get_text(path, NULL, 0, &needed)); /* how much */
  char *text = malloc(needed);
  check(ups_path_get_text(path, text, needed, NULL));
  puts(text); /* a line a vertex, and the largest contributions */
  /* [end] */
  expect(strlen(text) > 20);
  free(text);

  /* [ups_path_destroy] */
  ups_path_destroy(path);
  /* [end] */
  ups_result_destroy(result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
