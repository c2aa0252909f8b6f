/* Extra: OpenEXR images. Writes example.exr into the working folder. */
#include <ups/ups_exr.h>

#include "example.h"

int main(void) {
  const float lux[6] = {100, 200, 300, 400, 500, 600}; /* 3 x 2 pixels, row 0 at the top */
  /* [ups_exr_write ups_exr_last_error] */
  const ups_exr_channel channel = {"Y", lux, 0, 0}; /* tight */
  const ups_exr_attribute unit = {"unit.Y", "lx"};
  if (ups_exr_write("example.exr", 3, 2, &channel, 1, &unit, 1) < 0) fprintf(stderr, "%s\n", ups_exr_last_error());
  /* [end] */

  /* [ups_exr_read ups_exr_get_size] */
  ups_exr_image *image;
  uint32_t width, height;
  check(ups_exr_read("example.exr", &image));
  check(ups_exr_get_size(image, &width, &height));
  /* [end] */
  expect(width == 3 && height == 2);

  /* [ups_exr_get_channel_count ups_exr_get_channel_name] */
  uint32_t count;
  char name[64];
  check(ups_exr_get_channel_count(image, &count));
  for (uint32_t i = 0; i < count; ++i) {
    check(ups_exr_get_channel_name(image, i, name, sizeof name, NULL));
    puts(name);
  }
  /* [end] */
  expect(count == 1 && strcmp(name, "Y") == 0);

  /* [ups_exr_get_attribute] */
  char value[16];
  check(ups_exr_get_attribute(image, "unit.Y", value, sizeof value, NULL));
  /* [end] */
  expect(strcmp(value, "lx") == 0);

  /* [ups_exr_read_channel] */
  const size_t pixels = (size_t)width * height;
  float *read = malloc(pixels * sizeof *read);
  check(ups_exr_read_channel(image, "Y", read, pixels));
  /* [end] */
  expect(memcmp(read, lux, sizeof lux) == 0);
  free(read);
  expect(ups_exr_read_channel(image, "Z", NULL, 6) == UPS_ERROR_INVALID_ARGUMENT);

  /* [ups_exr_image_destroy] */
  ups_exr_image_destroy(image);
  /* [end] */
  expect(ups_exr_read("no such file.exr", &image) == UPS_ERROR_IO && strstr(ups_exr_last_error(), "no such file"));
  return 0;
}
