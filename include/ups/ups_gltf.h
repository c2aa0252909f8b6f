/* UPS extra: a glTF 2.0 file (.gltf, .glb) becomes the content of a scene. Library ups_gltf; needs the core library.
 *
 * glTF's +Y up is turned to the library's +Z up: (x, y, z) becomes (x, -z, y). What glTF has no words for (materials by
 * measured values, luminaires, meters) stands in `extras.ups` of a node or a material.
 * The rules of ups_base.h hold; messages are this library's own: ups_gltf_last_error().
 */
#ifndef UPS_GLTF_H
#define UPS_GLTF_H

#include "ups_glare.h"
#include "ups_render.h"
#include "ups_sensor.h"

typedef struct ups_gltf_import ups_gltf_import; /* what the file named: sensors and warnings; immutable, thread-safe */

typedef struct ups_gltf_import_desc {
  uint32_t struct_size;
  uint32_t camera_width, camera_height; /* pixels of every camera; both 0: as the file says */
  uint32_t reserved;                    /* 0 */
  int32_t allow_outside;                /* 1: files that the scene names may lie anywhere; 0 (default): only in the
                                         * scene's folder and below it, symbolic links followed */
  uint32_t camera_layers;               /* UPS_LAYER_* of every camera, beside those that the file asks for */
} ups_gltf_import_desc;

typedef int32_t ups_gltf_sensor_kind;
enum { UPS_GLTF_CAMERA = 0, UPS_GLTF_METERS = 1, UPS_GLTF_GONIOMETER = 2, UPS_GLTF_OBSERVER = 3 };

/* How a set of meters lies. */
typedef int32_t ups_gltf_layout;
enum {
  UPS_GLTF_LAYOUT_POINTS = 0,  /* anywhere */
  UPS_GLTF_LAYOUT_GRID = 1,    /* all cells of a rectangle: columns run fastest, then rows */
  UPS_GLTF_LAYOUT_EN12464 = 2, /* those cells of a grid that lie in a polygon, in the same order; columns and rows are 0
                                * where some are left out */
  UPS_GLTF_LAYOUT_LINE = 3,    /* from one end to the other */
  UPS_GLTF_LAYOUT_SURFACE = 4, /* a meter a triangle */
  UPS_GLTF_LAYOUT_LIGHTMAP = 5 /* a meter a texel, row 0 at v = 0 */
};

typedef struct ups_gltf_sensor_info {
  uint32_t struct_size;
  ups_gltf_sensor_kind kind;
  ups_sensor_id sensor;   /* in the scene that the file was imported into */
  uint32_t width, height; /* camera: pixels; lightmap: texels */
  int32_t illuminance;    /* camera: 1 where it has UPS_CHANNEL_ILLUMINANCE */
  uint32_t meter_count;   /* meters */
  uint32_t columns, rows; /* meters on a grid: columns run fastest, then rows; 0: free points.
                           * goniometer: planes, angles gamma */
  uint32_t reserved;
  ups_gltf_layout layout; /* meters */
  float cell_size_m[2];   /* grids: of the cell that each meter stands for; else 0 */
  float cell_side[3];     /* grids: unit direction in the scene of a cell's first side, along a row; the second's is
                           * normal x cell_side */
  ups_meter_kind meter_kind; /* meters */
  ups_projection projection; /* camera */
  uint32_t layers;           /* camera: UPS_LAYER_* that the file asks for */
} ups_gltf_sensor_info;

UPS_API void ups_gltf_import_desc_init(ups_gltf_import_desc *desc, uint32_t struct_size);

/* Adds everything in the file to the scene; the caller commits it. desc may be NULL: all defaults.
 * The caller owns *out.
 * Errors: IO (a file cannot be read, or lies outside the scene's folder), PARSE (malformed), UNSUPPORTED (names what
 * is not built), and those of the core.
 * The message names the file and the node, mesh, material or accessor. After an error the scene holds part of the
 * file: destroy it. */
UPS_API ups_status ups_gltf_import_file(ups_context *context, const char *path, const ups_gltf_import_desc *desc,
                                        ups_scene *scene, ups_gltf_import **out);
UPS_API void ups_gltf_import_destroy(ups_gltf_import *import_result); /* NULL ok; the scene stays */

/* Sensors in the order of the node hierarchy. info->struct_size must be set; at most that many bytes are written. */
UPS_API ups_status ups_gltf_get_sensor_count(const ups_gltf_import *import_result, uint32_t *out);
UPS_API ups_status ups_gltf_get_sensor(const ups_gltf_import *import_result, uint32_t index,
                                       ups_gltf_sensor_info *info);
/* Unique in the file and fit for a file name: [A-Za-z0-9._-], at most 200 bytes; an observer's as the file has it. Two
 * calls: text NULL and capacity 0 give *needed (with the final zero), then the text. */
UPS_API ups_status ups_gltf_get_sensor_name(const ups_gltf_import *import_result, uint32_t index, char *text,
                                            size_t capacity, size_t *needed);
/* Name of a source as ups_result_get_source tells it (kind, id): that of its node, unique among the file's sources by
 * _2, _3, and of [A-Za-z0-9._-], at most 200 bytes; of a node without a name "luminaire_1", "instance_1", "fixture_1",
 * counted through the file. Two calls, as ups_gltf_get_sensor_name. Errors: INVALID_ARGUMENT for a group, or what the
 * file did not add. */
UPS_API ups_status ups_gltf_get_source_name(const ups_gltf_import *import_result, ups_source_kind kind, uint32_t id,
                                            char *text, size_t capacity, size_t *needed);
/* The photometric file of a luminaire, as the scene file names it; empty: it has none, or it lies within the scene
 * file. Two calls and errors, as ups_gltf_get_source_name. */
UPS_API ups_status ups_gltf_get_source_file(const ups_gltf_import *import_result, ups_source_kind kind, uint32_t id,
                                            char *text, size_t capacity, size_t *needed);
/* Parts of a scene that messages of the core name by number, such as "material 3". */
typedef int32_t ups_gltf_part;
enum {
  UPS_GLTF_PART_MATERIAL = 0,
  UPS_GLTF_PART_MESH = 1,
  UPS_GLTF_PART_INSTANCE = 2,  /* its node, and which primitive of several */
  UPS_GLTF_PART_LUMINAIRE = 3, /* lights too */
  UPS_GLTF_PART_FIXTURE = 4
};
/* Where in the file a part of the scene stands, as this library's messages tell it: 'material 2 "Tiles"', 'node 7 "Tap"';
 * counted from 0, with the name that it has there. id: the `v` of its id, or the number in a message. Two calls, as
 * ups_gltf_get_sensor_name. Errors: INVALID_ARGUMENT for what the file did not add, such as meshes of fixtures. */
UPS_API ups_status ups_gltf_get_place(const ups_gltf_import *import_result, ups_gltf_part part, uint32_t id, char *text,
                                      size_t capacity, size_t *needed);
/* Where the meters are, in the scene's frame: +Z up, metres, 3 values a meter, normals of length 1. Either may be NULL;
 * count must be the sensor's meter_count. Of an observer, with count 1, its eye and the direction that it looks
 * along. Errors: INVALID_ARGUMENT for a surface or lightmap, whose meters are where ups_scene_read_meter_places finds
 * them once the scene is committed. */
UPS_API ups_status ups_gltf_read_meters(const ups_gltf_import *import_result, uint32_t index, double *positions_m,
                                        float *normals, size_t count);
/* For people, a line each: what was left out or looks wrong, each with its place. Two calls, as
 * ups_gltf_get_sensor_name. */
UPS_API ups_status ups_gltf_get_warnings(const ups_gltf_import *import_result, char *text, size_t capacity,
                                         size_t *needed);

/* This thread's last failure of this library, for people. Never NULL; valid until this thread's next failing call. */
UPS_API const char *ups_gltf_last_error(void);

#endif
