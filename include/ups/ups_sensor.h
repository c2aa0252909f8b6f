/* UPS: cameras, illuminance meters and the virtual goniophotometer. */
#ifndef UPS_SENSOR_H
#define UPS_SENSOR_H

#include "ups_base.h"
#include "ups_photometry.h"

typedef int32_t ups_projection;
enum {
  UPS_PERSPECTIVE = 0,
  /* Fisheyes: the image circle fills the height and holds the half space in front. Pixels outside of it are black, take
   * no samples and have standard error 0; one on its rim counts what lies outside of it as black. Angle from the axis
   * by distance r from the circle's middle, its radius being 1: */
  UPS_EQUIDISTANT = 1, /* r 90 degrees */
  UPS_EQUISOLID = 2,   /* 2 asin(r / sqrt 2): equal areas are equal solid angles */
  /* All directions, longitude by latitude (equirectangular): the middle column is the axis, the column of the right
   * quarter lies to its right, row 0 is at +Y. A pixel is the mean over its solid angle. */
  UPS_PANORAMA = 3
};

/* Layers of the surface that a pixel sees first, whatever it is: a pane, glass and a mirror too, nothing is seen
 * through or in it. Openings of luminaires are no surfaces. */
enum {
  UPS_LAYER_ALBEDO = 1,
  UPS_LAYER_NORMAL = 2,
  UPS_LAYER_DEPTH = 4,
  UPS_LAYER_ID = 8
};

typedef struct ups_camera_desc {
  uint32_t struct_size;
  ups_projection projection;
  uint32_t width, height;  /* pixels, 1..16384 each */
  double to_world[12];     /* looks along local -Z, local +Y is up in the image; scale and mirroring are
                            * ignored */
  float vertical_fov_rad;  /* [1e-6, pi); of a perspective alone */
  int32_t illuminance;     /* 1: also the illuminance on the first surface that is no mirror, clear glass or
                            * pane, UPS_CHANNEL_ILLUMINANCE */
  uint32_t layers;         /* UPS_LAYER_* to have as channels too */
  uint32_t reserved;       /* 0 */
} ups_camera_desc;

typedef int32_t ups_meter_kind;
enum {
  UPS_METER_PLANAR = 0,
  UPS_METER_CYLINDRICAL = 1,
  UPS_METER_SEMICYLINDRICAL = 2,
  UPS_METER_HEMISPHERICAL = 3,
  UPS_METER_SPHERICAL = 4,
  UPS_METER_VECTOR = 5
};

/* Illuminance meters: points, or means over rectangles. Their kinds differ in how they weigh the light that arrives
 * from a direction w, E = integral L(w) W(w) dw, without any approximation by a few directions:
 *   planar            cos(theta) from the normal, of its hemisphere
 *   cylindrical       sin(theta) / pi from the vertical, the world's +Z: the mean over all vertical planes
 *   semicylindrical   sin(theta) (1 + cos(alpha)) / pi, alpha the azimuth from the horizontal part of the normal; a
 *                     vertical normal is an error
 *   hemispherical     (1 + cos(theta)) / 4 of the hemisphere of the normal: the mean over a small dome. EN 13201-3 has
 *                     I (1 + cos(eps)) / (4 d2) for sources above the ground that the dome stands on; light from below
 *                     its base is not seen
 *   spherical         1 / 4: the mean over a small ball
 *   vector            w itself: ups_result_read_vectors has the three components in the world's axes; as a reading its
 *                     illuminance_lx is the vector's length, see there
 * A meter on a surface stands on the side that its normal faces. One in the air that is not planar has no sides, and
 * sees all around but for what its kind leaves out; where photons alone find its light and it lies on a surface, which
 * cuts the discs on which they are counted, it is read up to 2 % off: its bound says so. A vector meter takes the time
 * and memory of six planar ones. */
typedef struct ups_meter_desc {
  uint32_t struct_size;
  ups_meter_kind kind;
  const double *positions_m;  /* 3 * count */
  const float *normals;       /* 3 * count, any length > 0 */
  const float *tangents;      /* 3 * count: the rectangle's first side; NULL for points */
  float cell_size_m[2];       /* rectangle's sides, 1e-9 or more; 0, 0: points */
  uint32_t count;             /* 1..16,777,216 */
  uint32_t reserved;          /* 0 */
  float footprint_m;          /* > 0: the mean over a disc of this diameter about each point, as a meter's head
                               * measures; 0: points. Not beside cell_size_m. */
  uint32_t reserved_2;        /* 0 */
} ups_meter_desc;

/* Planar meters on the surfaces of instances: one a triangle, its reading the mean over the triangle. They look away
 * from the front (counter-clockwise), or from the back. Meter i is triangle i, counted through the instances in their
 * order. They follow their instances at each commit. A triangle without area has no valid meter: its reading is 0
 * throughout and takes no part in the set's statistics (ups_scene_read_meter_places tells). */
typedef struct ups_surface_meters_desc {
  uint32_t struct_size;
  uint32_t instance_count;          /* >= 1; 16,777,216 triangles in all at most */
  const ups_instance_id *instances; /* each once; of meshes, not of a fixture's curved parts */
  int32_t back;                     /* 1: the surfaces' backs */
  uint32_t reserved;                /* 0 */
} ups_surface_meters_desc;

/* A map of illuminance on the surfaces of instances: planar meters, one a texel of their UVs; row 0 is at v = 0,
 * columns run fastest. A texel's reading is the mean over what lies in it, which may be parts of several triangles: the sum of
 * area times reading is the flux on the surfaces. Texels in which nothing lies are not valid: their reading is 0
 * throughout. Triangles outside the unit square, without area in UV, or that overlap there get a warning at commit. */
typedef struct ups_lightmap_desc {
  uint32_t struct_size;
  uint32_t instance_count;          /* >= 1 */
  const ups_instance_id *instances; /* as above; their meshes have UVs */
  uint32_t width, height;           /* texels, 1..16384 each, 16,777,216 together */
  int32_t back;                     /* 1: the surfaces' backs */
  uint32_t reserved;                /* 0 */
} ups_lightmap_desc;

/* The grid of points that EN 12464-1 wants illuminance at: the cell centres of a grid over the polygon's extent less
 * the border, those that lie within the polygon, outside its holes, and at least the border away from all outlines. No
 * two neighbours are further apart than p = 0.2 * 5^log10(d) m (at most 10 m), d being the longer side of the extent
 * less the border, or the shorter where the longer is at least twice as long; no cell is more than twice as long as
 * wide. */
typedef struct ups_en12464_desc {
  uint32_t struct_size;
  uint32_t corner_count;              /* >= 3; 4096 with those of the holes at most */
  const double *corners_m;            /* 2 * corner_count: x, y of the polygon's corners, either way round */
  const double *hole_corners_m;       /* 2 each, one hole after the other */
  const uint32_t *hole_corner_counts; /* hole_count */
  uint32_t hole_count;
  uint32_t reserved;                  /* 0 */
  double border_m;                    /* 0.5 as the standard has it; 0 where the task lies at the walls */
} ups_en12464_desc;

typedef struct ups_en12464_info {
  uint32_t struct_size;
  uint32_t columns, rows;
  uint32_t point_count;      /* columns * rows: no cell is left out */
  double origin_m[2];        /* corner of cell 0, 0, the one with the smallest x and y */
  double cell_m[2];          /* a cell's sides */
  double largest_spacing_m;  /* p */
} ups_en12464_info;

typedef struct ups_en12464_point { /* a plain array element: it never grows */
  double x_m, y_m;
  uint32_t column, row;
} ups_en12464_point;

/* What a meter of the committed scene measures. */
typedef struct ups_meter_place { /* a plain array element: it never grows */
  double position_m[3]; /* the point, or the centre of the area */
  float normal[3];      /* unit; of several triangles the mean */
  float area_m2;        /* over which the mean is taken; 0: a point */
  int32_t valid;        /* 0: there is no area to measure on; all but `triangle` is 0 */
  uint32_t triangle;    /* of surfaces, counted through the instances; of a texel the one that has most of it;
                         * UINT32_MAX: none */
} ups_meter_place;

/* A virtual goniophotometer: light that leaves the scene for good, by direction, as luminous intensity in C-planes. It
 * has no place: light is measured at infinity. Only methods that trace light paths fill it. Put a fixture alone into a
 * scene to measure it. Each node of the grid gets the mean intensity around it that a bilinear table needs to carry all
 * the flux. */
typedef struct ups_goniometer_desc {
  uint32_t struct_size;
  ups_profile_symmetry symmetry;   /* of the fixture: directions that it makes alike share their light; the planes
                                    * must be as symmetric, AXIAL: one plane */
  const float *c_deg;              /* c_count, ascending in [0, 360), from 0; NULL: equal steps */
  const float *gamma_deg;          /* gamma_count, ascending in [0, 180]; NULL: equal steps from 0 to 180 */
  uint32_t c_count, gamma_count;   /* >= 1, >= 2; at most 4,000,000 nodes together */
  double to_world[12];             /* nadir is local -Z, C0 local +X; its place and scale are ignored */
  ups_opening_shape opening_shape; /* that ups_result_get_goniometer_profile gives the distribution */
  float opening_m[3];              /* along local x, y, z */
} ups_goniometer_desc;

UPS_API void ups_camera_desc_init(ups_camera_desc *desc, uint32_t struct_size);
UPS_API void ups_meter_desc_init(ups_meter_desc *desc, uint32_t struct_size);
UPS_API void ups_surface_meters_desc_init(ups_surface_meters_desc *desc, uint32_t struct_size);
UPS_API void ups_lightmap_desc_init(ups_lightmap_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_scene_add_camera(ups_scene *scene, const ups_camera_desc *desc, ups_sensor_id *out);
UPS_API ups_status ups_scene_add_meters(ups_scene *scene, const ups_meter_desc *desc, ups_sensor_id *out);
UPS_API ups_status ups_scene_add_surface_meters(ups_scene *scene, const ups_surface_meters_desc *desc,
                                                ups_sensor_id *out);
UPS_API ups_status ups_scene_add_lightmap(ups_scene *scene, const ups_lightmap_desc *desc, ups_sensor_id *out);
/* Edits of sensors, by the rules of ups_scene.h; an id stays of the kind that it was added as. What is got of surface
 * meters and lightmaps still names instances that were removed meanwhile. */
UPS_API ups_status ups_scene_set_camera(ups_scene *scene, ups_sensor_id id, const ups_camera_desc *desc);
UPS_API ups_status ups_scene_set_meters(ups_scene *scene, ups_sensor_id id, const ups_meter_desc *desc);
UPS_API ups_status ups_scene_set_surface_meters(ups_scene *scene, ups_sensor_id id,
                                                const ups_surface_meters_desc *desc);
UPS_API ups_status ups_scene_set_lightmap(ups_scene *scene, ups_sensor_id id, const ups_lightmap_desc *desc);
UPS_API ups_status ups_scene_set_goniometer(ups_scene *scene, ups_sensor_id id, const ups_goniometer_desc *desc);
UPS_API ups_status ups_scene_get_camera(const ups_scene *scene, ups_sensor_id id, ups_camera_desc *desc);
UPS_API ups_status ups_scene_get_meters(const ups_scene *scene, ups_sensor_id id, ups_meter_desc *desc);
UPS_API ups_status ups_scene_get_surface_meters(const ups_scene *scene, ups_sensor_id id,
                                                ups_surface_meters_desc *desc);
UPS_API ups_status ups_scene_get_lightmap(const ups_scene *scene, ups_sensor_id id, ups_lightmap_desc *desc);
UPS_API ups_status ups_scene_get_goniometer(const ups_scene *scene, ups_sensor_id id, ups_goniometer_desc *desc);
/* Of the meters of a committed scene, as many as its readings: triangles, texels, whether valid or not. *needed gets
 * their number; BUFFER_TOO_SMALL where capacity is less. places may be NULL with capacity 0. */
UPS_API ups_status ups_scene_read_meter_places(const ups_scene *scene, ups_sensor_id meters, ups_meter_place *places,
                                               size_t capacity, size_t *needed);
UPS_API void ups_en12464_desc_init(ups_en12464_desc *desc, uint32_t struct_size);
/* Needs no scene. Points: column fastest. info may be NULL, else info->struct_size must be set; points may be NULL with
 * capacity 0: *needed gets their number. Errors: INVALID_ARGUMENT for an outline that crosses itself, a hole outside, a
 * border that leaves nothing; BUFFER_TOO_SMALL. */
UPS_API ups_status ups_en12464_grid(const ups_en12464_desc *desc, ups_en12464_info *info, ups_en12464_point *points,
                                    size_t capacity, size_t *needed);
/* The defaults: planes every 15 degrees, gamma every 2.5 degrees, no symmetry. */
UPS_API void ups_goniometer_desc_init(ups_goniometer_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_scene_add_goniometer(ups_scene *scene, const ups_goniometer_desc *desc, ups_sensor_id *out);

#endif
