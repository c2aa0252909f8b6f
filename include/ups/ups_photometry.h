/* UPS: luminous intensity distributions of luminaires: parse, build, query, write. */
#ifndef UPS_PHOTOMETRY_H
#define UPS_PHOTOMETRY_H

#include "ups_base.h"

typedef int32_t ups_profile_format;
enum {
  UPS_PROFILE_AUTO = 0,           /* recognised by its content */
  UPS_PROFILE_IES_LM63 = 1,       /* .ies: editions 1986 to 2019, photometric types A, B and C */
  UPS_PROFILE_EULUMDAT = 2,       /* .ldt */
  UPS_PROFILE_TM33_XML = 3,       /* .xml: TM-33, UNI 11733 */
  UPS_PROFILE_TM25_RAYS = 4,      /* .tm25ray */
  UPS_PROFILE_ZEMAX_RAYS = 5,     /* .sdf, .dat */
  UPS_PROFILE_LIGHTTOOLS_RAYS = 6 /* .ray */
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

/* How the planes of the file repeat. */
typedef int32_t ups_profile_symmetry;
enum {
  UPS_SYMMETRY_NONE = 0,
  UPS_SYMMETRY_AXIAL = 1,     /* one plane for all C */
  UPS_SYMMETRY_C0_C180 = 2,   /* mirror plane C0-C180 */
  UPS_SYMMETRY_C90_C270 = 3,  /* mirror plane C90-C270 */
  UPS_SYMMETRY_QUADRANTS = 4  /* both */
};

/* How the file tabulates directions. Profiles answer in C-gamma terms for all: the forward direction (0, 0) of types A
 * and B is the nadir, up is C0, right (seen along forward) is C270. */
typedef int32_t ups_photometric_type;
enum { UPS_PHOTOMETRIC_C = 0, UPS_PHOTOMETRIC_B = 1, UPS_PHOTOMETRIC_A = 2 };

/* Tabulated intensities in C-planes: direction (sin g cos C, sin g sin C, -cos g); gamma 0 is the nadir, local -Z. */
typedef struct ups_profile_desc {
  uint32_t struct_size;
  uint32_t c_count, gamma_count; /* >= 1, >= 2; at most 4,000,000 values together */
  uint32_t reserved;             /* 0 */
  const float *c_deg;            /* c_count, ascending, in [0, 360), from 0; a single plane, at any angle,
                                  * is axially symmetric */
  const float *gamma_deg;        /* gamma_count, ascending, in [0, 180]; outside its range the intensity is 0 */
  const float *intensity_cd;     /* c_count * gamma_count, gamma fastest, finite, >= 0 */
  ups_opening_shape opening_shape;
  float opening_m[3];            /* luminous opening along local x, y, z, >= 0; point: not read */
  int32_t opening_axis;          /* of a cylinder: 0 x, 1 y, 2 z (default) */
  float input_power_w;           /* < 0: not stated (default) */
} ups_profile_desc;

/* A file and how to read it. */
typedef struct ups_profile_parse_desc {
  uint32_t struct_size;
  ups_profile_format format;
  const void *bytes;        /* of the file */
  size_t size;
  const void *tilt_file;    /* optional: bytes of the file that TILT= names in an IES file
                             * (UPS_PROFILE_TEXT_TILT_FILE) */
  size_t tilt_file_size;
  float tilt_deg;           /* >= 0: intensities times the TILT factor at this tilt of the luminaire;
                             * < 0: none (default) */
  uint32_t lamp_set;        /* of an EULUMDAT file, whose lamp sets are alternatives; from 0 */
} ups_profile_parse_desc;

typedef struct ups_profile_info {
  uint32_t struct_size;
  uint32_t warning_count;            /* texts: ups_profile_get_text */
  double flux_lm;                    /* by the band rule: vertical bands, planes by trapezoid; of rays: their sum */
  double interpolated_flux_lm;       /* of the interpolated intensity that is sampled */
  double rated_flux_lm;              /* lamp lumens that the file states; < 0: absolute photometry */
  double input_power_w;              /* < 0: not stated */
  float peak_cd;
  float peak_c_deg, peak_gamma_deg;  /* direction of the peak */
  float opening_m[3];                /* luminous opening along local x, y, z; 0: point */
  ups_opening_shape opening_shape;   /* a rectangle of one extent alone is a line */
  ups_profile_symmetry symmetry;
  uint32_t c_count, gamma_count;     /* of the stored table, symmetry expanded; of type A planes H, rows V;
                                      * B planes V, rows H */
  ups_photometric_type photometric_type;
  uint32_t ray_count;                /* of a ray file, else 0 */
  double up_flux_lm, down_flux_lm;   /* above and below the horizon, together flux_lm */
  double light_output_ratio;         /* flux_lm / rated_flux_lm; < 0: not known, or the file states less for its lamps than
                                      * its intensities add up to */
  float beam_angle_deg[2];           /* where the intensity is half of the peak; planes C0-C180 and
                                      * C90-C270; < 0: nowhere */
  float field_angle_deg[2];          /* a tenth of the peak */
  int32_t opening_axis;              /* of a cylinder: 0 x, 1 y, 2 z */
  uint32_t lamp_set_count;           /* that the file states; at least 1 for a file that states lamps */
} ups_profile_info;

/* The lobe around the peak of one plane, which runs full circle: its angles are gamma on the half plane C, -gamma on
 * the half plane C + 180. */
typedef struct ups_profile_beam {
  uint32_t struct_size;
  float peak_cd, peak_deg;     /* of this plane; of equal peaks the one nearest to the nadir, then on the side of C */
  float from_deg, to_deg;      /* from_deg <= peak_deg <= to_deg; beyond +-180 where the lobe holds the zenith */
  float angle_deg;             /* to_deg - from_deg; < 0: nowhere below the level, or no light in this plane */
} ups_profile_beam;

/* A set of lamps that the file states. Of an EULUMDAT file all sets, which are alternatives; of an IES file its lamps,
 * one set; of a TM-33 file its emitters, which shine together. Their texts: UPS_PROFILE_TEXT_LAMP_*. */
typedef struct ups_profile_lamp_set {
  uint32_t struct_size;
  int32_t count;                /* of lamps; < 0: EULUMDAT's mark of absolute photometry; 0: not stated */
  double flux_lm;               /* of all its lamps; < 0: not stated */
  float input_power_w;          /* with gear; < 0: not stated */
  float colour_temperature_k;   /* correlated; < 0: the file states none */
  float colour_rendering_index; /* Ra, 0 to 100; < 0: the file states none, or a group such as 1B alone */
  int32_t chosen;               /* 1: the intensities hold for this set, else 0 */
} ups_profile_lamp_set;

typedef int32_t ups_profile_text;
enum {
  UPS_PROFILE_TEXT_WARNINGS = 0,
  UPS_PROFILE_TEXT_KEYWORDS = 1, /* "MANUFAC=...\n"; those of EULUMDAT have the names of LM-63 where there is one */
  UPS_PROFILE_TEXT_FORMAT = 2,   /* "IES LM-63-2002" */
  UPS_PROFILE_TEXT_TILT_FILE = 3, /* the name that TILT= has; empty: no file */
  UPS_PROFILE_TEXT_TILT_TABLE = 4, /* "15 0.95\n": degrees and the factor there, not applied; empty: no table */
  UPS_PROFILE_TEXT_LAMP_TYPES = 5, /* as the file has them, a line each lamp set, which may be empty */
  UPS_PROFILE_TEXT_LAMP_COLOURS = 6,   /* the same: colour appearance or temperature */
  UPS_PROFILE_TEXT_LAMP_RENDERINGS = 7 /* the same: colour rendering, an index or a group */
};

UPS_API void ups_profile_desc_init(ups_profile_desc *desc, uint32_t struct_size);
/* The caller owns *out. Errors: INVALID_ARGUMENT names the field. */
UPS_API ups_status ups_profile_create(ups_context *context, const ups_profile_desc *desc, ups_profile **out);
/* Parses the bytes of a photometric file. Errors: PARSE with the line; UNSUPPORTED names what is not built. */
UPS_API ups_status ups_profile_parse(ups_context *context, const void *bytes, size_t size, ups_profile_format format,
                                     ups_profile **out);
UPS_API void ups_profile_parse_desc_init(ups_profile_parse_desc *desc, uint32_t struct_size);
/* The same with a TILT file, a tilt, a lamp set. Errors: INVALID_ARGUMENT also where the file has no such lamp set. */
UPS_API ups_status ups_profile_parse_with(ups_context *context, const ups_profile_parse_desc *desc, ups_profile **out);
/* The text of a photometric file of the same distribution: IES_LM63 (LM-63-2019; types A and B as they are; reads back
 * to the same bits) or EULUMDAT (types A and B resampled onto C-planes; numbers and texts in the format's field lengths,
 * intensities of five digits or six). Two calls, as for ups_profile_get_text; the final zero is no part of the file.
 * Errors: UNSUPPORTED for other formats. */
UPS_API ups_status ups_profile_write(const ups_profile *profile, ups_profile_format format, char *bytes,
                                     size_t capacity, size_t *needed);
/* What the file that ups_profile_write makes does not hold as the profile has it, a line each, empty where there is
 * nothing: flux and peak, with both figures, where they part by more than 0.1 %; texts and sizes that its fields cut.
 * Two calls, as for ups_profile_get_text. Errors: UNSUPPORTED for formats that are not written. */
UPS_API ups_status ups_profile_get_write_warnings(const ups_profile *profile, ups_profile_format format, char *text,
                                                  size_t capacity, size_t *needed);
/* info->struct_size must be set; at most that many bytes are written. */
UPS_API ups_status ups_profile_get_info(const ups_profile *profile, ups_profile_info *info);
/* The lamp set of that index, below lamp_set_count of ups_profile_info. set->struct_size must be set; at most that many
 * bytes are written. Errors: INVALID_ARGUMENT where the file has no such lamp set. */
UPS_API ups_status ups_profile_get_lamp_set(const ups_profile *profile, uint32_t index, ups_profile_lamp_set *set);
/* Two calls: text NULL and capacity 0 give *needed (with the final zero), then the text. */
UPS_API ups_status ups_profile_get_text(const ups_profile *profile, ups_profile_text topic, char *text, size_t capacity,
                                        size_t *needed);
/* Values of the keyword of that name, such as "MANUFAC", in any case: a line each where there are several, empty where
 * there is none. Two calls, as for ups_profile_get_text. */
UPS_API ups_status ups_profile_get_keyword(const ups_profile *profile, const char *name, char *text, size_t capacity,
                                           size_t *needed);
/* A copy in which the keyword `name` (letters, digits, _; at most 64; kept in capitals) has this value alone, a line of
 * UTF-8, at most 1000 bytes, or "": for ups_profile_write. Both formats write TEST, MANUFAC, LUMCAT, LUMINAIRE and
 * ISSUEDATE, IES_LM63 any. The caller owns *out. Errors: INVALID_ARGUMENT. */
UPS_API ups_status ups_profile_with_keyword(const ups_profile *profile, const char *name, const char *value,
                                            ups_profile **out);
/* Interpolated intensity, cd, for count directions in the profile's frame (3 floats each, any length > 0). */
UPS_API ups_status ups_profile_eval(const ups_profile *profile, const float *directions_xyz, size_t count,
                                    float *intensity_cd);
/* Mean luminance of the luminous opening seen from count directions, cd/m^2: intensity / area of its silhouette. < 0:
 * the opening is a point, or flat and seen edge on. Directions as for ups_profile_eval. */
UPS_API ups_status ups_profile_get_luminance(const ups_profile *profile, const float *directions_xyz, size_t count,
                                             float *luminance_cd_m2);
/* Flux by the band rule between count ascending gamma angles, degrees, in [0, 180]: count - 1 values, lm. A band of the
 * table across an edge is parted by solid angle; tables of type A and B are parted as their interpolated intensity
 * is. */
UPS_API ups_status ups_profile_get_zonal_flux(const ups_profile *profile, const float *gamma_deg, size_t count,
                                              double *flux_lm);
/* Where the interpolated intensity first falls below `fraction` of the plane's peak, on both sides of it;
 * 0 < fraction <= 1. 0.5 gives the beam angle (ANSI/IES LS-1: 50 % of the maximum; CIE's half-peak divergence), 0.1 the
 * field angle. Plane: C / C + 180, c_deg finite. beam->struct_size must be set. */
UPS_API ups_status ups_profile_get_beam(const ups_profile *profile, float c_deg, float fraction,
                                        ups_profile_beam *beam);
UPS_API void ups_profile_destroy(ups_profile *profile); /* NULL ok */

#endif
