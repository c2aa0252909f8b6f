/* As in ups.h beside it: frozen. */
#ifndef UPS_GLTF_H
#define UPS_GLTF_H
#include "ups.h"
typedef struct ups_gltf_import ups_gltf_import;
typedef struct ups_gltf_import_desc {
  uint32_t struct_size;
  uint32_t camera_width, camera_height;
  uint32_t reserved;
} ups_gltf_import_desc;
typedef int32_t ups_gltf_sensor_kind;
enum { UPS_GLTF_CAMERA = 0, UPS_GLTF_METERS = 1 };
typedef struct ups_gltf_sensor_info {
  uint32_t struct_size;
  ups_gltf_sensor_kind kind;
  ups_sensor_id sensor;
  uint32_t width, height;
  int32_t illuminance;
  uint32_t meter_count;
  uint32_t columns, rows;
  uint32_t reserved;
} ups_gltf_sensor_info;
UPS_API void ups_gltf_import_desc_init(ups_gltf_import_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_gltf_import_file(ups_context *context, const char *path, const ups_gltf_import_desc *desc,
                                        ups_scene *scene, ups_gltf_import **out);
UPS_API void ups_gltf_import_destroy(ups_gltf_import *import_result);
UPS_API ups_status ups_gltf_get_sensor_count(const ups_gltf_import *import_result, uint32_t *out);
UPS_API ups_status ups_gltf_get_sensor(const ups_gltf_import *import_result, uint32_t index, ups_gltf_sensor_info *info);
UPS_API ups_status ups_gltf_get_sensor_name(const ups_gltf_import *import_result, uint32_t index, char *text,
                                            size_t capacity, size_t *needed);
UPS_API ups_status ups_gltf_read_meters(const ups_gltf_import *import_result, uint32_t index, double *positions_m,
                                        float *normals, size_t count);
UPS_API ups_status ups_gltf_get_warnings(const ups_gltf_import *import_result, char *text, size_t capacity,
                                         size_t *needed);
UPS_API const char *ups_gltf_last_error(void);
#endif
