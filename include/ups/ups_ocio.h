/* UPS extra: pictures for people: luminance through OpenColorIO's view transform, illuminance in false colour, as 8-bit
 * PNG files. Library ups_ocio; does not need the core library.
 *
 * The rules of ups_base.h hold; messages are this library's own: ups_ocio_last_error().
 */
#ifndef UPS_OCIO_H
#define UPS_OCIO_H

#include "ups_base.h"

/* The factor that takes luminance, cd/m^2, to the view transform's scene-linear values:
 * 0.26 / (geometric mean of the pixels' luminance between its 5th and 95th percentile, black pixels left out).
 * The view shows 0.26 as an 18 % grey.
 * The same image always gives the same factor; an image without light gives 1.
 * luminance_rgb: 3 floats a pixel, linear Rec.709, row 0 at the top; one that is not finite is
 * UPS_ERROR_INVALID_ARGUMENT. */
UPS_API ups_status ups_ocio_choose_exposure(const float *luminance_rgb, uint32_t width, uint32_t height, double *out);

/* exposure as above; 0: chosen from the image. The view is OpenColorIO's built-in ACES output for SDR video, on an sRGB
 * display; no configuration file is read. The file appears whole or not at all, and links, devices and permissions are
 * kept as by ups_exr_write. */
UPS_API ups_status ups_ocio_write_png(const char *path, const float *luminance_rgb, uint32_t width, uint32_t height,
                                      double exposure);

typedef struct ups_ocio_false_color_desc {
  uint32_t struct_size;
  uint32_t columns, rows;
  int32_t first_row_at_bottom; /* 1: grids of meters, 0: images */
  const float *values;         /* columns * rows, columns fastest; < 0 or not finite: not known, shown grey */
  const char *title;           /* ASCII, printed over the picture; NULL: none */
  const char *unit;            /* ASCII, printed at the scale; NULL: "lx" */
  double scale_min, scale_max; /* of the colour scale, its end rounded up; both 0: 0 to the 99th percentile of the known
                                * values. Values beyond its end get its last colour, and a >= marks the top label. */
} ups_ocio_false_color_desc;

UPS_API void ups_ocio_false_color_desc_init(ups_ocio_false_color_desc *desc, uint32_t struct_size);
/* Small grids are enlarged, each value a rectangle of one colour; beside the picture stands its labelled scale. */
UPS_API ups_status ups_ocio_write_false_color_png(const char *path, const ups_ocio_false_color_desc *desc);

/* 8-bit pixels as they are: 3 bytes a pixel, sRGB, row 0 at the top, rows without gaps. The file appears whole or not
 * at all. */
UPS_API ups_status ups_ocio_write_pixels_png(const char *path, const uint8_t *rgb, uint32_t width, uint32_t height);

/* This thread's last failure of this library, for people. Never NULL; valid until this thread's next failing call. */
UPS_API const char *ups_ocio_last_error(void);

#endif
