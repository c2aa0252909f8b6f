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
  double to_world[12];     /* looks along local -Z, local +Y is up in the image; scale is ignored */
  float vertical_fov_rad;  /* (0, pi); of a perspective alone */
  int32_t illuminance;     /* 1: also the illuminance on the first diffuse surface, UPS_CHANNEL_ILLUMINANCE */
  uint32_t layers;         /* UPS_LAYER_* to have as channels too */
  uint32_t reserved;       /* 0 */
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
} ups_meter_desc;

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
UPS_API ups_status ups_scene_add_camera(ups_scene *scene, const ups_camera_desc *desc, ups_sensor_id *out);
UPS_API ups_status ups_scene_add_meters(ups_scene *scene, const ups_meter_desc *desc, ups_sensor_id *out);
/* The defaults: planes every 15 degrees, gamma every 2.5 degrees, no symmetry. */
UPS_API void ups_goniometer_desc_init(ups_goniometer_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_scene_add_goniometer(ups_scene *scene, const ups_goniometer_desc *desc, ups_sensor_id *out);

#endif
