/* UPS: which samples weigh most in a result, and each of them traced again alone, with every vertex, density and weight:
 * where a bright speck comes from. */
#ifndef UPS_REPLAY_H
#define UPS_REPLAY_H

#include "ups_render.h"

typedef int32_t ups_walk;
enum { UPS_WALK_EYE = 0 /* from a meter or camera */, UPS_WALK_LIGHT = 1 /* from an emitter */ };

/* What one path brought to one meter or pixel in one iteration: an address that ups_replay traces again. A plain array
 * element: it never grows. */
typedef struct ups_sample {
  uint64_t seed;        /* of the render */
  ups_sensor_id sensor; /* a camera or meters */
  uint32_t index;       /* of the meter within its set; of the pixel, row by row from the top */
  uint32_t iteration;   /* from 0 */
  ups_walk walk;
  uint32_t path;        /* number of the iteration's light path, or of the meter's own eye path in it; of a pixel 0 */
  float value;          /* lx, cd/m^2 of luminance: of it the reading is the mean over the visits of the meter or pixel */
  float share;          /* that it makes of max(reading, 5 % of the mean of its set or image) */
  uint32_t reserved;    /* 0 */
} ups_sample;

/* The samples that weigh most in a camera's image or a set of meters: of every pixel or meter the largest, of these the
 * 64 of the largest share, the largest first. Not of UPS_CHANNEL_ILLUMINANCE. *needed gets their number;
 * BUFFER_TOO_SMALL where capacity is less. samples may be NULL with capacity 0. */
UPS_API ups_status ups_result_read_largest_samples(const ups_result *result, ups_sensor_id sensor, ups_sample *samples,
                                                   size_t capacity, size_t *needed);

typedef struct ups_path ups_path; /* a sample as it was traced again; immutable, any thread */

/* Traces the sample's iteration up to its path, that path alone, and the light paths that it was joined to: takes as long
 * as a pilot and one iteration. desc as of the render that the sample is of, but for its seed, limits, target and
 * flux_paths, which are not read; scene as it was committed then. Of `sample` value and share are not read.
 * INVALID_ARGUMENT where such a render traces no such path; OUT_OF_MEMORY where it wants more than memory_limit_bytes
 * allows, as ups_render. The caller owns *out. */
UPS_API ups_status ups_replay(const ups_scene *scene, const ups_render_desc *desc, const ups_sample *sample,
                              ups_path **out);
UPS_API void ups_path_destroy(ups_path *path); /* NULL ok */

typedef struct ups_path_info {
  uint32_t struct_size;
  uint32_t walks;     /* 1, and the light paths that its contributions were joined to, of the largest ones that make up
                       * 99 % of it, twelve at least and 1024 at most */
  /* lx, cd/m^2: the value of the sample. Of a light path the largest of its contributions, as it may bring several; of a
   * point meter's disc that of the whole disc, of which the reading may have taken the middle */
  double value;
  uint32_t contributions;
  uint32_t reserved;  /* 0 */
} ups_path_info;

typedef int32_t ups_path_event;
enum {
  UPS_EVENT_START = 0,       /* the emitter's point, the meter, the camera */
  UPS_EVENT_END = 1,         /* absorbed, ended by roulette, or by the method */
  UPS_EVENT_SCATTERED = 2,   /* by a lobe with a density: matte or rough */
  UPS_EVENT_MIRRORED = 3,    /* by a delta lobe: smooth metal, the face of glass or a pane */
  UPS_EVENT_REFRACTED = 4    /* through the face of glass */
};

/* Plain array elements: these never grow. */
typedef struct ups_path_vertex {
  double position_m[3];
  float normal[3];           /* geometric, unit; 0 of a camera and of an emitter without extent */
  float throughput;          /* luminance, after the event, roulette included; lm on a light path */
  float pdf, pdf_reverse;    /* of the event, and of the same backwards: per solid angle; of a delta lobe probabilities */
  float survival;            /* probability by which roulette let the walk go on */
  uint32_t walk;             /* 0: the sample's own; 1, 2, ...: a light path's */
  ups_instance_id instance;  /* 0: none */
  ups_path_event event;
} ups_path_vertex;

typedef struct ups_path_contribution {
  double from_m[3], to_m[3]; /* the edge that was made for it, of a mirror sample as far as the mirror; the same: none
                              * was */
  float value;               /* lx, cd/m^2: its part of the sample, weight included */
  float weight;              /* of multiple importance sampling */
  uint32_t technique;        /* UPS_TECHNIQUE_* */
  uint32_t edges;            /* of the whole path */
  uint32_t light_vertices;   /* of them, the emitter's included, by the light path; 0: an emitter was hit */
  uint32_t walk;             /* of ups_path_vertex, its light path; 0: none, or none that is listed */
  uint32_t light_path;       /* its number in the iteration; UINT32_MAX: none */
  ups_source_kind source_kind;
  uint32_t source;           /* id of the luminaire, light or instance whose light it is */
  uint32_t reserved;         /* 0 */
} ups_path_contribution;

/* info->struct_size must be set. */
UPS_API ups_status ups_path_get_info(const ups_path *path, ups_path_info *info);
/* Walk by walk, each from its start. *needed gets the number; vertices may be NULL with capacity 0. */
UPS_API ups_status ups_path_read_vertices(const ups_path *path, ups_path_vertex *vertices, size_t capacity,
                                          size_t *needed);
/* The largest first; the same way. They add up to an eye path's value. */
UPS_API ups_status ups_path_read_contributions(const ups_path *path, ups_path_contribution *contributions,
                                               size_t capacity, size_t *needed);
/* All that is known of the path, for people: a line a vertex, and the contributions that make up 99 % of it, twelve at
 * least and 1024 at most, with their weights and densities. Two calls: text NULL and capacity 0 give *needed (with the
 * final zero), then the text. */
UPS_API ups_status ups_path_get_text(const ups_path *path, char *text, size_t capacity, size_t *needed);

#endif
