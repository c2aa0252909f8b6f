/* UPS extra: what people read of a render: maps of illuminance and luminance as PNG, SVG or PDF, and the lighting
 * report as one HTML page. Library ups_report; needs the core library.
 *
 * The rules of ups_base.h hold; messages are this library's own: ups_report_last_error(). Calls of the core within may
 * change ups_last_error(), too. Files appear whole or not at all, and links, devices and permissions are kept as by
 * ups_exr_write. Numbers in them have a point, whatever the locale. Letters are those of the system's sans-serif font;
 * where there is no font at all Cairo draws plain ones, and fontconfig says on standard error what it misses.
 */
#ifndef UPS_REPORT_H
#define UPS_REPORT_H

#include "ups_glare.h"
#include "ups_render.h"
#include "ups_sensor.h"
#include "ups_statistics.h"

typedef int32_t ups_report_scale;
enum {
  UPS_REPORT_SCALE_LINEAR = 0,
  UPS_REPORT_SCALE_LOGARITHMIC = 1 /* isolines at the steps of EN 12464-1: 1, 1.5, 2, 3, 5, 7.5 times powers of ten */
};
/* All rise evenly in lightness from low to high. */
typedef int32_t ups_report_colours;
enum { UPS_REPORT_COLOURS_VIRIDIS = 0, UPS_REPORT_COLOURS_CIVIDIS = 1, UPS_REPORT_COLOURS_GREY = 2 };

/* How maps look. */
typedef struct ups_report_style_desc {
  uint32_t struct_size;
  ups_report_scale scale;
  ups_report_colours colours;
  int32_t isolines;         /* 1 (default): drawn, with their values; 0: not */
  int32_t numbers;          /* 1 (default): at the meters, where there is room for them; 0: none */
  int32_t cells;            /* 1: each cell in one colour, without what lies between the values; 0 (default) */
  double low, high;         /* ends of the colours, in the values' unit, low 0 or at least 1e-12, 1e-9 <= high <= 1e12, of
                             * a logarithmic scale low > 0; both 0: the values decide */
  double threshold_lx;      /* of illuminances: > 0: what meets it, what does not, and of what the 95 % bound crosses
                             * it, in three colours; 0: none */
  double threshold_cd_m2;   /* the same of luminances */
  double width;             /* at most, in units of 1/96 inch, 150 to 4000; default 680, which is 180 mm */
  double height;            /* the same, 300 to 4000; default 560 */
  double zoom;              /* pixels of a PNG a unit, 0.1 to 8, and 16384 pixels a side; default 2: 192 an inch */
} ups_report_style_desc;

typedef int32_t ups_report_quantity;
enum {
  UPS_REPORT_QUANTITY_AUTO = 0, /* of meters and points illuminance, of cameras and images luminance */
  UPS_REPORT_QUANTITY_ILLUMINANCE = 1,
  UPS_REPORT_QUANTITY_LUMINANCE = 2
};

/* A sensor of the scene, and what people call it. */
typedef struct ups_report_sensor { /* a plain array element: it never grows */
  ups_sensor_id sensor;
  uint32_t reserved; /* 0 */
  const char *name;  /* NULL: by its kind and number, "meters 1" */
} ups_report_sensor;

/* A map is of a sensor in a result, or of plain numbers.
 *   sensor     result and scene are set. Meters that lie in a plane: a grid, or points, where they lie on a lattice
 *              with gaps, as those of EN 12464-1 in an L-shaped room do, that is found. A camera: its image.
 *   points     positions_m, values: count meters in a plane. Beneath them the plan of the scene, where one is given.
 *   image      values alone, columns a row: count pixels, row 0 at the top.
 */
typedef struct ups_report_map_desc {
  uint32_t struct_size;
  ups_report_quantity quantity;
  const ups_scene *scene;             /* committed: of the sensor; what the map's plane cuts and what lies beneath it
                                       * are drawn. Of points it may be NULL */
  const ups_result *result;           /* NULL: the map is of the numbers below */
  ups_sensor_id sensor;               /* of meters or a camera */
  uint32_t sensor_count;
  const ups_report_sensor *sensors;   /* sensor_count: observers to draw where the plane is level, and the name of
                                       * `sensor`; others are left out. NULL with 0: none */
  const char *title;                  /* NULL: the name of the sensor, else none */
  const ups_report_style_desc *style; /* NULL: the defaults */
  const double *positions_m;          /* 3 * count; NULL: an image */
  const float *normals;               /* 3 * count, any length > 0: who looks sees them come towards him. NULL: up */
  const float *values;                /* count, lx or cd/m^2; < 0 or not finite: not known */
  const float *error_bounds;          /* count, 95 %, in the values' unit; < 0 or not finite: not known. NULL: none */
  uint32_t count;                     /* 1 to 4,000,000 of points */
  uint32_t columns;                   /* of points that are all cells of a grid, row by row; 0: found out. Of an image
                                       * its width, >= 1 */
} ups_report_map_desc;

UPS_API void ups_report_style_desc_init(ups_report_style_desc *desc, uint32_t struct_size);
UPS_API void ups_report_map_desc_init(ups_report_map_desc *desc, uint32_t struct_size);
/* path: ends in .png, .svg or .pdf, which decides what is written. SVG documents have a title and a description for
 * those who cannot see them, letters are outlines. Errors: UNSUPPORTED where meters lie on surfaces, in no plane or on
 * one line, or are too many; INVALID_STATE where the scene is not committed, has edits that are
 * not, or was committed with edits since the result's render began. */
UPS_API ups_status ups_report_write_map(const char *path, const ups_report_map_desc *desc);

/* A source of light, and what people call it. */
typedef struct ups_report_source { /* a plain array element: it never grows */
  ups_source_kind kind; /* UPS_SOURCE_LUMINAIRE, of lights too, or UPS_SOURCE_INSTANCE */
  uint32_t id;          /* the v of its ups_luminaire_id or ups_instance_id */
  const char *name;     /* NULL: by its kind and number, "luminaire 1" */
  const char *file;     /* photometric, as people know it: luminaires of one file and flux are a type. NULL: not
                         * told, and those of one photometry and flux are */
} ups_report_source;

typedef int32_t ups_report_exposure;
enum {
  UPS_REPORT_EXPOSURE_UNTOLD = 0,
  UPS_REPORT_EXPOSURE_CHOSEN = 1, /* from the image itself */
  UPS_REPORT_EXPOSURE_GIVEN = 2
};

/* A picture of a camera's image, such as ups_ocio_write_picture_png makes: a PNG file, or its bytes. */
typedef struct ups_report_picture { /* a plain array element: it never grows */
  ups_sensor_id camera;         /* one of the page's sensors */
  ups_report_exposure exposure; /* whether the page tells ev100, and of what it says it is */
  double ev100;                 /* as ups_ocio_get_ev100 */
  int32_t smoothed;             /* 1: the page says that it is for looking at alone */
  uint32_t reserved;            /* 0 */
  const char *path;             /* of the file; NULL: the bytes */
  const uint8_t *png;           /* png_size bytes; NULL with 0: the file */
  size_t png_size;
} ups_report_picture;

typedef struct ups_report_ratio { /* a plain array element: it never grows */
  ups_sensor_id numerator, denominator; /* sets of meters among the page's sensors */
} ups_report_ratio;

/* The page tells of a committed scene and a result of it: plan and section, luminaires with polar diagrams, statistics
 * and maps of the meters, glare at the observers, the cameras' pictures, flux balance, effects, accuracy and warnings,
 * and, where there are targets, what is met. */
typedef struct ups_report_page_desc {
  uint32_t struct_size;
  uint32_t sensor_count, source_count, picture_count, threshold_count, ratio_count; /* of the arrays; NULL with 0 */
  const ups_scene *scene;             /* as it was committed for the result */
  const ups_result *result;
  const ups_report_sensor *sensors;   /* that the page tells of, in this order, each once; targets name them by name */
  const ups_report_source *sources;   /* words for sources of the scene; those left out have their kind and
                                       * number */
  const ups_report_picture *pictures; /* at most one a camera */
  const char *title;                  /* NULL: "Lighting" */
  const char *scene_name;             /* the scene's file, or how else it is found again; NULL: not told */
  const char *repeat;                 /* the command, or how else the same numbers are found again; NULL: not told */
  const char *date;                   /* as people read it; NULL: not told */
  const char *targets_json;           /* what is required, a JSON text (samples/targets/README.md); NULL: nothing */
  const char *targets_name;           /* of its file, for messages and the page; NULL: "targets" */
  const char *targets_folder;         /* where files that it includes lie, or below, such as share/ups/targets;
                                       * NULL: it includes none */
  const ups_report_style_desc *style; /* of the maps; NULL: the defaults. Zoom is for PNG alone */
  const double *thresholds_lx;        /* the share of each set's meters with at least so many lx is told; > 0 */
  const ups_report_ratio *ratios;     /* of mean illuminances to tell, and meter by meter of sets of as many meters */
  double target_relative_error;       /* that the render was to stop at, for its diagram; at most 1e6, 0: none */
} ups_report_page_desc;

UPS_API void ups_report_page_desc_init(ups_report_page_desc *desc, uint32_t struct_size);
/* One HTML file, for screens and for A4 paper, without any other file, script or use of the network. Errors: PARSE for
 * targets or a PNG that are none, INVALID_ARGUMENT where targets name what the sensors have not, INVALID_STATE as
 * for maps. */
UPS_API ups_status ups_report_write_page(const char *path, const ups_report_page_desc *desc);

/* This thread's last failure of this library, for people. Never NULL; valid until this thread's next failing call. */
UPS_API const char *ups_report_last_error(void);

#endif
