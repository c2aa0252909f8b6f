/* UPS: glare, and what else a luminaire's data sheet says: unified glare rating (UGR) at observers in a scene, UGR
 * tables of luminaires, CIE flux code, luminance limits, spacing criterion, NEMA type, BUG rating, utilisation factors.
 */
#ifndef UPS_GLARE_H
#define UPS_GLARE_H

#include "ups_photometry.h"
#include "ups_render.h"
#include "ups_sensor.h"

/* How much a source troubles by where it stands in the field of view. */
typedef int32_t ups_position_index;
enum {
  UPS_POSITION_INDEX_TABLE = 0, /* the table of CIE 117:1995, bilinear: what UGR is defined with */
  UPS_POSITION_INDEX_GUTH = 1   /* Guth's in Levin's closed form: up to 12 % from the table */
};
/* The index of sources in count directions of the eye's frame (3 floats each, any length > 0), which looks along -Z, +Y
 * up: >= 1, or -1 where a source counts for nothing: behind the eye, or above the line of sight beyond the table (T/R
 * above 3, H/R above 1.9, its empty cells). Below the line of sight both kinds have Einhorn's formula. */
UPS_API ups_status ups_glare_get_position_index(ups_position_index kind, const float *directions_xyz, size_t count,
                                                float *index);
/* 8 log10(0.25 / background * sum of L^2 w / p^2) of count sources by their luminances, solid angles and position
 * indices; those with an index below 0 are left out. -1 where nothing is left. Errors: INVALID_ARGUMENT, also for a
 * background that is not above 0. */
UPS_API ups_status ups_glare_get_ugr(const float *luminance_cd_m2, const float *solid_angle_sr,
                                     const float *position_index, size_t count, double background_cd_m2, float *ugr);

/* ---- of a luminaire ---- */

/* The UGR table of CIE 190:2010: rooms by lengths across and along the view in units of H = 2 m, the height of the
 * luminaires above the eye, at the middle of a wall; spacing H / 4; five sets of reflectances. Crosswise is across the
 * longer side of the opening (square: C0 faces the eye, of IES files C90). The background is by the transfer method, but
 * with the direct light of the array itself. Ratings are for the lamps' flux; those for 1000 lm, as uncorrected tables
 * have, are lower by 8 log10(lamp_flux_lm / 1000). -1: no luminaire that counts sends light to the eye. */
typedef struct ups_ugr_table {
  uint32_t struct_size;
  float lamp_flux_lm;           /* that the file states; of absolute photometry, and where it states less
                                 * than the luminaire's flux, that flux */
  float room_across_h[19], room_along_h[19];
  float reflectances[15];       /* ceiling, walls, floor of each of the 5 sets */
  float crosswise[95];          /* room * 5 + set */
  float endwise[95];
} ups_ugr_table;
/* table->struct_size must be set. Errors: UNSUPPORTED where the profile has no luminous opening with an area,
 * INVALID_ARGUMENT where it has no flux. */
UPS_API ups_status ups_profile_get_ugr_table(const ups_profile *profile, ups_ugr_table *table);

typedef struct ups_data_sheet {
  uint32_t struct_size;
  float flux_code[5];             /* CIE 52: per cent of the downward flux within 41.4, 60 and 75.5 deg; of the flux
                                   * downwards; light output ratio (100 of absolute photometry) */
  float luminance_cd_m2[3];       /* highest over all planes at 65, 75 and 85 deg; < 0: no opening with an area */
  float highest_luminance_cd_m2;  /* from 65 to 85 deg, the last angle of EN 13032-2, and where */
  float highest_luminance_c_deg, highest_luminance_gamma_deg;
  float spacing_criterion[3];     /* of the IES: planes C0-C180 and C90-C270, diagonal of a square; < 0: none */
  int32_t nema_horizontal, nema_vertical; /* type 1 to 7 by the field angle in C90-C270, C0-C180; 0: none */
  /* IES TM-15-11: zones of flux in front and behind, to 30, 60, 80 and 90 deg, above to 100 and 180 deg; ratings 0 to
   * 5; glare by the limits of types V (bug_type_v 1: symmetric to both planes, or round) or of types I to IV */
  float front_lm[4], back_lm[4], up_lm[2];
  int32_t backlight_rating, uplight_rating, glare_rating, bug_type_v;
} ups_data_sheet;
/* front_c_deg: where the front of an outdoor luminaire faces: C0 by the custom of IES files, C90 by that of EULUMDAT.
 * sheet->struct_size must be set. */
UPS_API ups_status ups_profile_get_data_sheet(const ups_profile *profile, float front_c_deg, ups_data_sheet *sheet);

/* Utilisation factors of square rooms whose luminaires are spread evenly over the ceiling: the part of the lamps' flux
 * (the luminaire's, of absolute photometry) that reaches the reference plane, by the transfer method of CIE 52. */
typedef struct ups_utilisation_table {
  uint32_t struct_size;
  float room_index[10];
  float reflectances[30]; /* ceiling, walls, floor of each of the 10 sets */
  float factors[100];     /* room * 10 + set */
} ups_utilisation_table;
/* table->struct_size must be set. Errors: INVALID_ARGUMENT where the profile has no flux. */
UPS_API ups_status ups_profile_get_utilisation(const ups_profile *profile, ups_utilisation_table *table);

/* ---- at an observer ---- */

typedef int32_t ups_glare_metric;
enum { UPS_GLARE_METRIC_UGR = 0 };
/* An eye. It is rendered with all other sensors, as a planar meter that faces the line of sight: its readings can be
 * read as those of a meter set of one. They count among the errors that targets and predictions are of only where there
 * are neither meters nor cameras. */
typedef struct ups_observer_desc {
  uint32_t struct_size;
  ups_glare_metric metric;
  ups_position_index position_index;
  float ceiling_area_m2; /* of the room, for the rating of large sources; 0: the scene's extent in x times y */
  double to_world[12];   /* looks along local -Z, local +Y is up; scale is ignored */
} ups_observer_desc;
UPS_API void ups_observer_desc_init(ups_observer_desc *desc, uint32_t struct_size);
UPS_API ups_status ups_scene_add_observer(ups_scene *scene, const ups_observer_desc *desc, ups_sensor_id *out);
/* By the rules of ups_scene.h. */
UPS_API ups_status ups_scene_set_observer(ups_scene *scene, ups_sensor_id id, const ups_observer_desc *desc);
UPS_API ups_status ups_scene_get_observer(const ups_scene *scene, ups_sensor_id id, ups_observer_desc *desc);

/* What an observer's rating leaves out or stands on, bit by bit. */
enum {
  UPS_OBSERVER_NO_SOURCE = 1,        /* no source of glare is visible: no rating */
  UPS_OBSERVER_NO_BACKGROUND = 2,    /* no indirect light was found at the eye: no rating */
  UPS_OBSERVER_LARGE_SOURCE = 4,     /* a source above 0.1 sr, for which UGR is too low; rated as others. See ggr */
  UPS_OBSERVER_POINT_SOURCE = 8,     /* a source without extent, rated as a small one */
  UPS_OBSERVER_UNRATED_SOURCE = 16,  /* a directional light, the rays of a file, or light beyond what
                                      * numbers hold: in no rating */
  UPS_OBSERVER_FIXTURE = 32,         /* a fixture is in view: what its own reflectors, lenses and covers send counts as
                                      * background, so the rating is too low. Measure it with a goniometer and place
                                      * that profile */
  UPS_OBSERVER_COVERED_SOURCE = 64   /* 5 % or more of a source in view is behind glass or a diffuser that is no thin
                                      * pane: what these send counts as background, so the rating is too low */
};
/* UGR = 8 log10(0.25 / L_b * sum of L^2 w / p^2). L_b is the eye's indirect illuminance over pi, without what comes
 * straight from sources. Sources are luminaires and lights, each by its intensity over the area of its opening as the
 * eye sees it, and instances that emit; each is one source, weakened by panes and media, and by the share of it that
 * other things hide (by 256 rays, by 64 where it is less than a quarter of the worst and all or none of them arrive).
 * Parts of an instance that stand apart, as panels of one mesh, by more than a quarter of the smaller one's size and
 * 10 cm, are rated each by its own place in view, and added up. So are the pieces of a surface that stretches far, as
 * a luminous ceiling or a line of light: its position index is that of them together; what is out of view adds nothing.
 * One that looks smaller than 0.005 m^2, or has no extent, counts 200 I^2 / (r^2 p^2) (CIE 147).
 * Of the scene as it is rendered: with a maintenance factor M, 8 log10(1 / M) below what its luminaires rate new. */
typedef struct ups_observer_reading {
  uint32_t struct_size;
  uint32_t flags;                   /* UPS_OBSERVER_* */
  float ugr;                        /* -1 with NO_SOURCE or NO_BACKGROUND, else as it is: below 10 and even below 0 */
  float ugr_standard_error;         /* of background and hidden shares; -1: not known */
  float ugr_low, ugr_high;          /* 95 %, noise and bias, and what rays may have missed; -1: not known, or ugr_high
                                     * without an end. With NO_SOURCE ugr_high is -1 where none is in view, else the
                                     * most that those may rate which no ray has seen; infinite where nothing ends it */
  float background_cd_m2;
  float background_standard_error_cd_m2, background_error_bound_cd_m2; /* the latter 95 %, bias too; -1: not known */
  uint32_t source_count;            /* that count in the rating */
  float ceiling_coverage;           /* 0 to 1: the area of sources above 1.5 m^2 that the eye sees where it turns
                                     * round, as seen from below, over the ceiling's; 0: none is in view, or none
                                     * that covers any of it, such as a luminous wall */
  float ggr;                        /* the rating with such sources by CIE 147: from coverages of 0.15 on above UGR's
                                     * where much light falls straight on the eye; -1 where ceiling_coverage is 0 */
  float ggr_low, ggr_high;          /* 95 %, noise and bias; -1: not known, or ggr_high without an end */
} ups_observer_reading;
/* reading->struct_size must be set. */
UPS_API ups_status ups_result_get_observer(const ups_result *result, ups_sensor_id observer,
                                           ups_observer_reading *reading);

enum {
  UPS_GLARE_FLAG_SMALL = 1,  /* looks smaller than 0.005 m^2, hidden parts included */
  UPS_GLARE_FLAG_POINT = 2,  /* without extent: no luminance */
  UPS_GLARE_FLAG_LARGE = 4,  /* above 0.1 sr */
  UPS_GLARE_FLAG_HIDDEN = 8  /* in part */
};
typedef struct ups_glare_source {
  uint32_t struct_size;
  ups_source_kind kind;        /* UPS_SOURCE_LUMINAIRE or _INSTANCE */
  uint32_t id;                 /* the v of its ups_luminaire_id or ups_instance_id */
  uint32_t flags;              /* UPS_GLARE_FLAG_* */
  float luminance_cd_m2;       /* mean of what is visible, panes included; -1: a point */
  float solid_angle_sr;        /* of what is visible; 0: a point */
  float intensity_cd;          /* of what is visible, towards the eye */
  float distance_m;            /* of its centre */
  float visible_share;         /* of its light, panes apart */
  float position_index;
  float share;                 /* of the sum of L^2 w / p^2 */
  float direction[3];          /* from the eye to its centre, unit, world */
} ups_glare_source;
/* index < source_count, the worst first; source->struct_size must be set. */
UPS_API ups_status ups_result_get_glare_source(const ups_result *result, ups_sensor_id observer, uint32_t index,
                                               ups_glare_source *source);

#endif
