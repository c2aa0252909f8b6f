/* The least that uses each extra: an image written and read, a picture, a map, and a scene that is imported. */
#include <stdio.h>
#include <ups/ups.h>
#include <ups/ups_exr.h>
#include <ups/ups_gltf.h>
#include <ups/ups_ocio.h>
#include <ups/ups_report.h>

#define CHECK(call)                                                                                  \
  do {                                                                                               \
    if ((call) != UPS_OK) {                                                                          \
      fprintf(stderr, "%s:%d: %s: %s%s%s%s%s\n", __FILE__, __LINE__, #call, ups_last_error(),        \
              ups_gltf_last_error(), ups_exr_last_error(), ups_ocio_last_error(),                    \
              ups_report_last_error());                                                              \
      return 1;                                                                                      \
    }                                                                                                \
  } while (0)

static int write_scene(const char *path) {
  FILE *file = fopen(path, "w");
  return file && fputs("{\"asset\": {\"version\": \"2.0\"}}\n", file) >= 0 && fclose(file) == 0 ? UPS_OK : UPS_ERROR_IO;
}

int main(void) {
  static const float white[12] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  const uint32_t version = ups_version();
  uint32_t width, height, sensors;
  ups_exr_image *image;
  ups_context *context;
  ups_scene *scene;
  ups_gltf_import *import_result;
  ups_exr_channel channel;
  ups_report_map_desc map;

  channel.name = "Y";
  channel.data = white;
  channel.pixel_stride_bytes = 0;
  channel.row_stride_bytes = 0;
  CHECK(ups_exr_write("consumer.exr", 2, 2, &channel, 1, NULL, 0));
  CHECK(ups_exr_read("consumer.exr", &image));
  CHECK(ups_exr_get_size(image, &width, &height));
  ups_exr_image_destroy(image);
  CHECK(ups_ocio_write_png("consumer.png", white, 2, 2, 1));
  ups_report_map_desc_init(&map, sizeof map);
  map.values = white;
  map.count = 12;
  map.columns = 4;
  CHECK(ups_report_write_map("consumer_map.png", &map));
  CHECK(write_scene("consumer.gltf"));
  CHECK(ups_context_create(NULL, &context));
  CHECK(ups_scene_create(context, &scene));
  CHECK(ups_gltf_import_file(context, "consumer.gltf", NULL, scene, &import_result));
  CHECK(ups_gltf_get_sensor_count(import_result, &sensors));
  ups_gltf_import_destroy(import_result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  printf("UPS %u.%u.%u: %ux%u pixels, %u sensors\n", (unsigned)(version / 10000), (unsigned)(version / 100 % 100),
         (unsigned)(version % 100), (unsigned)width, (unsigned)height, (unsigned)sensors);
  return !(width == 2 && height == 2 && sensors == 0);
}
