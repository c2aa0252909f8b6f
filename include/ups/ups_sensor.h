/* UPS: cameras and illuminance meters. */
#ifndef UPS_SENSOR_H
#define UPS_SENSOR_H

#include "ups_base.h"

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
} ups_meter_desc;

UPS_API void ups_camera_desc_init(ups_camera_desc *desc, uint32_t struct_size);
UPS_API void ups_meter_desc_init(ups_meter_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_scene_add_camera(ups_scene *scene, const ups_camera_desc *desc, ups_sensor_id *out);
UPS_API ups_status ups_scene_add_meters(ups_scene *scene, const ups_meter_desc *desc, ups_sensor_id *out);

#endif
