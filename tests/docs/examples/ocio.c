/* Extra: pictures for people. Writes PNG files into the working folder. */
#include <ups/ups_ocio.h>

#include "example.h"

enum { WIDTH = 16, HEIGHT = 12, PIXELS = WIDTH * HEIGHT };

static int is_png(const char *path) {
  char head[4] = {0};
  FILE *file = fopen(path, "rb");
  const int good = file && fread(head, 1, 4, file) == 4 && memcmp(head, "\x89PNG", 4) == 0;
  if (file) fclose(file);
  return good;
}

int main(void) {
  float luminance[3 * PIXELS], error[3 * PIXELS], lux[PIXELS];
  for (int i = 0; i < 3 * PIXELS; ++i) luminance[i] = 50 + (float)(i % 7), error[i] = 3;
  for (int i = 0; i < PIXELS; ++i) lux[i] = (float)i;

  /* [ups_ocio_choose_exposure ups_ocio_last_error] */
  double exposure; /* luminance, cd/m^2, times it is what the view takes */
  if (ups_ocio_choose_exposure(luminance, WIDTH, HEIGHT, &exposure) < 0) fprintf(stderr, "%s\n", ups_ocio_last_error());
  /* [end] */
  expect(exposure > 0.26 / 57 && exposure < 0.26 / 50);

  /* [ups_ocio_get_ev100 ups_ocio_get_exposure] */
  double ev100, same;
  check(ups_ocio_get_ev100(exposure, &ev100));
  check(ups_ocio_get_exposure(ev100, &same));
  /* [end] */
  expect(near(same, exposure, 1e-12) && near(ev100, log2(8 * 0.26 / exposure), 1e-9));

  /* [ups_ocio_write_png] */
  check(ups_ocio_write_png("view.png", luminance, WIDTH, HEIGHT, exposure));
  /* [end] */
  expect(is_png("view.png"));

  /* [ups_ocio_smooth_desc_init ups_ocio_smooth] */
  float smooth_rgb[3 * PIXELS];
  ups_ocio_smooth_desc noisy;
  ups_ocio_smooth_desc_init(&noisy, sizeof noisy);
  noisy.width = WIDTH;
  noisy.height = HEIGHT;
  noisy.luminance_rgb = luminance;
  noisy.standard_error_rgb = error; /* UPS_CHANNEL_STANDARD_ERROR_RGB */
  check(ups_ocio_smooth(&noisy, smooth_rgb)); /* for looking at alone */
  /* [end] */
  expect(fabs(smooth_rgb[300] - 53) < fabs(luminance[300] - 53) + 1e-3);

  /* [ups_ocio_picture_desc_init ups_ocio_write_picture_png] */
  ups_ocio_picture_desc picture;
  ups_ocio_picture_desc_init(&picture, sizeof picture);
  picture.width = WIDTH;
  picture.height = HEIGHT;
  picture.luminance_rgb = smooth_rgb;
  picture.smoothed = 1; /* the picture says so */
  check(ups_ocio_write_picture_png("smoothed.png", &picture));
  /* [end] */
  expect(is_png("smoothed.png"));

  /* [ups_ocio_false_color_desc_init ups_ocio_write_false_color_png] */
  ups_ocio_false_color_desc map;
  ups_ocio_false_color_desc_init(&map, sizeof map);
  map.columns = WIDTH;
  map.rows = HEIGHT;
  map.first_row_at_bottom = 1; /* a grid of meters */
  map.values = lux;
  map.title = "Work plane";
  check(ups_ocio_write_false_color_png("work plane.png", &map));
  /* [end] */
  expect(is_png("work plane.png"));

  /* [ups_ocio_write_pixels_png] */
  const uint8_t rgb[6] = {255, 0, 0, 0, 0, 255}; /* sRGB: a red and a blue pixel */
  check(ups_ocio_write_pixels_png("pixels.png", rgb, 2, 1));
  /* [end] */
  expect(is_png("pixels.png"));
  expect(ups_ocio_write_pixels_png("no such folder/pixels.png", rgb, 2, 1) == UPS_ERROR_IO);
  return 0;
}
