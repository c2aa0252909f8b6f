/* What a program of UPS 0.1 was compiled with: the declarations of its first day, frozen. Never changed: while the SONAME
 * is libups.so.0.1 such a program runs (abi.released, abi.clients). */
#ifndef UPS_RELEASED_H
#define UPS_RELEASED_H
#include <stddef.h>
#include <stdint.h>
#define UPS_API
#define UPS_VERSION_MAJOR 0
#define UPS_VERSION_MINOR 1
#define UPS_VERSION_PATCH 0
typedef int32_t ups_status;
enum {
  UPS_OK = 0,
  UPS_ERROR_INTERNAL = -1,
  UPS_ERROR_INVALID_ARGUMENT = -2,
  UPS_ERROR_INVALID_STATE = -3,
  UPS_ERROR_OUT_OF_MEMORY = -4,
  UPS_ERROR_PARSE = -5,
  UPS_ERROR_UNSUPPORTED = -6,
  UPS_ERROR_BUFFER_TOO_SMALL = -7,
  UPS_ERROR_IO = -8,
  UPS_TIMEOUT = 1,
  UPS_CANCELLED = 2
};
typedef struct ups_context ups_context;
typedef struct ups_profile ups_profile;
typedef struct ups_scene ups_scene;
typedef struct ups_job ups_job;
typedef struct ups_result ups_result;
typedef struct { uint32_t v; } ups_texture_id;
typedef struct { uint32_t v; } ups_material_id;
typedef struct { uint32_t v; } ups_mesh_id;
typedef struct { uint32_t v; } ups_instance_id;
typedef struct { uint32_t v; } ups_luminaire_id;
typedef struct { uint32_t v; } ups_sensor_id;
UPS_API uint32_t ups_version(void);
UPS_API const char *ups_status_name(ups_status status);
UPS_API const char *ups_last_error(void);
typedef struct ups_context_desc {
  uint32_t struct_size;
  int32_t thread_count;
} ups_context_desc;
typedef int32_t ups_log_level;
enum { UPS_LOG_INFO = 0, UPS_LOG_WARNING = 1 };
UPS_API void ups_context_desc_init(ups_context_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_context_create(const ups_context_desc *desc, ups_context **out);
UPS_API void ups_context_destroy(ups_context *context);
UPS_API ups_status ups_context_get_thread_count(const ups_context *context, int32_t *out);
UPS_API ups_status ups_context_pop_log(ups_context *context, char *text, size_t capacity, size_t *needed,
                                       ups_log_level *level);
typedef int32_t ups_profile_format;
enum {
  UPS_PROFILE_AUTO = 0,
  UPS_PROFILE_IES_LM63 = 1,
  UPS_PROFILE_EULUMDAT = 2,
  UPS_PROFILE_TM33_XML = 3,
  UPS_PROFILE_TM25_RAYS = 4,
  UPS_PROFILE_ZEMAX_RAYS = 5,
  UPS_PROFILE_LIGHTTOOLS_RAYS = 6
};
typedef int32_t ups_opening_shape;
enum {
  UPS_OPENING_POINT = 0,
  UPS_OPENING_RECTANGLE = 1,
  UPS_OPENING_DISC = 2,
  UPS_OPENING_BOX = 3,
  UPS_OPENING_CYLINDER = 4,
  UPS_OPENING_SPHERE = 5
};
typedef int32_t ups_profile_symmetry;
enum {
  UPS_SYMMETRY_NONE = 0,
  UPS_SYMMETRY_AXIAL = 1,
  UPS_SYMMETRY_C0_C180 = 2,
  UPS_SYMMETRY_C90_C270 = 3,
  UPS_SYMMETRY_QUADRANTS = 4
};
typedef int32_t ups_photometric_type;
enum { UPS_PHOTOMETRIC_C = 0, UPS_PHOTOMETRIC_B = 1, UPS_PHOTOMETRIC_A = 2 };
typedef struct ups_profile_desc {
  uint32_t struct_size;
  uint32_t c_count, gamma_count;
  uint32_t reserved;
  const float *c_deg;
  const float *gamma_deg;
  const float *intensity_cd;
  ups_opening_shape opening_shape;
  float opening_m[3];
  int32_t opening_axis;
  float input_power_w;
} ups_profile_desc;
typedef struct ups_profile_parse_desc {
  uint32_t struct_size;
  ups_profile_format format;
  const void *bytes;
  size_t size;
  const void *tilt_file;
  size_t tilt_file_size;
  float tilt_deg;
  uint32_t lamp_set;
} ups_profile_parse_desc;
typedef struct ups_profile_info {
  uint32_t struct_size;
  uint32_t warning_count;
  double flux_lm;
  double interpolated_flux_lm;
  double rated_flux_lm;
  double input_power_w;
  float peak_cd;
  float peak_c_deg, peak_gamma_deg;
  float opening_m[3];
  ups_opening_shape opening_shape;
  ups_profile_symmetry symmetry;
  uint32_t c_count, gamma_count;
  ups_photometric_type photometric_type;
  uint32_t ray_count;
  double up_flux_lm, down_flux_lm;
  double light_output_ratio;
  float beam_angle_deg[2];
  float field_angle_deg[2];
  int32_t opening_axis;
  uint32_t lamp_set_count;
} ups_profile_info;
typedef struct ups_profile_beam {
  uint32_t struct_size;
  float peak_cd, peak_deg;
  float from_deg, to_deg;
  float angle_deg;
} ups_profile_beam;
typedef struct ups_profile_lamp_set {
  uint32_t struct_size;
  int32_t count;
  double flux_lm;
  float input_power_w;
  float colour_temperature_k;
  float colour_rendering_index;
  int32_t chosen;
} ups_profile_lamp_set;
typedef int32_t ups_profile_text;
enum {
  UPS_PROFILE_TEXT_WARNINGS = 0,
  UPS_PROFILE_TEXT_KEYWORDS = 1,
  UPS_PROFILE_TEXT_FORMAT = 2,
  UPS_PROFILE_TEXT_TILT_FILE = 3,
  UPS_PROFILE_TEXT_TILT_TABLE = 4,
  UPS_PROFILE_TEXT_LAMP_TYPES = 5,
  UPS_PROFILE_TEXT_LAMP_COLOURS = 6,
  UPS_PROFILE_TEXT_LAMP_RENDERINGS = 7
};
UPS_API void ups_profile_desc_init(ups_profile_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_profile_create(ups_context *context, const ups_profile_desc *desc, ups_profile **out);
UPS_API ups_status ups_profile_parse(ups_context *context, const void *bytes, size_t size, ups_profile_format format,
                                     ups_profile **out);
UPS_API void ups_profile_parse_desc_init(ups_profile_parse_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_profile_parse_with(ups_context *context, const ups_profile_parse_desc *desc, ups_profile **out);
UPS_API ups_status ups_profile_write(const ups_profile *profile, ups_profile_format format, char *bytes,
                                     size_t capacity, size_t *needed);
UPS_API ups_status ups_profile_get_write_warnings(const ups_profile *profile, ups_profile_format format, char *text,
                                                  size_t capacity, size_t *needed);
UPS_API ups_status ups_profile_get_info(const ups_profile *profile, ups_profile_info *info);
UPS_API ups_status ups_profile_get_lamp_set(const ups_profile *profile, uint32_t index, ups_profile_lamp_set *set);
UPS_API ups_status ups_profile_get_text(const ups_profile *profile, ups_profile_text topic, char *text, size_t capacity,
                                        size_t *needed);
UPS_API ups_status ups_profile_get_keyword(const ups_profile *profile, const char *name, char *text, size_t capacity,
                                           size_t *needed);
UPS_API ups_status ups_profile_with_keyword(const ups_profile *profile, const char *name, const char *value,
                                            ups_profile **out);
UPS_API ups_status ups_profile_eval(const ups_profile *profile, const float *directions_xyz, size_t count,
                                    float *intensity_cd);
UPS_API ups_status ups_profile_get_luminance(const ups_profile *profile, const float *directions_xyz, size_t count,
                                             float *luminance_cd_m2);
UPS_API ups_status ups_profile_get_zonal_flux(const ups_profile *profile, const float *gamma_deg, size_t count,
                                              double *flux_lm);
UPS_API ups_status ups_profile_get_beam(const ups_profile *profile, float c_deg, float fraction,
                                        ups_profile_beam *beam);
UPS_API void ups_profile_destroy(ups_profile *profile);
typedef int32_t ups_material_model;
enum {
  UPS_MATERIAL_MATTE = 0,
  UPS_MATERIAL_PLASTIC = 1,
  UPS_MATERIAL_METAL = 2,
  UPS_MATERIAL_MIRROR = 3,
  UPS_MATERIAL_GLASS = 4,
  UPS_MATERIAL_GLAZING = 5,
  UPS_MATERIAL_DIFFUSER = 6
};
typedef struct ups_texture_desc {
  uint32_t struct_size;
  uint32_t width, height, channel_count;
  const float *texels;
  size_t row_stride_bytes;
} ups_texture_desc;
typedef int32_t ups_alpha_mode;
enum { UPS_ALPHA_OPAQUE = 0, UPS_ALPHA_MASK = 1, UPS_ALPHA_BLEND = 2 };
typedef struct ups_material_desc {
  uint32_t struct_size;
  ups_material_model model;
  float reflectance_rgb[3], transmittance_rgb[3];
  float roughness;
  float ior;
  float ior_rgb[3], ior_k_rgb[3];
  float absorption_per_m_rgb[3];
  float metallic;
  ups_alpha_mode alpha_mode;
  float alpha, alpha_cutoff;
  float luminance_cd_m2[3];
  int32_t emits_both_sides;
  float normal_scale;
  ups_texture_id reflectance_texture, roughness_texture, metallic_texture, normal_texture, alpha_texture;
  int32_t priority;
  const float *pane_angle_deg;
  const float *pane_transmittance;
  const float *pane_reflectance;
  uint32_t pane_angle_count;
  uint32_t reserved;
} ups_material_desc;
typedef struct ups_mesh_desc {
  uint32_t struct_size;
  uint32_t vertex_count, triangle_count;
  ups_material_id material;
  const float *positions_m;
  size_t position_stride_bytes;
  const float *normals;
  size_t normal_stride_bytes;
  const float *uvs;
  size_t uv_stride_bytes;
  const float *tangents;
  size_t tangent_stride_bytes;
  const uint32_t *indices;
} ups_mesh_desc;
typedef struct ups_instance_desc {
  uint32_t struct_size;
  ups_mesh_id mesh;
  double to_world[12];
  uint32_t group;
  uint32_t reserved;
} ups_instance_desc;
typedef int32_t ups_light_kind;
enum { UPS_LIGHT_POINT = 0, UPS_LIGHT_SPOT = 1, UPS_LIGHT_DIRECTIONAL = 2 };
typedef struct ups_light_desc {
  uint32_t struct_size;
  ups_light_kind kind;
  double to_world[12];
  float intensity_rgb[3];
  float inner_cone_rad, outer_cone_rad;
  uint32_t group;
} ups_light_desc;
typedef struct ups_luminaire_desc {
  uint32_t struct_size;
  int32_t use_opening;
  const ups_profile *profile;
  double to_world[12];
  float color_rgb[3];
  float flux_lm;
  float dimming;
  float intensity_scale;
  uint32_t group;
  uint32_t reserved;
} ups_luminaire_desc;
UPS_API void ups_texture_desc_init(ups_texture_desc *desc, uint32_t struct_size);
UPS_API void ups_material_desc_init(ups_material_desc *desc, uint32_t struct_size);
UPS_API void ups_mesh_desc_init(ups_mesh_desc *desc, uint32_t struct_size);
UPS_API void ups_instance_desc_init(ups_instance_desc *desc, uint32_t struct_size);
UPS_API void ups_light_desc_init(ups_light_desc *desc, uint32_t struct_size);
UPS_API void ups_luminaire_desc_init(ups_luminaire_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_scene_create(ups_context *context, ups_scene **out);
UPS_API void ups_scene_destroy(ups_scene *scene);
UPS_API ups_status ups_scene_add_texture(ups_scene *scene, const ups_texture_desc *desc, ups_texture_id *out);
UPS_API ups_status ups_scene_add_material(ups_scene *scene, const ups_material_desc *desc, ups_material_id *out);
UPS_API ups_status ups_scene_add_mesh(ups_scene *scene, const ups_mesh_desc *desc, ups_mesh_id *out);
UPS_API ups_status ups_scene_add_instance(ups_scene *scene, const ups_instance_desc *desc, ups_instance_id *out);
UPS_API ups_status ups_scene_add_light(ups_scene *scene, const ups_light_desc *desc, ups_luminaire_id *out);
UPS_API ups_status ups_scene_add_luminaire(ups_scene *scene, const ups_luminaire_desc *desc, ups_luminaire_id *out);
UPS_API ups_status ups_scene_set_material(ups_scene *scene, ups_material_id id, const ups_material_desc *desc);
UPS_API ups_status ups_scene_set_transform(ups_scene *scene, ups_instance_id id, const double to_world[12]);
UPS_API ups_status ups_scene_set_dimming(ups_scene *scene, ups_luminaire_id id, float dimming);
UPS_API ups_status ups_scene_set_maintenance_factor(ups_scene *scene, double factor);
UPS_API ups_status ups_scene_remove_instance(ups_scene *scene, ups_instance_id id);
UPS_API ups_status ups_scene_remove_luminaire(ups_scene *scene, ups_luminaire_id id);
UPS_API ups_status ups_scene_remove_sensor(ups_scene *scene, ups_sensor_id id);
UPS_API ups_status ups_scene_commit(ups_scene *scene);
enum {
  UPS_EFFECT_SPECULAR_REFLECTION = 1,
  UPS_EFFECT_TRANSMISSION = 2,
  UPS_EFFECT_CAUSTICS = 4,
  UPS_EFFECT_GLOSSY = 8,
  UPS_EFFECT_INTERREFLECTION = 16,
  UPS_EFFECT_COLOUR = 32,
  UPS_EFFECT_TEXTURES = 64
};
typedef struct ups_scene_info {
  uint32_t struct_size;
  uint32_t effects;
  uint32_t techniques;
  int32_t method;
  uint64_t triangle_count;
  uint64_t luminaire_count, light_count, emissive_instance_count;
  uint64_t meter_count, pixel_count;
  double emitted_flux_lm;
  double bounds_min_m[3], bounds_max_m[3];
  double maintenance_factor;
} ups_scene_info;
typedef int32_t ups_scene_text;
enum { UPS_SCENE_TEXT_WARNINGS = 0, UPS_SCENE_TEXT_EFFECTS = 1, UPS_SCENE_TEXT_TECHNIQUES = 2 };
UPS_API ups_status ups_scene_get_info(const ups_scene *scene, ups_scene_info *info);
UPS_API ups_status ups_scene_get_text(const ups_scene *scene, ups_scene_text topic, char *text, size_t capacity,
                                      size_t *needed);
typedef struct ups_segment {
  double from_m[3], to_m[3];
} ups_segment;
UPS_API ups_status ups_scene_read_section(const ups_scene *scene, const double point_m[3], const double normal[3],
                                          ups_segment *segments, size_t capacity, size_t *needed);
UPS_API ups_status ups_scene_read_outlines(const ups_scene *scene, const double point_m[3], const double normal[3],
                                           double depth_m, ups_segment *segments, size_t capacity, size_t *needed);
typedef struct ups_fixture ups_fixture;
typedef struct { uint32_t v; } ups_fixture_part_id;
typedef struct { uint32_t v; } ups_fixture_id;
typedef int32_t ups_finish;
enum {
  UPS_FINISH_SPECULAR_ALUMINIUM = 0,
  UPS_FINISH_ENHANCED_ALUMINIUM = 1,
  UPS_FINISH_SEMI_SPECULAR_ALUMINIUM = 2,
  UPS_FINISH_MATTE_WHITE = 3,
  UPS_FINISH_BLACK = 4,
  UPS_FINISH_OPAL = 5,
  UPS_FINISH_PMMA = 6,
  UPS_FINISH_POLYCARBONATE = 7,
  UPS_FINISH_GLASS = 8,
  UPS_FINISH_FROSTED_PMMA = 9,
  UPS_FINISH_CUSTOM = 10
};
typedef int32_t ups_emitter_shape;
enum {
  UPS_EMITTER_DISC = 0,
  UPS_EMITTER_RECTANGLE = 1,
  UPS_EMITTER_SPHERE = 2,
  UPS_EMITTER_CYLINDER = 3
};
typedef struct ups_fixture_emitter_desc {
  uint32_t struct_size;
  ups_emitter_shape shape;
  double to_fixture[12];
  double radius_m, width_m, length_m;
  double chord_tolerance_m;
  float flux_lm;
  float color_rgb[3];
  float reflectance;
  float reserved;
} ups_fixture_emitter_desc;
typedef int32_t ups_reflector_profile;
enum {
  UPS_REFLECTOR_PARABOLOID = 0,
  UPS_REFLECTOR_ELLIPSOID = 1,
  UPS_REFLECTOR_CONE = 2,
  UPS_REFLECTOR_CYLINDER = 3,
  UPS_REFLECTOR_POLYLINE = 4
};
typedef struct ups_reflector_desc {
  uint32_t struct_size;
  ups_reflector_profile profile;
  double to_fixture[12];
  double focal_length_m;
  double semi_axis_m, half_distance_m;
  double inner_radius_m;
  double aperture_radius_m, depth_m;
  const double *profile_rz_m;
  uint32_t profile_point_count;
  int32_t smooth;
  uint32_t facets_around, facets_along;
  double chord_tolerance_m, normal_tolerance_rad;
  ups_finish finish;
  float finish_reflectance, finish_transmittance, finish_roughness;
  const ups_material_desc *material;
} ups_reflector_desc;
typedef struct ups_lens_desc {
  uint32_t struct_size;
  ups_finish finish;
  double to_fixture[12];
  double radius_m, thickness_m;
  double entry_radius_m, entry_conic, entry_coefficients[4];
  double exit_radius_m, exit_conic, exit_coefficients[4];
  double chord_tolerance_m, normal_tolerance_rad;
  uint32_t facets_around;
  float finish_roughness, finish_absorption_per_m, finish_ior;
  const ups_material_desc *material;
} ups_lens_desc;
typedef int32_t ups_collimator_wall;
enum {
  UPS_COLLIMATOR_PARALLEL = 0,
  UPS_COLLIMATOR_PARABOLOID = 1,
  UPS_COLLIMATOR_POLYLINE = 2
};
typedef struct ups_collimator_desc {
  uint32_t struct_size;
  ups_finish finish;
  double to_fixture[12];
  double cavity_radius_m, cavity_depth_m;
  double lens_radius_m, lens_conic;
  ups_collimator_wall wall;
  int32_t smooth;
  double wall_thickness_m;
  double wall_focal_length_m;
  double height_m;
  const double *wall_rz_m;
  uint32_t wall_point_count;
  uint32_t facets_around;
  double exit_radius_m, exit_conic;
  double chord_tolerance_m, normal_tolerance_rad;
  uint32_t exit_facets_along;
  float finish_roughness, finish_absorption_per_m, finish_ior;
  const ups_material_desc *material;
} ups_collimator_desc;
typedef struct ups_fixture_part_desc {
  uint32_t struct_size;
  ups_finish finish;
  double to_fixture[12];
  const ups_mesh_desc *mesh;
  float finish_reflectance, finish_transmittance, finish_roughness, finish_absorption_per_m, finish_ior;
  float reserved;
  const ups_material_desc *material;
} ups_fixture_part_desc;
typedef struct ups_fixture_info {
  uint32_t struct_size;
  uint32_t part_count;
  uint64_t triangle_count;
  double flux_lm;
  double emitter_area_m2;
} ups_fixture_info;
typedef struct ups_fixture_instance_desc {
  uint32_t struct_size;
  float dimming;
  double to_world[12];
  float flux_lm;
  uint32_t group;
} ups_fixture_instance_desc;
UPS_API void ups_fixture_emitter_desc_init(ups_fixture_emitter_desc *desc, uint32_t struct_size);
UPS_API void ups_reflector_desc_init(ups_reflector_desc *desc, uint32_t struct_size);
UPS_API void ups_lens_desc_init(ups_lens_desc *desc, uint32_t struct_size);
UPS_API void ups_collimator_desc_init(ups_collimator_desc *desc, uint32_t struct_size);
UPS_API void ups_fixture_part_desc_init(ups_fixture_part_desc *desc, uint32_t struct_size);
UPS_API void ups_fixture_instance_desc_init(ups_fixture_instance_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_fixture_create(ups_context *context, ups_fixture **out);
UPS_API void ups_fixture_destroy(ups_fixture *fixture);
UPS_API ups_status ups_fixture_add_emitter(ups_fixture *fixture, const ups_fixture_emitter_desc *desc,
                                           ups_fixture_part_id *out);
UPS_API ups_status ups_fixture_add_reflector(ups_fixture *fixture, const ups_reflector_desc *desc,
                                             ups_fixture_part_id *out);
UPS_API ups_status ups_fixture_add_lens(ups_fixture *fixture, const ups_lens_desc *desc, ups_fixture_part_id *out);
UPS_API ups_status ups_fixture_add_collimator(ups_fixture *fixture, const ups_collimator_desc *desc,
                                              ups_fixture_part_id *out);
UPS_API ups_status ups_fixture_add_part(ups_fixture *fixture, const ups_fixture_part_desc *desc,
                                        ups_fixture_part_id *out);
UPS_API ups_status ups_fixture_get_info(const ups_fixture *fixture, ups_fixture_info *info);
UPS_API ups_status ups_scene_add_fixture(ups_scene *scene, const ups_fixture *fixture,
                                         const ups_fixture_instance_desc *desc, ups_fixture_id *out);
UPS_API ups_status ups_scene_get_fixture_instance(const ups_scene *scene, ups_fixture_id id, ups_fixture_part_id part,
                                                  ups_instance_id *out);
UPS_API ups_status ups_scene_set_fixture_dimming(ups_scene *scene, ups_fixture_id id, float dimming);
UPS_API ups_status ups_scene_set_fixture_transform(ups_scene *scene, ups_fixture_id id, const double to_world[12]);
UPS_API ups_status ups_scene_remove_fixture(ups_scene *scene, ups_fixture_id id);
typedef int32_t ups_projection;
enum {
  UPS_PERSPECTIVE = 0,
  UPS_EQUIDISTANT = 1,
  UPS_EQUISOLID = 2,
  UPS_PANORAMA = 3
};
enum {
  UPS_LAYER_ALBEDO = 1,
  UPS_LAYER_NORMAL = 2,
  UPS_LAYER_DEPTH = 4,
  UPS_LAYER_ID = 8
};
typedef struct ups_camera_desc {
  uint32_t struct_size;
  ups_projection projection;
  uint32_t width, height;
  double to_world[12];
  float vertical_fov_rad;
  int32_t illuminance;
  uint32_t layers;
  uint32_t reserved;
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
typedef struct ups_meter_desc {
  uint32_t struct_size;
  ups_meter_kind kind;
  const double *positions_m;
  const float *normals;
  const float *tangents;
  float cell_size_m[2];
  uint32_t count;
  uint32_t reserved;
  float footprint_m;
  uint32_t reserved_2;
} ups_meter_desc;
typedef struct ups_surface_meters_desc {
  uint32_t struct_size;
  uint32_t instance_count;
  const ups_instance_id *instances;
  int32_t back;
  uint32_t reserved;
} ups_surface_meters_desc;
typedef struct ups_lightmap_desc {
  uint32_t struct_size;
  uint32_t instance_count;
  const ups_instance_id *instances;
  uint32_t width, height;
  int32_t back;
  uint32_t reserved;
} ups_lightmap_desc;
typedef struct ups_en12464_desc {
  uint32_t struct_size;
  uint32_t corner_count;
  const double *corners_m;
  const double *hole_corners_m;
  const uint32_t *hole_corner_counts;
  uint32_t hole_count;
  uint32_t reserved;
  double border_m;
} ups_en12464_desc;
typedef struct ups_en12464_info {
  uint32_t struct_size;
  uint32_t columns, rows;
  uint32_t point_count;
  double origin_m[2];
  double cell_m[2];
  double largest_spacing_m;
} ups_en12464_info;
typedef struct ups_en12464_point {
  double x_m, y_m;
  uint32_t column, row;
} ups_en12464_point;
typedef struct ups_meter_place {
  double position_m[3];
  float normal[3];
  float area_m2;
  int32_t valid;
  uint32_t triangle;
} ups_meter_place;
typedef struct ups_goniometer_desc {
  uint32_t struct_size;
  ups_profile_symmetry symmetry;
  const float *c_deg;
  const float *gamma_deg;
  uint32_t c_count, gamma_count;
  double to_world[12];
  ups_opening_shape opening_shape;
  float opening_m[3];
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
UPS_API ups_status ups_scene_read_meter_places(const ups_scene *scene, ups_sensor_id meters, ups_meter_place *places,
                                               size_t capacity, size_t *needed);
UPS_API void ups_en12464_desc_init(ups_en12464_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_en12464_grid(const ups_en12464_desc *desc, ups_en12464_info *info, ups_en12464_point *points,
                                    size_t capacity, size_t *needed);
UPS_API void ups_goniometer_desc_init(ups_goniometer_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_scene_add_goniometer(ups_scene *scene, const ups_goniometer_desc *desc, ups_sensor_id *out);
typedef int32_t ups_method;
enum {
  UPS_METHOD_AUTO = 0,
  UPS_METHOD_UPS = 1,
  UPS_METHOD_PATH_TRACING = 2,
  UPS_METHOD_LIGHT_TRACING = 3,
  UPS_METHOD_BIDIRECTIONAL = 4,
  UPS_METHOD_PPM = 5,
  UPS_METHOD_SPPM = 6,
  UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING = 7
};
enum {
  UPS_TECHNIQUE_EMITTER_HIT = 1,
  UPS_TECHNIQUE_LIGHT_SAMPLE = 2,
  UPS_TECHNIQUE_CONNECT = 4,
  UPS_TECHNIQUE_SENSOR_CONNECT = 8,
  UPS_TECHNIQUE_MERGE = 16,
  UPS_TECHNIQUE_SENSOR_HIT = 32
};
typedef int32_t ups_perturbation;
enum {
  UPS_PERTURBATION_VIRTUAL = 0,
  UPS_PERTURBATION_ACTUAL = 1
};
typedef int32_t ups_separation;
enum {
  UPS_SEPARATE_NOTHING = 0,
  UPS_SEPARATE_LUMINAIRES = 1,
  UPS_SEPARATE_GROUPS = 2
};
typedef int32_t ups_criterion;
enum {
  UPS_CRITERION_DEFAULT = 0,
  UPS_CRITERION_WORST = 1,
  UPS_CRITERION_P95 = 2,
  UPS_CRITERION_MEAN = 3,
  UPS_CRITERION_MEDIAN = 4
};
typedef struct ups_render_desc {
  uint32_t struct_size;
  ups_method method;
  uint64_t seed;
  double time_limit_s;
  float target_relative_error;
  float merge_radius_m;
  uint32_t iteration_count;
  uint32_t max_path_length;
  uint32_t light_paths_per_iteration;
  uint32_t techniques;
  float radius_alpha;
  float glossy_alpha;
  ups_perturbation perturbation;
  uint32_t technique_images;
  ups_separation separation;
  uint32_t reserved;
  uint64_t flux_paths;
  ups_criterion target_criterion;
  uint32_t reserved2;
  uint64_t memory_limit_bytes;
} ups_render_desc;
typedef int32_t ups_job_state;
enum { UPS_JOB_RUNNING = 0, UPS_JOB_FINISHED = 1, UPS_JOB_CANCELLED = 2, UPS_JOB_FAILED = 3 };
typedef struct ups_progress {
  uint32_t struct_size;
  ups_job_state state;
  double elapsed_s, remaining_s;
  uint32_t iterations_done;
  float fraction;
  float worst_relative_error, median_relative_error;
} ups_progress;
typedef struct ups_result_info {
  uint32_t struct_size;
  uint32_t iterations;
  double elapsed_s;
  uint64_t rays, light_paths, eye_paths, merges, connections;
  double emitted_flux_lm, absorbed_flux_lm, escaped_flux_lm;
  uint64_t seed;
  uint64_t dropped_samples;
  ups_method method;
  uint32_t techniques;
  uint32_t effects;
  int32_t threads;
  double flux_balance_standard_error_lm;
  double maintenance_factor;
} ups_result_info;
typedef struct ups_meter_reading {
  float illuminance_lx;
  float standard_error_lx;
  float bias_lx;
  float error_bound_lx;
  float direct_lx, indirect_lx;
} ups_meter_reading;
typedef struct ups_vector_reading {
  float vector_lx[3], standard_error_lx[3], error_bound_lx[3];
} ups_vector_reading;
typedef struct ups_meter_part_reading {
  float illuminance_lx;
  float standard_error_lx;
  float bias_lx;
  float error_bound_lx;
} ups_meter_part_reading;
enum {
  UPS_READING_EXACT = 1,
  UPS_READING_UNKNOWN = 2,
  UPS_READING_FEW_PATHS = 4,
  UPS_READING_SINGLE_PATH = 8,
  UPS_READING_HEAVY_TAIL = 16
};
typedef struct ups_convergence_point {
  double elapsed_s;
  uint32_t iterations, reserved;
  float median_relative_error, p95_relative_error, worst_relative_error, bias_share;
} ups_convergence_point;
typedef struct ups_meter_statistics {
  uint32_t struct_size;
  uint32_t count;
  double mean_lx, min_lx, max_lx;
  double uniformity;
  double mean_standard_error_lx;
  double median_relative_error_bound, p95_relative_error_bound, worst_relative_error_bound;
  double mean_bias_lx;
  double mean_error_bound_lx;
  double min_low_lx, min_high_lx, max_low_lx, max_high_lx, uniformity_low, uniformity_high;
  double percentile_5_lx;
  double percentile_5_low_lx, percentile_5_high_lx;
  double diversity;
  double diversity_low, diversity_high;
} ups_meter_statistics;
typedef struct ups_curve_point {
  uint32_t struct_size;
  uint32_t iterations;
  double elapsed_s;
  float median_relative_error, p95_relative_error, worst_relative_error, mean_relative_error;
  float bias_share;
  uint32_t reserved;
  uint64_t rays, light_paths, eye_paths;
  uint64_t resident_bytes;
} ups_curve_point;
typedef int32_t ups_limit;
enum { UPS_LIMIT_UNKNOWN = 0 , UPS_LIMIT_NOISE = 1, UPS_LIMIT_BIAS = 2 };
typedef struct ups_prediction {
  uint32_t struct_size;
  ups_limit limited_by;
  double seconds;
  double seconds_low, seconds_high;
  double iterations;
} ups_prediction;
typedef struct ups_largest_error {
  uint32_t struct_size;
  ups_sensor_id sensor;
  uint32_t index;
  float relative_error, bias_share;
  uint32_t reserved;
  double position_m[3];
} ups_largest_error;
UPS_API void ups_render_desc_init(ups_render_desc *desc, uint32_t struct_size);
typedef struct ups_memory_estimate {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t scene_bytes;
  uint64_t working_bytes;
  uint64_t light_bytes;
  uint64_t result_bytes;
  uint64_t peak_bytes;
  uint64_t allowed_bytes;
} ups_memory_estimate;
UPS_API ups_status ups_scene_estimate_memory(const ups_scene *scene, const ups_render_desc *desc,
                                             ups_memory_estimate *out);
UPS_API ups_status ups_render(const ups_scene *scene, const ups_render_desc *desc, ups_result **out);
UPS_API ups_status ups_job_start(const ups_scene *scene, const ups_render_desc *desc, ups_job **out);
UPS_API ups_status ups_job_poll(const ups_job *job, ups_progress *progress);
UPS_API ups_status ups_job_wait(const ups_job *job, uint32_t timeout_ms);
UPS_API ups_status ups_job_get_prediction(const ups_job *job, double relative_error, ups_prediction *prediction);
UPS_API ups_status ups_job_get_memory_estimate(const ups_job *job, ups_memory_estimate *out);
UPS_API ups_status ups_job_get_curve_count(const ups_job *job, uint32_t *out);
UPS_API ups_status ups_job_get_curve_point(const ups_job *job, uint32_t index, ups_curve_point *point);
UPS_API ups_status ups_job_get_largest_error(const ups_job *job, ups_largest_error *error);
UPS_API void ups_job_cancel(ups_job *job);
UPS_API ups_status ups_job_result(const ups_job *job, ups_result **out);
UPS_API void ups_job_destroy(ups_job *job);
UPS_API ups_status ups_result_get_info(const ups_result *result, ups_result_info *info);
typedef int32_t ups_photons;
enum {
  UPS_PHOTONS_NONE = 0,
  UPS_PHOTONS_CAUSTIC = 1,
  UPS_PHOTONS_ALL = 2
};
typedef struct ups_sensor_choice {
  uint32_t struct_size;
  uint32_t techniques;
  uint32_t light_paths_per_iteration;
  ups_photons photons;
  double predicted_gain;
} ups_sensor_choice;
UPS_API ups_status ups_result_get_choice(const ups_result *result, ups_sensor_id sensor, ups_sensor_choice *choice);
UPS_API ups_status ups_result_read_meters(const ups_result *result, ups_sensor_id sensor, ups_meter_reading *out,
                                          size_t count);
UPS_API ups_status ups_result_read_vectors(const ups_result *result, ups_sensor_id sensor, ups_vector_reading *out,
                                           size_t count);
typedef int32_t ups_light_part;
enum { UPS_LIGHT_PART_DIRECT = 0, UPS_LIGHT_PART_INDIRECT = 1 };
UPS_API ups_status ups_result_read_meter_part(const ups_result *result, ups_sensor_id sensor, ups_light_part part,
                                              ups_meter_part_reading *out, size_t count);
UPS_API ups_status ups_result_read_meter_flags(const ups_result *result, ups_sensor_id sensor, uint32_t *out,
                                               size_t count);
UPS_API ups_status ups_result_get_meter_statistics(const ups_result *result, ups_sensor_id sensor,
                                                   ups_meter_statistics *out);
typedef int32_t ups_source_kind;
enum { UPS_SOURCE_LUMINAIRE = 0 , UPS_SOURCE_INSTANCE = 1, UPS_SOURCE_GROUP = 2 };
typedef struct ups_source_info {
  uint32_t struct_size;
  ups_source_kind kind;
  uint32_t id;
  uint32_t reserved;
  double flux_lm;
} ups_source_info;
UPS_API ups_status ups_result_get_source_count(const ups_result *result, uint32_t *out);
UPS_API ups_status ups_result_get_source(const ups_result *result, uint32_t index, ups_source_info *info);
UPS_API ups_status ups_result_read_source_meters(const ups_result *result, uint32_t source, ups_sensor_id sensor,
                                                 ups_meter_reading *out, size_t count);
typedef struct ups_scene_source {
  uint32_t struct_size;
  ups_source_kind kind;
  uint32_t id, group;
  int32_t light_kind;
  uint32_t reserved;
  double flux_lm;
  double to_world[12];
  double bounds_min_m[3], bounds_max_m[3];
} ups_scene_source;
UPS_API ups_status ups_scene_get_source_count(const ups_scene *scene, uint32_t *out);
UPS_API ups_status ups_scene_get_source(const ups_scene *scene, uint32_t index, ups_scene_source *source);
UPS_API ups_status ups_scene_get_source_profile(const ups_scene *scene, uint32_t index, ups_profile **out);
typedef struct ups_goniometer_info {
  uint32_t struct_size;
  uint32_t c_count, gamma_count, reserved;
  double flux_lm, flux_standard_error_lm;
  double outside_flux_lm;
  double emitted_flux_lm, absorbed_flux_lm;
  double light_output_ratio, light_output_ratio_standard_error;
  double worst_relative_error_bound, median_relative_error_bound;
} ups_goniometer_info;
typedef struct ups_intensity_reading {
  float intensity_cd;
  float standard_error_cd;
  float bias_cd;
  float error_bound_cd;
} ups_intensity_reading;
UPS_API ups_status ups_result_get_goniometer_info(const ups_result *result, ups_sensor_id sensor,
                                                  ups_goniometer_info *info);
UPS_API ups_status ups_result_read_goniometer(const ups_result *result, ups_sensor_id sensor,
                                              ups_intensity_reading *out, size_t count);
UPS_API ups_status ups_result_get_goniometer_angles(const ups_result *result, ups_sensor_id sensor, float *c_deg,
                                                    size_t c_count, float *gamma_deg, size_t gamma_count);
typedef struct ups_goniometer_beam {
  uint32_t struct_size;
  float angle_deg;
  float standard_error_deg;
  float bias_deg;
  float low_deg, high_deg;
} ups_goniometer_beam;
UPS_API ups_status ups_result_get_goniometer_beam(const ups_result *result, ups_sensor_id sensor, float c_deg,
                                                  float fraction, ups_goniometer_beam *beam);
UPS_API ups_status ups_result_get_goniometer_profile(const ups_result *result, ups_sensor_id sensor, ups_profile **out);
typedef int32_t ups_channel;
enum {
  UPS_CHANNEL_LUMINANCE_RGB = 0,
  UPS_CHANNEL_STANDARD_ERROR_RGB = 1,
  UPS_CHANNEL_ILLUMINANCE = 2,
  UPS_CHANNEL_PATH_INTEGRATION_RGB = 3,
  UPS_CHANNEL_DENSITY_ESTIMATION_RGB = 4,
  UPS_CHANNEL_BIAS = 5,
  UPS_CHANNEL_ERROR_BOUND = 6,
  UPS_CHANNEL_ROBUST_RGB = 7,
  UPS_CHANNEL_ILLUMINANCE_STANDARD_ERROR = 8,
  UPS_CHANNEL_ALBEDO_RGB = 9,
  UPS_CHANNEL_NORMAL = 10,
  UPS_CHANNEL_DEPTH = 11,
  UPS_CHANNEL_ID = 12
};
UPS_API ups_status ups_result_read_image(const ups_result *result, ups_sensor_id camera, ups_channel channel,
                                         float *out, size_t row_stride_bytes, size_t size_bytes);
typedef struct ups_technique_info {
  uint32_t struct_size;
  uint32_t technique;
  uint32_t light_vertices;
  uint32_t eye_vertices;
  uint32_t edges;
} ups_technique_info;
typedef int32_t ups_contribution;
enum {
  UPS_CONTRIBUTION_WEIGHTED = 0,
  UPS_CONTRIBUTION_UNWEIGHTED = 1
};
UPS_API ups_status ups_result_get_technique_count(const ups_result *result, ups_sensor_id camera, uint32_t *out);
UPS_API ups_status ups_result_get_technique(const ups_result *result, ups_sensor_id camera, uint32_t index,
                                            ups_technique_info *info);
UPS_API ups_status ups_result_read_technique(const ups_result *result, ups_sensor_id camera, uint32_t index,
                                             ups_contribution contribution, float *out, size_t row_stride_bytes,
                                             size_t size_bytes);
UPS_API ups_status ups_result_read_convergence(const ups_result *result, ups_convergence_point *points, size_t capacity,
                                               size_t *needed);
UPS_API ups_status ups_result_get_prediction(const ups_result *result, double relative_error,
                                             ups_prediction *prediction);
UPS_API ups_status ups_result_get_curve_count(const ups_result *result, uint32_t *out);
UPS_API ups_status ups_result_get_curve_point(const ups_result *result, uint32_t index, ups_curve_point *point);
UPS_API ups_status ups_result_get_largest_error(const ups_result *result, ups_largest_error *error);
typedef int32_t ups_result_text;
enum { UPS_TEXT_WARNINGS = 0, UPS_TEXT_EFFECTS = 1, UPS_TEXT_TECHNIQUES = 2, UPS_TEXT_DROPPED = 3 };
UPS_API ups_status ups_result_get_text(const ups_result *result, ups_result_text topic, char *text, size_t capacity,
                                       size_t *needed);
UPS_API void ups_result_destroy(ups_result *result);
typedef int32_t ups_walk;
enum { UPS_WALK_EYE = 0 , UPS_WALK_LIGHT = 1 };
typedef struct ups_sample {
  uint64_t seed;
  ups_sensor_id sensor;
  uint32_t index;
  uint32_t iteration;
  ups_walk walk;
  uint32_t path;
  float value;
  float share;
  uint32_t reserved;
} ups_sample;
UPS_API ups_status ups_result_read_largest_samples(const ups_result *result, ups_sensor_id sensor, ups_sample *samples,
                                                   size_t capacity, size_t *needed);
typedef struct ups_path ups_path;
UPS_API ups_status ups_replay(const ups_scene *scene, const ups_render_desc *desc, const ups_sample *sample,
                              ups_path **out);
UPS_API void ups_path_destroy(ups_path *path);
typedef struct ups_path_info {
  uint32_t struct_size;
  uint32_t walks;
  double value;
  uint32_t contributions;
  uint32_t reserved;
} ups_path_info;
typedef int32_t ups_path_event;
enum {
  UPS_EVENT_START = 0,
  UPS_EVENT_END = 1,
  UPS_EVENT_SCATTERED = 2,
  UPS_EVENT_MIRRORED = 3,
  UPS_EVENT_REFRACTED = 4
};
typedef struct ups_path_vertex {
  double position_m[3];
  float normal[3];
  float throughput;
  float pdf, pdf_reverse;
  float survival;
  uint32_t walk;
  ups_instance_id instance;
  ups_path_event event;
} ups_path_vertex;
typedef struct ups_path_contribution {
  double from_m[3], to_m[3];
  float value;
  float weight;
  uint32_t technique;
  uint32_t edges;
  uint32_t light_vertices;
  uint32_t walk;
  uint32_t light_path;
  ups_source_kind source_kind;
  uint32_t source;
  uint32_t reserved;
} ups_path_contribution;
UPS_API ups_status ups_path_get_info(const ups_path *path, ups_path_info *info);
UPS_API ups_status ups_path_read_vertices(const ups_path *path, ups_path_vertex *vertices, size_t capacity,
                                          size_t *needed);
UPS_API ups_status ups_path_read_contributions(const ups_path *path, ups_path_contribution *contributions,
                                               size_t capacity, size_t *needed);
UPS_API ups_status ups_path_get_text(const ups_path *path, char *text, size_t capacity, size_t *needed);
typedef struct ups_interval {
  double value, low, high;
} ups_interval;
UPS_API ups_status ups_result_get_meter_percentile(const ups_result *result, ups_sensor_id sensor, double share,
                                                   ups_interval *out);
UPS_API ups_status ups_result_get_meter_share(const ups_result *result, ups_sensor_id sensor, double threshold_lx,
                                              ups_interval *out);
UPS_API ups_status ups_result_get_meter_ratio(const ups_result *result, ups_sensor_id numerator,
                                              ups_sensor_id denominator, ups_interval *out);
UPS_API ups_status ups_result_read_meter_ratios(const ups_result *result, ups_sensor_id numerator,
                                                ups_sensor_id denominator, ups_interval *out, size_t count);
typedef int32_t ups_position_index;
enum {
  UPS_POSITION_INDEX_TABLE = 0,
  UPS_POSITION_INDEX_GUTH = 1
};
UPS_API ups_status ups_glare_get_position_index(ups_position_index kind, const float *directions_xyz, size_t count,
                                                float *index);
UPS_API ups_status ups_glare_get_ugr(const float *luminance_cd_m2, const float *solid_angle_sr,
                                     const float *position_index, size_t count, double background_cd_m2, float *ugr);
typedef struct ups_ugr_table {
  uint32_t struct_size;
  float lamp_flux_lm;
  float room_across_h[19], room_along_h[19];
  float reflectances[15];
  float crosswise[95];
  float endwise[95];
} ups_ugr_table;
UPS_API ups_status ups_profile_get_ugr_table(const ups_profile *profile, ups_ugr_table *table);
typedef struct ups_data_sheet {
  uint32_t struct_size;
  float flux_code[5];
  float luminance_cd_m2[3];
  float highest_luminance_cd_m2;
  float highest_luminance_c_deg, highest_luminance_gamma_deg;
  float spacing_criterion[3];
  int32_t nema_horizontal, nema_vertical;
  float front_lm[4], back_lm[4], up_lm[2];
  int32_t backlight_rating, uplight_rating, glare_rating, bug_type_v;
} ups_data_sheet;
UPS_API ups_status ups_profile_get_data_sheet(const ups_profile *profile, float front_c_deg, ups_data_sheet *sheet);
typedef struct ups_utilisation_table {
  uint32_t struct_size;
  float room_index[10];
  float reflectances[30];
  float factors[100];
} ups_utilisation_table;
UPS_API ups_status ups_profile_get_utilisation(const ups_profile *profile, ups_utilisation_table *table);
typedef int32_t ups_glare_metric;
enum { UPS_GLARE_METRIC_UGR = 0 };
typedef struct ups_observer_desc {
  uint32_t struct_size;
  ups_glare_metric metric;
  ups_position_index position_index;
  uint32_t reserved;
  double to_world[12];
} ups_observer_desc;
UPS_API void ups_observer_desc_init(ups_observer_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_scene_add_observer(ups_scene *scene, const ups_observer_desc *desc, ups_sensor_id *out);
enum {
  UPS_OBSERVER_NO_SOURCE = 1,
  UPS_OBSERVER_NO_BACKGROUND = 2,
  UPS_OBSERVER_LARGE_SOURCE = 4,
  UPS_OBSERVER_POINT_SOURCE = 8,
  UPS_OBSERVER_UNRATED_SOURCE = 16
};
typedef struct ups_observer_reading {
  uint32_t struct_size;
  uint32_t flags;
  float ugr;
  float ugr_standard_error;
  float ugr_low, ugr_high;
  float background_cd_m2;
  float background_standard_error_cd_m2, background_error_bound_cd_m2;
  uint32_t source_count;
} ups_observer_reading;
UPS_API ups_status ups_result_get_observer(const ups_result *result, ups_sensor_id observer,
                                           ups_observer_reading *reading);
enum {
  UPS_GLARE_FLAG_SMALL = 1,
  UPS_GLARE_FLAG_POINT = 2,
  UPS_GLARE_FLAG_LARGE = 4,
  UPS_GLARE_FLAG_HIDDEN = 8
};
typedef struct ups_glare_source {
  uint32_t struct_size;
  ups_source_kind kind;
  uint32_t id;
  uint32_t flags;
  float luminance_cd_m2;
  float solid_angle_sr;
  float intensity_cd;
  float distance_m;
  float visible_share;
  float position_index;
  float share;
  float direction[3];
} ups_glare_source;
UPS_API ups_status ups_result_get_glare_source(const ups_result *result, ups_sensor_id observer, uint32_t index,
                                               ups_glare_source *source);
#endif
