/* UPS: fixtures: luminaires modelled down to their emitters, with reflectors, lenses and collimators of a few numbers.
 *
 * A fixture has a frame of its own, in metres: light leaves along local -Z, and apertures open towards -Z. It is built
 * once and placed any number of times; the meshes of its parts are then shared. What it does to light is simulated:
 * round reflectors, lenses and collimators are traced as the curved surfaces that they are, not as triangles.
 *
 *   ups_fixture_create(context, &fixture);
 *   ups_fixture_emitter_desc_init(&cob, sizeof cob);   cob.radius_m = 0.0045; cob.flux_lm = 1000;
 *   ups_reflector_desc_init(&cup, sizeof cup);         cup.focal_length_m = 0.006; cup.inner_radius_m = 0.006;
 *                                                      cup.aperture_radius_m = 0.035;
 *   ups_fixture_add_emitter(fixture, &cob, NULL);      ups_fixture_add_reflector(fixture, &cup, NULL);
 *   ups_scene_add_fixture(scene, fixture, &placement, &id);
 */
#ifndef UPS_FIXTURE_H
#define UPS_FIXTURE_H

#include "ups_scene.h"

typedef struct ups_fixture ups_fixture; /* parts of a luminaire; many threads read, or one changes it */
typedef struct { uint32_t v; } ups_fixture_part_id;
typedef struct { uint32_t v; } ups_fixture_id; /* of a scene: a fixture that stands in it */

/* Surfaces as luminaires have them; the numbers are typical of what makers of lighting sheet and optical plastics
 * state, and can be replaced one by one. Sheets (the first six) are for reflectors and housings, solids for lenses,
 * collimators and closed housings.
 *   SPECULAR_ALUMINIUM       ideal mirror, 0.86: anodised bright aluminium (total reflectance 0.84 to 0.87)
 *   ENHANCED_ALUMINIUM       ideal mirror, 0.95: aluminium with an oxide stack
 *   SEMI_SPECULAR_ALUMINIUM  GGX metal of F0 0.86, roughness 0.35 (alpha 0.12: half of the light within about 14 deg)
 *   MATTE_WHITE              Lambertian, 0.90: white reflector paint
 *   BLACK                    absorbs everything
 *   OPAL                     thin Lambertian sheet, transmittance 0.60, reflectance 0.35: opal acrylic of 3 mm
 *   PMMA                     index 1.49, absorption 0.2 / m: clear acrylic absorbs less than 0.5 % an inch
 *   POLYCARBONATE            index 1.585, absorption 4.6 / m: 3 mm transmit 0.89, of which 0.903 are Fresnel's
 *   GLASS                    index 1.52, absorption 2.2 / m: low-iron glass, 4 mm transmit 0.91
 *   FROSTED_PMMA             PMMA whose whole surface has roughness 0.5 (GGX alpha 0.25)
 *   CUSTOM                   *material: no textures, no luminance */
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

/* Every part has
 *   to_fixture             where the part's origin and axes lie: a rotation and a translation
 *   finish, finish_*       < 0: the finish's own number; >= 0: in its place, where it has one (reflectance: sheets but
 *                          BLACK; transmittance: OPAL; roughness: SEMI_SPECULAR_ALUMINIUM, FROSTED_PMMA; absorption and
 *                          index: solids; CUSTOM: none)
 *   chord_tolerance_m      largest distance of the triangles from the shape; 0: 0.1 % of the largest radius; of
 *                          emitters but spheres 0.01 %
 *   normal_tolerance_rad   largest angle of the interpolated normals from the shape's; 0: 0.1 degrees, round: 10
 *   facets_around          0: round; else so many sides, 3 to 100,000, flat around, their corners on the round shape
 *   facets_along           0: smooth; else so many straight bands along the profile, at most 100,000
 * A part needs at most 4,000,000 triangles: finer tolerances fail.
 * Light meets round parts (facets_around 0) in the shape itself whatever the tolerances: in quadrics of revolution that
 * cones, cylinders, spheres, paraboloids, ellipsoids and conic lens faces are, and that other profiles are replaced by
 * to 1e-7 of their largest radius and 1e-4 rad. Their triangles only number the places. Emitters and faceted parts are
 * triangles: discs and cylinders have their corners on the round shape, spheres the sphere's area. By default that
 * changes a light output ratio by some 1e-6. */

typedef int32_t ups_emitter_shape;
enum {
  UPS_EMITTER_DISC = 0,      /* radius_m; shines along the part's -Z alone: a COB */
  UPS_EMITTER_RECTANGLE = 1, /* width_m along X, length_m along Y; along -Z alone */
  UPS_EMITTER_SPHERE = 2,    /* radius_m */
  UPS_EMITTER_CYLINDER = 3   /* radius_m, length_m along Z; its ends shine too */
};

/* A Lambertian surface, its luminance even; centred on the part's origin. */
typedef struct ups_fixture_emitter_desc {
  uint32_t struct_size;
  ups_emitter_shape shape;
  double to_fixture[12];
  double radius_m, width_m, length_m; /* > 0 where the shape has them, at most 1e9, as of all parts, else 0 */
  double chord_tolerance_m;
  float flux_lm;                      /* >= 0: what leaves the emitter */
  float color_rgb[3];                 /* chromaticity only: luminance is normalised away */
  float reflectance;                  /* [0, 1], Lambertian; 0 */
  float reserved;                     /* 0 */
} ups_fixture_emitter_desc;

typedef int32_t ups_reflector_profile;
enum {
  UPS_REFLECTOR_PARABOLOID = 0, /* focus at the origin, vertex at +Z: focal_length_m, inner_ and aperture_radius_m */
  UPS_REFLECTOR_ELLIPSOID = 1,  /* upper focus at the origin, lower one at z = -2 half_distance_m: semi_axis_m along Z,
                                 * inner_radius_m, and aperture_radius_m (above the widest place) or depth_m */
  UPS_REFLECTOR_CONE = 2,       /* inner_radius_m at z = 0 to aperture_radius_m at z = -depth_m */
  UPS_REFLECTOR_CYLINDER = 3,   /* aperture_radius_m, from z = 0 to -depth_m */
  UPS_REFLECTOR_POLYLINE = 4    /* profile_rz_m */
};

/* An open sheet about the part's Z; both its sides are of the finish. */
typedef struct ups_reflector_desc {
  uint32_t struct_size;
  ups_reflector_profile profile;
  double to_fixture[12];
  double focal_length_m;               /* > 0 */
  double semi_axis_m, half_distance_m; /* 0 <= half_distance_m (of the foci) < semi_axis_m */
  double inner_radius_m;               /* of the hole around the vertex, >= 0; 0: none */
  double aperture_radius_m, depth_m;   /* ELLIPSOID: one of them 0; its depth counts from the vertex, < 2 semi_axis_m */
  const double *profile_rz_m;          /* radius >= 0 and z of each point, 2 * profile_point_count */
  uint32_t profile_point_count;        /* 2 to 100,000 */
  int32_t smooth;                      /* 1: a cubic through the points; 0: straight, with creases */
  uint32_t facets_around, facets_along; /* along: not with POLYLINE, whose points are creases where it is not smooth */
  double chord_tolerance_m, normal_tolerance_rad;
  ups_finish finish;                   /* a sheet */
  float finish_reflectance, finish_transmittance, finish_roughness;
  const ups_material_desc *material;   /* CUSTOM */
} ups_reflector_desc;

/* A solid between two faces about the part's Z, and a cylindrical edge; plates and covers are lenses of flat faces.
 *   sag(r) = c r^2 / (1 + sqrt(1 - (1 + conic) c^2 r^2)) + sum of coefficients[i] r^(4 + 2 i),   c = 1 / radius
 * in metres, towards the inside of the lens: a radius > 0 is convex, < 0 concave, 0 flat. The entry face's vertex is
 * the origin, the exit face's lies at z = -thickness_m. */
typedef struct ups_lens_desc {
  uint32_t struct_size;
  ups_finish finish;                   /* a solid */
  double to_fixture[12];
  double radius_m, thickness_m;        /* of the edge, > 0; on the axis, > 0: faces must not cross inside the edge */
  double entry_radius_m, entry_conic, entry_coefficients[4];
  double exit_radius_m, exit_conic, exit_coefficients[4];
  double chord_tolerance_m, normal_tolerance_rad;
  uint32_t facets_around;
  float finish_roughness, finish_absorption_per_m, finish_ior;
  const ups_material_desc *material;
} ups_lens_desc;

typedef int32_t ups_collimator_wall;
enum {
  UPS_COLLIMATOR_PARALLEL = 0,   /* turns the light of a point at the origin parallel; wall_thickness_m */
  UPS_COLLIMATOR_PARABOLOID = 1, /* wall_focal_length_m, focus at the origin; height_m */
  UPS_COLLIMATOR_POLYLINE = 2    /* wall_rz_m, from z = 0 down */
};

/* A solid that works by total internal reflection. Its top, the plane z = 0, has a cylindrical cavity with the source
 * at the origin; a lens at the cavity's bottom bends the middle of the light, the outer wall turns what passes the
 * cavity's wall. */
typedef struct ups_collimator_desc {
  uint32_t struct_size;
  ups_finish finish;                      /* a solid */
  double to_fixture[12];
  double cavity_radius_m, cavity_depth_m; /* > 0; the depth is that of the lens' vertex */
  double lens_radius_m, lens_conic;       /* of an entry face; 0: turns light of the origin parallel; INFINITY: flat */
  ups_collimator_wall wall;
  int32_t smooth;                         /* of wall_rz_m */
  double wall_thickness_m;                /* PARALLEL: of the solid around the mouth, > 0 */
  double wall_focal_length_m;
  double height_m;                        /* of the exit face's edge below the mouth; 0: where the wall ends */
  const double *wall_rz_m;                /* radius and z of each point, 2 * wall_point_count; the first z is 0 */
  uint32_t wall_point_count;
  uint32_t facets_around;                 /* of the whole solid */
  double exit_radius_m, exit_conic;       /* as of a lens' exit face; 0: flat */
  double chord_tolerance_m, normal_tolerance_rad;
  uint32_t exit_facets_along;
  float finish_roughness, finish_absorption_per_m, finish_ior;
  const ups_material_desc *material;
} ups_collimator_desc;

/* Any mesh: housings, louvres, heat sinks. Of *mesh positions, normals and indices are read; its material must be 0. */
typedef struct ups_fixture_part_desc {
  uint32_t struct_size;
  ups_finish finish; /* a solid needs a closed mesh, its vertices equal bit for bit where triangles meet */
  double to_fixture[12];
  const ups_mesh_desc *mesh;
  float finish_reflectance, finish_transmittance, finish_roughness, finish_absorption_per_m, finish_ior;
  float reserved;    /* 0 */
  const ups_material_desc *material;
} ups_fixture_part_desc;

typedef struct ups_fixture_info {
  uint32_t struct_size;
  uint32_t part_count;
  uint64_t triangle_count;
  double flux_lm;         /* of all emitters */
  double emitter_area_m2; /* of their triangles */
} ups_fixture_info;

typedef struct ups_fixture_instance_desc {
  uint32_t struct_size;
  float dimming;       /* >= 0, multiplies the flux */
  double to_world[12]; /* local -Z is the nadir; a rotation and a translation */
  float flux_lm;       /* all emitters together are scaled to it; < 0: as they are */
  uint32_t group;      /* of its emitters, for UPS_SEPARATE_GROUPS; UPS_SEPARATE_LUMINAIRES tells each of them apart */
} ups_fixture_instance_desc;

UPS_API void ups_fixture_emitter_desc_init(ups_fixture_emitter_desc *desc, uint32_t struct_size);
UPS_API void ups_reflector_desc_init(ups_reflector_desc *desc, uint32_t struct_size);
UPS_API void ups_lens_desc_init(ups_lens_desc *desc, uint32_t struct_size);
UPS_API void ups_collimator_desc_init(ups_collimator_desc *desc, uint32_t struct_size);
UPS_API void ups_fixture_part_desc_init(ups_fixture_part_desc *desc, uint32_t struct_size);
UPS_API void ups_fixture_instance_desc_init(ups_fixture_instance_desc *desc, uint32_t struct_size);

UPS_API ups_status ups_fixture_create(ups_context *context, ups_fixture **out);
UPS_API void ups_fixture_destroy(ups_fixture *fixture); /* NULL ok; what was placed stays */

/* Each copies its input, adds a part and hands out its number, counted from 1; out may be NULL. Parts that are added
 * after a fixture was placed are in later placements alone. Errors: INVALID_ARGUMENT names the part and the field. */
UPS_API ups_status ups_fixture_add_emitter(ups_fixture *fixture, const ups_fixture_emitter_desc *desc,
                                           ups_fixture_part_id *out);
UPS_API ups_status ups_fixture_add_reflector(ups_fixture *fixture, const ups_reflector_desc *desc,
                                             ups_fixture_part_id *out);
UPS_API ups_status ups_fixture_add_lens(ups_fixture *fixture, const ups_lens_desc *desc, ups_fixture_part_id *out);
UPS_API ups_status ups_fixture_add_collimator(ups_fixture *fixture, const ups_collimator_desc *desc,
                                              ups_fixture_part_id *out);
UPS_API ups_status ups_fixture_add_part(ups_fixture *fixture, const ups_fixture_part_desc *desc,
                                        ups_fixture_part_id *out);
/* info->struct_size must be set. */
UPS_API ups_status ups_fixture_get_info(const ups_fixture *fixture, ups_fixture_info *info);

/* Places a fixture: adds its parts as meshes and instances. The luminance of an emitter is its flux / (pi * the area of
 * its triangles). The scene keeps what it needs: the fixture may be changed or destroyed afterwards. */
UPS_API ups_status ups_scene_add_fixture(ups_scene *scene, const ups_fixture *fixture,
                                         const ups_fixture_instance_desc *desc, ups_fixture_id *out);
/* The instance that a part became: what ups_source_info tells of its light. Errors: INVALID_ARGUMENT where the fixture
 * had no such part when it was placed. */
UPS_API ups_status ups_scene_get_fixture_instance(const ups_scene *scene, ups_fixture_id id, ups_fixture_part_id part,
                                                  ups_instance_id *out);
/* Edits, by the rules of ups_scene.h. */
UPS_API ups_status ups_scene_set_fixture(ups_scene *scene, ups_fixture_id id, const ups_fixture_instance_desc *desc);
UPS_API ups_status ups_scene_get_fixture(const ups_scene *scene, ups_fixture_id id, ups_fixture_instance_desc *desc);
UPS_API ups_status ups_scene_set_fixture_dimming(ups_scene *scene, ups_fixture_id id, float dimming);
UPS_API ups_status ups_scene_set_fixture_transform(ups_scene *scene, ups_fixture_id id, const double to_world[12]);
UPS_API ups_status ups_scene_remove_fixture(ups_scene *scene, ups_fixture_id id);

#endif
