/* Extra: maps for people and the lighting report. Writes files into the working folder. */
#include <ups/ups_report.h>

#include "example.h"

static int holds(const char *path, const char *words) {
  static char text[4000000];
  FILE *file = fopen(path, "rb");
  size_t size = file ? fread(text, 1, sizeof text - 1, file) : 0;
  if (file) fclose(file);
  text[size] = '\0';
  return strstr(text, words) != NULL;
}

static void draw_maps(const ups_scene *scene, const ups_result *result, ups_sensor_id meters, ups_sensor_id camera) {
  /* [ups_report_style_desc_init ups_report_map_desc_init ups_report_write_map ups_report_last_error] */
  ups_report_style_desc style;
  ups_report_map_desc map;
  ups_report_style_desc_init(&style, sizeof style);
  style.threshold_lx = 200; /* met, not met, not sure */
  ups_report_map_desc_init(&map, sizeof map);
  map.scene = scene, map.result = result;
  map.sensor = meters;
  map.title = "Desk";
  map.style = &style;
  if (ups_report_write_map("desk.svg", &map) < 0) fprintf(stderr, "%s\n", ups_report_last_error());
  check(ups_report_write_map("desk.pdf", &map));
  /* [end] */
  expect(holds("desk.svg", "Illuminance: Desk") && holds("desk.pdf", "%PDF-"));

  map.sensor = camera, map.title = "View";
  check(ups_report_write_map("view.png", &map));
  expect(holds("view.png", "PNG"));
}

static void write_page(const ups_scene *scene, const ups_result *result, ups_sensor_id meters, ups_sensor_id camera) {
  /* [ups_report_page_desc_init ups_report_write_page] */
  const ups_report_sensor sensors[2] = {{meters, 0, "desk"}, {camera, 0, "view"}};
  ups_report_page_desc page;
  ups_report_page_desc_init(&page, sizeof page);
  page.scene = scene, page.result = result;
  page.sensors = sensors, page.sensor_count = 2;
  page.title = "Study";
  page.targets_json = "{\"areas\": [{\"meters\": \"desk\", \"mean_lx\": 100}]}";
  check(ups_report_write_page("report.html", &page));
  /* [end] */
  expect(holds("report.html", "<h1>Study</h1>") && holds("report.html", "desk") && holds("report.html", "luminaire 1"));

  page.targets_json = "{\"areas\": [{\"meters\": \"shelf\", \"mean_lx\": 100}]}";
  expect(ups_report_write_page("other.html", &page) == UPS_ERROR_INVALID_ARGUMENT);
  expect(strstr(ups_report_last_error(), "no meters 'shelf'; it has desk") != NULL);
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
  const ups_sensor_id meters = add_grid(scene, UPS_METER_PLANAR), camera = add_view(scene, 0);
  check(ups_scene_commit(scene));
  ups_render_desc_init(&desc, sizeof desc);
  desc.iteration_count = 16;
  check(ups_render(scene, &desc, &result));
  draw_maps(scene, result, meters, camera);
  write_page(scene, result, meters, camera);
  ups_result_destroy(result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
