/* Extra: glTF import. Writes example.gltf and its photometric file into the working folder, and reads them. */
#include <ups/ups_gltf.h>

#include "example.h"

static const char scene_file[] =
    "{\"asset\": {\"version\": \"2.0\"}, \"extensionsUsed\": [\"EXT_example\"], \"scene\": 0, \"scenes\": [{\"nodes\": [0, 1]}], \"nodes\": [\n"
    "  {\"name\": \"downlight\", \"translation\": [2, 2.5, -1.5], \"rotation\": [-0.7071068, 0, 0, 0.7071068],\n"
    "   \"extras\": {\"ups\": {\"luminaire\": {\"file\": \"example.ies\"}}}},\n"
    "  {\"name\": \"desk\", \"extras\": {\"ups\": {\"meters\": {\"points_m\": [[1, 0.75, -1], [2, 0.75, -1]],\n"
    "   \"normals\": [[0, 1, 0], [0, 1, 0]]}}}}]}\n";
static const char luminaire_file[] =
    "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 4 1 1 2 0.2 0.2 0\n1 1 18\n0 30 60 90\n0\n500 400 150 0\n";

static void write(const char *path, const char *text) {
  FILE *file = fopen(path, "w");
  expect(file && fputs(text, file) >= 0 && fclose(file) == 0);
}

static void sensors(const ups_gltf_import *file) {
  /* [ups_gltf_get_sensor_count ups_gltf_get_sensor ups_gltf_get_sensor_name] */
  uint32_t count;
  ups_gltf_sensor_info info;
  char name[256];
  check(ups_gltf_get_sensor_count(file, &count));
  for (uint32_t i = 0; i < count; ++i) {
    info.struct_size = sizeof info;
    check(ups_gltf_get_sensor(file, i, &info)); /* info.sensor is its id in the scene */
    check(ups_gltf_get_sensor_name(file, i, name, sizeof name, NULL));
    printf("%s: %u meters\n", name, info.meter_count);
  }
  /* [end] */
  expect(count == 1 && info.kind == UPS_GLTF_METERS && info.meter_count == 2 && strcmp(name, "desk") == 0);

  /* [ups_gltf_read_meters] */
  double at[6];
  check(ups_gltf_read_meters(file, 0, at, NULL, 2)); /* as many as its meter_count; in the scene's frame, +Z up */
  /* [end] */
  expect(near(at[1], 1, 1e-6) && near(at[2], 0.75, 1e-6));
}

int main(void) {
  ups_context *context;
  ups_scene *scene;
  write("example.gltf", scene_file);
  write("example.ies", luminaire_file);
  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));

  /* [ups_gltf_import_desc_init ups_gltf_import_file ups_gltf_last_error] */
  ups_gltf_import_desc desc;
  ups_gltf_import *file;
  ups_gltf_import_desc_init(&desc, sizeof desc);
  desc.camera_width = 640; /* of every camera, instead of what the file says */
  desc.camera_height = 480;
  if (ups_gltf_import_file(context, "example.gltf", &desc, scene, &file) < 0) {
    fprintf(stderr, "%s\n", ups_gltf_last_error()); /* the scene holds part of the file: destroy it */
    return 1;
  }
  /* [end] */
  sensors(file);
  check(ups_scene_commit(scene));

  /* [ups_gltf_get_source_name ups_gltf_get_source_file] */
  char name[256], photometry[256];
  ups_scene_source source;
  source.struct_size = sizeof source;
  check(ups_scene_get_source(scene, 0, &source));
  check(ups_gltf_get_source_name(file, source.kind, source.id, name, sizeof name, NULL));
  check(ups_gltf_get_source_file(file, source.kind, source.id, photometry, sizeof photometry, NULL));
  /* [end] */
  expect(strcmp(name, "downlight") == 0 && strcmp(photometry, "example.ies") == 0);

  /* [ups_gltf_get_place] */
  char place[256]; /* of what a message calls "luminaire 1" */
  check(ups_gltf_get_place(file, UPS_GLTF_PART_LUMINAIRE, 1, place, sizeof place, NULL));
  /* [end] */
  expect(strstr(place, "node ") == place && strstr(place, "downlight"));

  /* [ups_gltf_get_warnings] */
  size_t needed;
  check(ups_gltf_get_warnings(file, NULL, 0, &needed)); /* how much */
  char *warnings = malloc(needed);
  check(ups_gltf_get_warnings(file, warnings, needed, NULL)); /* a line each */
  /* [end] */
  expect(strlen(warnings) + 1 == needed);
  free(warnings);

  /* [ups_gltf_import_destroy] */
  ups_gltf_import_destroy(file); /* the scene stays */
  /* [end] */
  expect(ups_gltf_import_file(context, "none.gltf", NULL, scene, &file) == UPS_ERROR_IO);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
