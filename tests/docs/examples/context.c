/* Context, status, log. */
#include "example.h"

int main(void) {
  /* [ups_version] */
  const uint32_t version = ups_version(); /* 10203 is 1.2.3 */
  if (version / 100 != UPS_VERSION_MAJOR * 100 + UPS_VERSION_MINOR) fprintf(stderr, "headers of another version\n");
  /* [end] */
  expect(version == UPS_VERSION_MAJOR * 10000 + UPS_VERSION_MINOR * 100 + UPS_VERSION_PATCH);

  /* [ups_context_desc_init ups_context_create] */
  ups_context_desc desc;
  ups_context *context;
  ups_context_desc_init(&desc, sizeof desc);
  desc.thread_count = 2; /* 0: as many as there are processors */
  check(ups_context_create(&desc, &context));
  /* [end] */

  /* [ups_context_get_thread_count] */
  int32_t threads;
  check(ups_context_get_thread_count(context, &threads));
  /* [end] */
  expect(threads >= 1 && threads <= 2);

  /* [ups_last_error ups_status_name] */
  ups_scene *scene;
  const ups_status status = ups_scene_create(NULL, &scene); /* no context: it fails, and scene is as it was */
  if (status < 0) printf("%s: %s\n", ups_status_name(status), ups_last_error());
  /* [end] */
  expect(status == UPS_ERROR_INVALID_ARGUMENT && strcmp(ups_status_name(status), "UPS_ERROR_INVALID_ARGUMENT") == 0);
  expect(strstr(ups_last_error(), "ups_scene_create: context is NULL") != NULL);

  /* A luminaire that is not what a program thinks: a commit warns in the log. */
  check(ups_scene_create(context, &scene));
  add_room(scene);
  add_grid(scene, UPS_METER_PLANAR);
  check(ups_scene_commit(scene));

  int messages = 0;
  /* [ups_context_pop_log] */
  char text[1024];
  size_t needed;
  ups_log_level level;
  while (ups_context_pop_log(context, text, sizeof text, &needed, &level) == UPS_OK && needed > 0)
    printf("%s: %s\n", level == UPS_LOG_WARNING ? "warning" : "note", text), ++messages;
  /* [end] */
  expect(messages > 0); /* no light in the room */

  ups_scene_destroy(scene);
  /* [ups_context_destroy] */
  ups_context_destroy(context); /* results that a program keeps stay */
  /* [end] */
  return 0;
}
