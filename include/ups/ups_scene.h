/* UPS: what a scene is made of: textures, materials, meshes, instances, lights and luminaires. */
#ifndef UPS_SCENE_H
#define UPS_SCENE_H

#include "ups_base.h"

typedef int32_t ups_material_model;
enum {
  UPS_MATERIAL_MATTE = 0,    /* Lambertian; reflectance */
  UPS_MATERIAL_PLASTIC = 1,  /* diffuse base of `reflectance` under a GGX dielectric coat of `ior`;
                              * `metallic` mixes in METAL */
  UPS_MATERIAL_METAL = 2,    /* GGX conductor: reflectance is F0; or complex index ior_rgb, ior_k_rgb where any k > 0 */
  UPS_MATERIAL_MIRROR = 3,   /* ideal mirror; reflectance at every angle */
  UPS_MATERIAL_GLASS = 4,    /* solid dielectric of `ior`, `roughness`, absorption_per_m_rgb behind its surface; with
                              * what it touches, and no light goes through, in optical contact */
  UPS_MATERIAL_GLAZING = 5,  /* thin pane of `ior`; transmittance at normal incidence with inner
                              * reflections (< 0: clear) */
  UPS_MATERIAL_DIFFUSER = 6  /* thin Lambertian: reflectance and transmittance, together <= 1 */
};

typedef struct ups_texture_desc {
  uint32_t struct_size;
  uint32_t width, height, channel_count; /* channels 1, 3 or 4; texels linear */
  const float *texels;                   /* row 0 first (glTF: v = 0), finite */
  size_t row_stride_bytes;               /* 0: tight */
} ups_texture_desc;

typedef int32_t ups_alpha_mode;
enum { UPS_ALPHA_OPAQUE = 0, UPS_ALPHA_MASK = 1, UPS_ALPHA_BLEND = 2 };

typedef struct ups_material_desc {
  uint32_t struct_size;
  ups_material_model model;
  float reflectance_rgb[3], transmittance_rgb[3]; /* [0, 1], linear Rec.709; transmittance < 0: the model's default */
  float roughness;                                /* [0, 1]; GGX alpha = roughness squared */
  float ior;                                      /* 1 to 1e6 for dielectrics; of rough PLASTIC and GLASS at most
                                                   * 3 is taken, with a warning; of all but GLASS against air, in
                                                   * glass and water too */
  float ior_rgb[3], ior_k_rgb[3];                 /* METAL's complex index, <= 1e6; all k 0: reflectance is F0 */
  float absorption_per_m_rgb[3];                  /* GLASS, >= 0 */
  float metallic;                                 /* [0, 1], PLASTIC only: share of METAL with
                                                   * the same reflectance, roughness */
  ups_alpha_mode alpha_mode;
  float alpha, alpha_cutoff;                      /* times alpha_texture; MASK: a hole where it is < cutoff; BLEND:
                                                   * the share of the light that meets it. GLASS, which bounds a
                                                   * solid, and what emits have none: a warning says so */
  float luminance_cd_m2[3];                       /* Lambertian emission, front side; 0: none */
  int32_t emits_both_sides;                       /* 0 or 1; 1: twice the flux */
  float normal_scale;                             /* of the normal texture's x and y */
  /* 0: none. A texture multiplies its factor; normal: tangent space, texel * 2 - 1; 1-channel ones read channel 0,
   * alpha reads the last channel. */
  ups_texture_id reflectance_texture, roughness_texture, metallic_texture, normal_texture, alpha_texture;
  int32_t priority;                               /* GLASS, any integer (0): where solids overlap, or their faces
                                                   * coincide, the medium of the highest counts; at equal priority
                                                   * that of the instance of smallest volume. A solid is an instance
                                                   * whose mesh is closed, without holes, its front outwards; where
                                                   * it is inwards a warning says so, and the glass lies within. */
  /* GLAZING: what the pane lets through and reflects by angle of incidence, instead of transmittance_rgb. */
  const float *pane_angle_deg;                    /* ascending from 0 to 90; straight lines between */
  const float *pane_transmittance;                /* [0, 1], directional-hemispherical, reflections within included */
  const float *pane_reflectance;                  /* the same, together at most 1; NULL: a clear pane's of `ior`, less
                                                   * where the two would exceed 1 */
  uint32_t pane_angle_count;                      /* 2..9001; 0: none */
  uint32_t reserved;                              /* 0 */
} ups_material_desc;

/* Both sides of every surface block and scatter light; only emission has a side: front is counter-clockwise. */
typedef struct ups_mesh_desc {
  uint32_t struct_size;
  uint32_t vertex_count, triangle_count;
  ups_material_id material;
  const float *positions_m;       /* 3 * vertex_count, finite */
  size_t position_stride_bytes;   /* 0: 12 */
  const float *normals;           /* optional, 3 * vertex_count */
  size_t normal_stride_bytes;     /* 0: 12 */
  const float *uvs;               /* optional, 2 * vertex_count */
  size_t uv_stride_bytes;         /* 0: 8 */
  const float *tangents;          /* optional, xyzw as in glTF */
  size_t tangent_stride_bytes;    /* 0: 16 */
  const uint32_t *indices;        /* 3 * triangle_count, < vertex_count */
} ups_mesh_desc;

typedef struct ups_instance_desc {
  uint32_t struct_size;
  ups_mesh_id mesh;
  double to_world[12]; /* invertible; a negative determinant flips the winding */
  uint32_t group;      /* of its emission, for UPS_SEPARATE_GROUPS */
  uint32_t reserved;   /* 0 */
} ups_instance_desc;

typedef int32_t ups_light_kind;
enum { UPS_LIGHT_POINT = 0, UPS_LIGHT_SPOT = 1, UPS_LIGHT_DIRECTIONAL = 2 };

/* A source without extent. */
typedef struct ups_light_desc {
  uint32_t struct_size;
  ups_light_kind kind;
  double to_world[12];      /* shines along local -Z; scale is ignored */
  float intensity_rgb[3];   /* cd; directional: lx on a surface that faces it */
  float inner_cone_rad, outer_cone_rad; /* spot: 0 <= inner < outer <= pi/2; glTF's falloff in between */
  uint32_t group;           /* for UPS_SEPARATE_GROUPS */
} ups_light_desc;

typedef struct ups_luminaire_desc {
  uint32_t struct_size;
  int32_t use_opening;        /* 1: emits from the profile's luminous opening, or its rays; 0: from a point */
  const ups_profile *profile; /* may be destroyed after the call */
  double to_world[12];        /* profile nadir is local -Z, C0 is local +X, C90 local +Y; scale is ignored,
                               * what mirrors mirrors the light; of sheared axes Z counts, then X, with a
                               * warning */
  float color_rgb[3];         /* chromaticity only: luminance is normalised away */
  float flux_lm;              /* what band-rule flux (of rays: their sum) is scaled to; < 0: as the profile */
  float dimming;              /* >= 0, multiplies the flux */
  float intensity_scale;      /* >= 0, multiplies the flux too;
                               * for maintenance factors and EXT_lights_ies multipliers */
  uint32_t group;             /* for UPS_SEPARATE_GROUPS: luminaires that are switched and dimmed together */
  uint32_t reserved;          /* 0 */
} ups_luminaire_desc;

UPS_API void ups_texture_desc_init(ups_texture_desc *desc, uint32_t struct_size);
UPS_API void ups_material_desc_init(ups_material_desc *desc, uint32_t struct_size);
UPS_API void ups_mesh_desc_init(ups_mesh_desc *desc, uint32_t struct_size);
UPS_API void ups_instance_desc_init(ups_instance_desc *desc, uint32_t struct_size);
UPS_API void ups_light_desc_init(ups_light_desc *desc, uint32_t struct_size);
UPS_API void ups_luminaire_desc_init(ups_luminaire_desc *desc, uint32_t struct_size);

UPS_API ups_status ups_scene_create(ups_context *context, ups_scene **out);
UPS_API void ups_scene_destroy(ups_scene *scene); /* NULL ok; renders already running go on */

/* Each copies its input and returns an id of this scene. Errors: INVALID_ARGUMENT names the field and the element. */
UPS_API ups_status ups_scene_add_texture(ups_scene *scene, const ups_texture_desc *desc, ups_texture_id *out);
UPS_API ups_status ups_scene_add_material(ups_scene *scene, const ups_material_desc *desc, ups_material_id *out);
UPS_API ups_status ups_scene_add_mesh(ups_scene *scene, const ups_mesh_desc *desc, ups_mesh_id *out);
UPS_API ups_status ups_scene_add_instance(ups_scene *scene, const ups_instance_desc *desc, ups_instance_id *out);
UPS_API ups_status ups_scene_add_light(ups_scene *scene, const ups_light_desc *desc, ups_luminaire_id *out);
UPS_API ups_status ups_scene_add_luminaire(ups_scene *scene, const ups_luminaire_desc *desc, ups_luminaire_id *out);

/* ---- edits ----
 * What was added can be set, asked for and removed; its id stays. Edits take effect at the next commit.
 *
 * ups_scene_set_X takes a whole desc as ups_scene_add_X does, with the same errors; where it fails nothing has changed.
 * ups_scene_get_X gives the desc as it stands, edits that were not committed included: desc->struct_size must be set, at
 * most that many bytes are written. Its arrays are the scene's own: they may be read, and handed to ups_scene_set_X,
 * until that thing is set or removed or the scene is destroyed. So an edit of one field is get, change, set.
 * ups_scene_remove_X gives the memory back: after the next commit, once no render and no result of earlier ones is left.
 * The id is never handed out again: who uses it is told that it was removed (UPS_ERROR_INVALID_ARGUMENT). What others
 * still need is not removed: INVALID_ARGUMENT names the first of them. */
UPS_API ups_status ups_scene_set_texture(ups_scene *scene, ups_texture_id id, const ups_texture_desc *desc);
UPS_API ups_status ups_scene_set_material(ups_scene *scene, ups_material_id id, const ups_material_desc *desc);
/* Vertices, triangles and material. Not of a fixture's curved parts. */
UPS_API ups_status ups_scene_set_mesh(ups_scene *scene, ups_mesh_id id, const ups_mesh_desc *desc);
/* The vertices alone, as many as the mesh has: positions_m 3 * vertex_count, tight; normals the same, or NULL: as they
 * are. */
UPS_API ups_status ups_scene_set_mesh_vertices(ups_scene *scene, ups_mesh_id id, const float *positions_m,
                                               const float *normals, uint32_t vertex_count);
/* Both: not of a fixture's parts, which ups_scene_set_fixture places. */
UPS_API ups_status ups_scene_set_instance(ups_scene *scene, ups_instance_id id, const ups_instance_desc *desc);
UPS_API ups_status ups_scene_set_transform(ups_scene *scene, ups_instance_id id, const double to_world[12]);
/* Keeps the dimming. An id of a luminaire is refused, as that of a light by ups_scene_set_luminaire. */
UPS_API ups_status ups_scene_set_light(ups_scene *scene, ups_luminaire_id id, const ups_light_desc *desc);
/* desc->profile NULL: the one that the luminaire has. */
UPS_API ups_status ups_scene_set_luminaire(ups_scene *scene, ups_luminaire_id id, const ups_luminaire_desc *desc);
/* Both: of a luminaire or a light. Dimming needs no new render where `separation` tells sources apart (ups_render.h). */
UPS_API ups_status ups_scene_set_luminaire_transform(ups_scene *scene, ups_luminaire_id id, const double to_world[12]);
UPS_API ups_status ups_scene_set_dimming(ups_scene *scene, ups_luminaire_id id, float dimming);
/* Multiplies the flux of every luminaire and fixture, so that all readings are maintained ones (EN 12464-1; CIE 97):
 * above 0, at most 1, at first 1. Lights and emitting surfaces keep theirs, of which a warning tells. */
UPS_API ups_status ups_scene_set_maintenance_factor(ups_scene *scene, double factor);

/* desc->texels is NULL: ups_scene_read_texture has them. */
UPS_API ups_status ups_scene_get_texture(const ups_scene *scene, ups_texture_id id, ups_texture_desc *desc);
/* width * height * channel_count floats, tight. *needed gets their number; BUFFER_TOO_SMALL where capacity is less.
 * texels may be NULL with capacity 0. */
UPS_API ups_status ups_scene_read_texture(const ups_scene *scene, ups_texture_id id, float *texels, size_t capacity,
                                          size_t *needed);
UPS_API ups_status ups_scene_get_material(const ups_scene *scene, ups_material_id id, ups_material_desc *desc);
UPS_API ups_status ups_scene_get_mesh(const ups_scene *scene, ups_mesh_id id, ups_mesh_desc *desc);
UPS_API ups_status ups_scene_get_instance(const ups_scene *scene, ups_instance_id id, ups_instance_desc *desc);
UPS_API ups_status ups_scene_get_light(const ups_scene *scene, ups_luminaire_id id, ups_light_desc *desc);
/* desc->profile is NULL: ups_scene_get_luminaire_profile has it. color_rgb has luminance 1. */
UPS_API ups_status ups_scene_get_luminaire(const ups_scene *scene, ups_luminaire_id id, ups_luminaire_desc *desc);
/* A handle of its own to the same profile; the caller owns *out. */
UPS_API ups_status ups_scene_get_luminaire_profile(const ups_scene *scene, ups_luminaire_id id, ups_profile **out);
UPS_API ups_status ups_scene_get_dimming(const ups_scene *scene, ups_luminaire_id id, float *out);
UPS_API ups_status ups_scene_get_maintenance_factor(const ups_scene *scene, double *out);

/* Each fails where something still has it: a material the texture, a mesh the material, an instance the mesh. A set of
 * meters on surfaces fails at the next commit where one of its instances was removed. A fixture whose part was removed is
 * set, and removed, without it; what something else has of a fixture's meshes and materials stays when that is removed.
 * A thing that was removed gives its memory back. Its number is never used again: where many at a time come and go, less
 * than a byte is left of each, and a commit takes less than a nanosecond for it. */
UPS_API ups_status ups_scene_remove_texture(ups_scene *scene, ups_texture_id id);
UPS_API ups_status ups_scene_remove_material(ups_scene *scene, ups_material_id id);
UPS_API ups_status ups_scene_remove_mesh(ups_scene *scene, ups_mesh_id id);
UPS_API ups_status ups_scene_remove_instance(ups_scene *scene, ups_instance_id id);
UPS_API ups_status ups_scene_remove_luminaire(ups_scene *scene, ups_luminaire_id id); /* or light */
UPS_API ups_status ups_scene_remove_sensor(ups_scene *scene, ups_sensor_id id);

/* ---- commit ---- */

/* Validates, analyses which effects the scene can show, builds what rendering reads. Renders already running keep the
 * earlier build. Only what the edits since the last commit touch is built anew, with the same bits as if all were:
 *   nothing changed              nothing
 *   dimming, colour, flux        the emitters, and the choice among them
 *   luminaires and lights moved  the same, and where their light arrives first
 *   sensors                      those that were set
 *   an instance moved            where it is: the index of its own triangles, with those of small neighbours, but for a
 *                                large mesh or a shared one, and the index above all; where light arrives first, and
 *                                what lies on surfaces, is found again
 *   a mesh                       its index, and what a moved instance wants
 *   a material, a texture        its tables; geometry where it begins to have holes or to emit
 * What reaches beyond all else, so that the scene's size leaves its power of two, may move the centre that coordinates
 * count from: then all is built. Warnings that need a search of all surfaces (triangles that lie on one another or have
 * no area, glass that overlaps, light that is swallowed) are found at the first commit, and after edits of the geometry
 * when somebody reads the scene's warnings, and results that are taken later have them too; the log has those of the
 * first commit alone.
 * Places are held in floats about the scene's middle, to 2^-24 of its width. In scenes of tens of kilometres a warning
 * names surfaces that are left out: those so far from all luminaires and sensors that they are smaller than an arc
 * minute from there, as long as they neither shine nor are measured and there is neither parallel light nor a
 * goniometer. What then still makes the scene too wide for the rest is named by a warning, too, which says so where
 * readings are wrong: where places are known to a centimetre at best, and what shines and measures, or most of the
 * scene, lies within a 2^16th of the width.
 * OUT_OF_MEMORY, too, where the index of surfaces wants more than the machine has free or the process's control groups
 * allow: the scene then renders as before. */
UPS_API ups_status ups_scene_commit(ups_scene *scene);
/* The same on a thread of the library: poll, wait for, cancel and destroy the job as a render's (ups_render.h);
 * ups_progress.fraction tells how far it is, iterations_done stays 0, and the functions that ask for a render's findings
 * answer INVALID_STATE. It commits the scene as it is at this call; edits go on meanwhile and belong to the next commit.
 * The scene renders as before until the job has ended OK; cancelled or failed it stays so. One at a time:
 * INVALID_STATE while another commit of the scene runs. Destroying the job cancels it. */
UPS_API ups_status ups_scene_start_commit(ups_scene *scene, ups_job **out);

typedef struct ups_commit_desc {
  uint32_t struct_size;
  uint32_t thread_limit; /* at most so many processors at a time; 0, or more than the context's threads: all of these.
                          * With it, or with a low priority, the job has threads of its own beside the context's, which
                          * other jobs keep to themselves */
  ups_priority priority;
  uint32_t reserved;     /* 0 */
  uint64_t memory_limit_bytes; /* that an index of surfaces may take beside those of earlier commits; 0, and beside it:
                                * what the machine has free and the process's control groups allow. Reached, the job is
                                * OUT_OF_MEMORY, and the scene renders as before. Copies of meshes are not counted */
} ups_commit_desc;
UPS_API void ups_commit_desc_init(ups_commit_desc *desc, uint32_t struct_size);
/* As ups_scene_start_commit, which has the defaults; the same bits on any number of threads. INVALID_ARGUMENT: priority
 * is no UPS_PRIORITY_*, reserved is not 0. */
UPS_API ups_status ups_scene_start_commit_with(ups_scene *scene, const ups_commit_desc *desc, ups_job **out);
/* 1: there are edits that no commit has taken, or there was none; 0: what renders is what was described. */
UPS_API ups_status ups_scene_is_dirty(const ups_scene *scene, int32_t *out);

/* Bit set. A bit that is clear is an effect that this scene cannot show, and that no time is spent on. */
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
  uint32_t effects;        /* UPS_EFFECT_*, found by ups_scene_commit */
  uint32_t techniques;     /* UPS_TECHNIQUE_* that those effects leave useful: what UPS_METHOD_AUTO runs */
  int32_t method;          /* UPS_METHOD_* that UPS_METHOD_AUTO stands for */
  uint64_t triangle_count; /* instances expanded */
  uint64_t luminaire_count, light_count, emissive_instance_count;
  uint64_t meter_count, pixel_count;
  double emitted_flux_lm;
  double bounds_min_m[3], bounds_max_m[3]; /* of all geometry; min > max without any */
  double maintenance_factor;
  uint64_t revision; /* of the scene that was committed: another after each commit of edits, and in each scene of the
                      * process. A result that has the same in its ups_result_info is of it */
} ups_scene_info;

typedef int32_t ups_scene_text;
enum { UPS_SCENE_TEXT_WARNINGS = 0, UPS_SCENE_TEXT_EFFECTS = 1, UPS_SCENE_TEXT_TECHNIQUES = 2 };

/* Both need a committed scene, else INVALID_STATE. info->struct_size must be set. */
UPS_API ups_status ups_scene_get_info(const ups_scene *scene, ups_scene_info *info);
/* For people, a line each: warnings; each effect with its cause; each technique with the reason it is on or off. */
UPS_API ups_status ups_scene_get_text(const ups_scene *scene, ups_scene_text topic, char *text, size_t capacity,
                                      size_t *needed);

/* Where a plane cuts the surfaces of the committed scene: what a plan and a section are drawn from. */
typedef struct ups_segment { /* a plain array element: it never grows */
  double from_m[3], to_m[3];
} ups_segment;
/* One segment for each triangle that reaches from one side of the plane to the other, or stands on it by an edge, on the
 * side that the normal points to; those that lie within it have none. normal: any length > 0. *needed gets their number;
 * BUFFER_TOO_SMALL where capacity is less. segments may be NULL with capacity 0. */
UPS_API ups_status ups_scene_read_section(const ups_scene *scene, const double point_m[3], const double normal[3],
                                          ups_segment *segments, size_t capacity, size_t *needed);
/* What a plan shows of the things beneath a plane: edges between it and depth_m beneath it (against the normal), where
 * a surface ends, folds by more than 30 degrees, or turns away from who looks from the plane against its normal; without
 * the pieces that surfaces between them and the plane hide. Each keeps its own height. depth_m > 0; infinite: all.
 * Otherwise as ups_scene_read_section. */
UPS_API ups_status ups_scene_read_outlines(const ups_scene *scene, const double point_m[3], const double normal[3],
                                           double depth_m, ups_segment *segments, size_t capacity, size_t *needed);

#endif
