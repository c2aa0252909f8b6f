/* As in ups.h beside it: frozen. */
#ifndef UPS_EXR_H
#define UPS_EXR_H
#include "ups.h"
typedef struct ups_exr_channel {
  const char *name;
  const float *data;
  size_t pixel_stride_bytes;
  size_t row_stride_bytes;
} ups_exr_channel;
typedef struct ups_exr_attribute {
  const char *name;
  const char *value;
} ups_exr_attribute;
typedef struct ups_exr_image ups_exr_image;
UPS_API ups_status ups_exr_write(const char *path, uint32_t width, uint32_t height, const ups_exr_channel *channels,
                                 uint32_t channel_count, const ups_exr_attribute *attributes, uint32_t attribute_count);
UPS_API ups_status ups_exr_read(const char *path, ups_exr_image **out);
UPS_API void ups_exr_image_destroy(ups_exr_image *image);
UPS_API ups_status ups_exr_get_size(const ups_exr_image *image, uint32_t *width, uint32_t *height);
UPS_API ups_status ups_exr_get_channel_count(const ups_exr_image *image, uint32_t *out);
UPS_API ups_status ups_exr_get_channel_name(const ups_exr_image *image, uint32_t index, char *text, size_t capacity,
                                            size_t *needed);
UPS_API ups_status ups_exr_get_attribute(const ups_exr_image *image, const char *name, char *text, size_t capacity,
                                         size_t *needed);
UPS_API ups_status ups_exr_read_channel(const ups_exr_image *image, const char *name, float *out, size_t count);
UPS_API const char *ups_exr_last_error(void);
#endif
