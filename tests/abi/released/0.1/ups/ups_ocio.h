/* As in ups.h beside it: frozen. */
#ifndef UPS_OCIO_H
#define UPS_OCIO_H
#include "ups.h"
UPS_API ups_status ups_ocio_choose_exposure(const float *luminance_rgb, uint32_t width, uint32_t height, double *out);
UPS_API ups_status ups_ocio_write_png(const char *path, const float *luminance_rgb, uint32_t width, uint32_t height,
                                      double exposure);
typedef struct ups_ocio_false_color_desc {
  uint32_t struct_size;
  uint32_t columns, rows;
  int32_t first_row_at_bottom;
  const float *values;
  const char *title;
  const char *unit;
  double scale_min, scale_max;
} ups_ocio_false_color_desc;
UPS_API void ups_ocio_false_color_desc_init(ups_ocio_false_color_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_ocio_write_false_color_png(const char *path, const ups_ocio_false_color_desc *desc);
UPS_API const char *ups_ocio_last_error(void);
#endif
