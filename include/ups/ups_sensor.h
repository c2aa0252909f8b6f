/* UPS: cameras, illuminance meters and the virtual goniophotometer. */
#ifndef UPS_SENSOR_H
#define UPS_SENSOR_H

#include "ups_base.h"
#include "ups_photometry.h"

typedef int32_t ups_projection;
enum { UPS_PERSPECTIVE = 0 };

typedef struct ups_camera_desc {
  uint32_t struct_size;
  ups_projection projection;
  uint32_t width, height;  /* pixels, 1..16384 each */
  double to_world[12];     /* looks along local -Z, local +Y is up in the image; scale is ignored */
  float vertical_fov_rad;  /* (0, pi) */
  int32_t illuminance;     /* 1: also the illuminance on the first diffuse surface, UPS_CHANNEL_ILLUMINANCE */
} ups_camera_desc;

typedef int32_t ups_meter_kind;
enum {
  UPS_METER_PLANAR = 0,
  UPS_METER_CYLINDRICAL = 1,     /* this and below: UPS_ERROR_UNSUPPORTED in this version */
  UPS_METER_SEMICYLINDRICAL = 2,
  UPS_METER_HEMISPHERICAL = 3,
  UPS_METER_SPHERICAL = 4
};

/* Illuminance meters: points, or means over rectangles. A planar meter sees the hemisphere of its normal. */
typedef struct ups_meter_desc {
  uint32_t struct_size;
  ups_meter_kind kind;
  const double *positions_m;  /* 3 * count */
  const float *normals;       /* 3 * count, any length > 0 */
  const float *tangents;      /* 3 * count: the rectangle's first side; NULL for points */
  float cell_size_m[2];       /* rectangle's sides; 0, 0: points */
  uint32_t count;             /* 1..16,777,216 */
  uint32_t reserved;          /* 0 */
  float footprint_m;          /* > 0: the mean over a disc of this diameter about each point, as a meter's head measures;
                               * 0: points. Not beside cell_size_m. */
  uint32_t reserved_2;        /* 0 */
} ups_meter_desc;

/* Planar meters on the surfaces of instances: one a triangle, its reading the mean over the triangle. They look away from
 * the front (counter-clockwise), or from the back. Meter i is triangle i, counted through the instances in their order.
 * They follow their instances at each commit. A triangle without area has no valid meter: its reading is 0 throughout
 * and takes no part in the set's statistics (ups_scene_read_meter_places tells). */
typedef struct ups_surface_meters_desc {
  uint32_t struct_size;
  uint32_t instance_count;          /* >= 1; 16,777,216 triangles in all at most */
  const ups_instance_id *instances; /* each once; of meshes, not of a fixture's curved parts */
  int32_t back;                     /* 1: the surfaces' backs */
  uint32_t reserved;                /* 0 */
} ups_surface_meters_desc;

/* A map of illuminance on the surfaces of instances: planar meters, one a texel of their UVs; row 0 is at v = 0, columns
 * run fastest. A texel's reading is the mean over what lies in it, which may be parts of several triangles: the sum of
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
/* Of the meters of a committed scene. count: of all its meters, whether valid or not: texels, triangles. */
UPS_API ups_status ups_scene_read_meter_places(const ups_scene *scene, ups_sensor_id meters, ups_meter_place *out,
                                               size_t count);
/* The defaults: planes every 15 degrees, gamma every 2.5 degrees, no symmetry. */
UPS_API void ups_goniometer_desc_init(ups_goniometer_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_scene_add_goniometer(ups_scene *scene, const ups_goniometer_desc *desc, ups_sensor_id *out);

#endif
