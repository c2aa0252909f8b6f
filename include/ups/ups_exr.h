/* UPS extra: float images with named channels in OpenEXR files. Library ups_exr; does not need the core library.
 *
 * The rules of ups_base.h hold; messages are this library's own: ups_exr_last_error().
 * Row 0 is the image's top, as in ups_result_read_image.
 */
#ifndef UPS_EXR_H
#define UPS_EXR_H

#include "ups_base.h"

/* Plain array elements: these never grow. */
typedef struct ups_exr_channel {
  const char *name;          /* "R", "Y", "standard_error.R" */
  const float *data;         /* of the top left pixel */
  size_t pixel_stride_bytes; /* 0: 4 */
  size_t row_stride_bytes;   /* 0: tight */
} ups_exr_channel;

typedef struct ups_exr_attribute { /* a string in the file's header, such as "unit.Y" = "lx" */
  const char *name; /* none that OpenEXR has for something else: "type", "version", "chromaticities" */
  const char *value;
} ups_exr_attribute;

typedef struct ups_exr_image ups_exr_image; /* immutable, thread-safe */

/* Writes 32-bit float channels, 1 to 4096 of them, compressed without loss. The file appears whole or not at all: it is
 * written beside its place, synchronised with the disk and renamed. A file that is replaced hands on its permissions;
 * where path is a symbolic link, its target is replaced; a device or a pipe is written to, a named one when it has a
 * reader. */
UPS_API ups_status ups_exr_write(const char *path, uint32_t width, uint32_t height, const ups_exr_channel *channels,
                                 uint32_t channel_count, const ups_exr_attribute *attributes, uint32_t attribute_count);

/* Reads every channel at full resolution of the file's first part as float, up to 4096 of 65536 x 65536 pixels; those
 * with fewer samples than pixels, such as RY and BY of luminance/chroma images, are left out. The image is the file's
 * display window: 0 where a cropped file holds no data, and so much larger as data reach beyond. The caller owns
 * *out. */
UPS_API ups_status ups_exr_read(const char *path, ups_exr_image **out);
UPS_API void ups_exr_image_destroy(ups_exr_image *image); /* NULL ok */
UPS_API ups_status ups_exr_get_size(const ups_exr_image *image, uint32_t *width, uint32_t *height);
UPS_API ups_status ups_exr_get_channel_count(const ups_exr_image *image, uint32_t *out);
/* Both: two calls, text NULL and capacity 0 give *needed (with the final zero), then the text. */
UPS_API ups_status ups_exr_get_channel_name(const ups_exr_image *image, uint32_t index, char *text, size_t capacity,
                                            size_t *needed);
/* INVALID_ARGUMENT where the file has no string attribute of that name. */
UPS_API ups_status ups_exr_get_attribute(const ups_exr_image *image, const char *name, char *text, size_t capacity,
                                         size_t *needed);
/* count must be width * height. INVALID_ARGUMENT names the channels that there are. */
UPS_API ups_status ups_exr_read_channel(const ups_exr_image *image, const char *name, float *out, size_t count);

/* This thread's last failure of this library, for people. Never NULL; valid until this thread's next failing call. */
UPS_API const char *ups_exr_last_error(void);

#endif
