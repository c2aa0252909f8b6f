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
/* Both: the exposure value at ISO 100 of such a factor, and the other way round: EV100 = log2(8 L), with
 * L = 0.26 / exposure the luminance that the view shows as an 18 % grey (a reflected-light meter of K = 12.5, ISO 2720).
 * ev100: finite, within -100 and 100. */
UPS_API ups_status ups_ocio_get_ev100(double exposure, double *out);
UPS_API ups_status ups_ocio_get_exposure(double ev100, double *out);

/* exposure: the factor of ups_ocio_choose_exposure; 0: chosen from the image. The view is OpenColorIO's built-in ACES
 * output for SDR video, on an sRGB display; no configuration file is read. The file appears whole or not at all, and
 * links, devices and permissions are kept as by ups_exr_write. */
UPS_API ups_status ups_ocio_write_png(const char *path, const float *luminance_rgb, uint32_t width, uint32_t height,
                                      double exposure);

typedef struct ups_ocio_picture_desc {
  uint32_t struct_size;
  uint32_t width, height;
  int32_t smoothed;           /* 1: the picture says "smoothed for display" at its bottom edge, where that fits and
                               * takes a quarter of its height at most, and in the file's text (tEXt "Comment") */
  const float *luminance_rgb; /* as above */
  double exposure;            /* as above */
  int32_t exposure_chosen;    /* 1: it is what ups_ocio_choose_exposure gave; as with exposure 0 the file says so */
  uint32_t reserved;          /* 0 */
} ups_ocio_picture_desc;
UPS_API void ups_ocio_picture_desc_init(ups_ocio_picture_desc *desc, uint32_t struct_size);
/* As ups_ocio_write_png. Both write the exposure as text into the file (tEXt "Exposure"). */
UPS_API ups_status ups_ocio_write_picture_png(const char *path, const ups_ocio_picture_desc *desc);

/* An image with less noise, for looking at, never for numbers: means over neighbours are no measurement of a pixel.
 * Which neighbours a pixel is averaged with is told by the standard errors of all of them, and by what they see:
 * normal, depth and albedo, by which colours are divided meanwhile, so that texture and edges stay. Give LUMINANCE_RGB:
 * a bright speck's error is as large as itself, it is averaged away with its light kept, which ROBUST_RGB lacks.
 * Takes about 10 s a million pixels. */
typedef struct ups_ocio_smooth_desc {
  uint32_t struct_size;
  uint32_t width, height;          /* 1 to 16384 */
  uint32_t reserved;               /* 0 */
  const float *luminance_rgb;      /* 3 floats a pixel each: as above */
  const float *standard_error_rgb; /* < 0: not known */
  const float *albedo_rgb;         /* UPS_CHANNEL_ALBEDO_RGB; this and below: NULL: not used; all finite */
  const float *normal;             /* UPS_CHANNEL_NORMAL */
  const float *depth;              /* 1 float a pixel: UPS_CHANNEL_DEPTH */
} ups_ocio_smooth_desc;
UPS_API void ups_ocio_smooth_desc_init(ups_ocio_smooth_desc *desc, uint32_t struct_size);
/* out_rgb: 3 floats a pixel; may be luminance_rgb itself. */
UPS_API ups_status ups_ocio_smooth(const ups_ocio_smooth_desc *desc, float *out_rgb);

typedef struct ups_ocio_false_color_desc {
  uint32_t struct_size;
  uint32_t columns, rows;
  int32_t first_row_at_bottom; /* 1: grids of meters, 0: images */
  const float *values;         /* columns * rows, columns fastest; < 0 or not finite: not known, shown grey */
  const char *title;           /* ASCII, printed over the picture, at most 16384 pixels wide; NULL: none */
  const char *unit;            /* ASCII, printed at the scale; NULL: "lx" */
  double scale_min, scale_max; /* of the colour scale, within +-1e30, its end rounded up; both 0: 0 to the known values'
                                * 99th percentile. Values beyond its end get its last colour; >= marks the top label. */
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
