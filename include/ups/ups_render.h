/* UPS: render a committed scene; jobs; results. */
#ifndef UPS_RENDER_H
#define UPS_RENDER_H

#include "ups_base.h"

/* A named set of techniques; UPS_METHOD_AUTO lets the scene decide. */
typedef int32_t ups_method;
enum {
  UPS_METHOD_AUTO = 0,
  UPS_METHOD_UPS = 1,
  UPS_METHOD_PATH_TRACING = 2,
  UPS_METHOD_LIGHT_TRACING = 3,
  UPS_METHOD_BIDIRECTIONAL = 4,
  UPS_METHOD_PPM = 5,  /* progressive photon mapping (Hachisuka et al. 2008):
                        * merges at the first diffuse or glossy point */
  UPS_METHOD_SPPM = 6, /* stochastic PPM (Hachisuka, Jensen 2009): glossy points are passed,
                        * merges at the first other one */
  UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING = 7 /* Vorba 2011: merges at every point of an eye path, weighted */
};

enum {
  UPS_TECHNIQUE_EMITTER_HIT = 1,    /* an eye path runs into an emitter */
  UPS_TECHNIQUE_LIGHT_SAMPLE = 2,   /* next-event estimation */
  UPS_TECHNIQUE_CONNECT = 4,        /* an edge between two subpaths */
  UPS_TECHNIQUE_SENSOR_CONNECT = 8, /* an edge from a light path to a camera */
  UPS_TECHNIQUE_MERGE = 16,         /* photon density estimation at eye vertices and meters */
  UPS_TECHNIQUE_SENSOR_HIT = 32,    /* a light path lands on a meter's cell */
  UPS_TECHNIQUE_MIRROR_SAMPLE = 64  /* next-event estimation by way of a flat mirror or pane; not without
                                     * LIGHT_SAMPLE */
};

/* Path integration in the extended path space of the paper (Hachisuka, Pantaleoni, Jensen 2012, section 3). */
typedef int32_t ups_perturbation;
enum {
  UPS_PERTURBATION_VIRTUAL = 0, /* the perturbed vertex is the eye path's own: counted in the weights alone */
  UPS_PERTURBATION_ACTUAL = 1   /* it is drawn from the kernel around the eye path's vertex: as biased as merging is; to
                                 * test the former by; that bias is in no error. Next-event estimation and connections
                                 * alone; a camera's illuminance stays virtual. Where the method does not merge,
                                 * merge_radius_m must be set */
};

/* Readings of meters for each source of light apart, from one render: illuminance is linear in dimming. */
typedef int32_t ups_separation;
enum {
  UPS_SEPARATE_NOTHING = 0,
  UPS_SEPARATE_LUMINAIRES = 1, /* each luminaire, light and emissive instance */
  UPS_SEPARATE_GROUPS = 2      /* by the `group` of their descs */
};

/* Which relative error of the sensors is judged by the target: error_bound / max(E, 5 % of its set's mean) of a meter,
 * the same of a pixel's luminance and its image. */
typedef int32_t ups_criterion;
enum {
  UPS_CRITERION_DEFAULT = 0, /* the worst meter; without meters the mean over pixels that light
                              * has reached */
  UPS_CRITERION_WORST = 1,   /* of all meters, without meters of all pixels */
  UPS_CRITERION_P95 = 2,     /* 95 % of them are better */
  UPS_CRITERION_MEAN = 3,
  UPS_CRITERION_MEDIAN = 4
};

typedef struct ups_render_desc {
  uint32_t struct_size;
  ups_method method;
  uint64_t seed;                      /* same seed and iterations, same bits, whatever the thread count */
  double time_limit_s;                /* 0: none. From the start of the call; overrun by at most 0.1 s or 5 %,
                                       * whichever is more, but where millions of light paths an iteration were asked
                                       * for, whose memory is given back first, or the limit is too short for one
                                       * iteration and reading what it found, as of millions of pixels with images of
                                       * each technique. An iteration that it cuts off leaves no trace */
  float target_relative_error;        /* stop when the relative error that target_criterion says is below: by default
                                       * the worst meter's error_bound / max(E, 5 % of its set's mean), without meters
                                       * the mean pixel's, of those that light has reached; without cameras too a
                                       * goniometer's, whatever the criterion: the noise of its nodes, 95 %, in the mean
                                       * over the light; 0: off. The error is looked at after 16, 20, 25, 32, ...
                                       * (steps of 1.25) visits of all meters; without meters from 4 visits of all
                                       * pixels and 16 iterations on. Against stopping by luck two looks one after the
                                       * other must find it below, the second no sooner than after 32 visits. An
                                       * observer's eye counts as a meter where there are neither meters nor cameras */
  float merge_radius_m;               /* of pixels and walks the first one; of point meters the widest disc, from
                                       * whose rings each reading takes as many as serve it best. 0: from the scene,
                                       * whose diameter is the most */
  uint32_t iteration_count;           /* 0: until a limit or the target is met */
  uint32_t max_path_length;           /* edges; 0: none, roulette ends paths without bias */
  uint32_t light_paths_per_iteration; /* a power of two, or rounded up to one, at most 2^24; auto may still trace none.
                                       * 0: chosen by the library */
  uint32_t techniques;                /* UPS_TECHNIQUE_* to allow; 0: those of the method */
  float radius_alpha;                 /* (0, 1): r_(i+1)^2 = r_i^2 (i + alpha) / (i + 1), but for point meters'
                                       * discs; 0: 2/3, where UPS falls fastest */
  float glossy_alpha;                 /* SPPM passes metal and rough glass of a GGX alpha below; 0: 0.2 */
  ups_perturbation perturbation;
  uint32_t technique_images;          /* cameras: an image of each technique for paths of up to so many edges, at
                                       * most 16; 0: none. See ups_result_get_technique_count */
  ups_separation separation;          /* see ups_result_get_source_count */
  uint32_t reserved;                  /* 0 */
  uint64_t flux_paths;                /* light paths, rounded up to a power of two, at most 2^24, that find the absorbed
                                       * and escaped flux where the method traces none, or for caustics alone; where it
                                       * traces all light these cost nothing and this is not read. A part after each
                                       * iteration, the rest at the end, within elapsed_s and a fifth of the time limit,
                                       * or what the iterations leave of it: fewer where that is too short. 0: none; that
                                       * flux is not known then, and what shading normals lose that lean is told as of
                                       * light that is even everywhere */
  ups_criterion target_criterion;     /* of target_relative_error and of predictions */
  uint32_t reserved2;                 /* 0 */
  uint64_t memory_limit_bytes;        /* that the committed scene and the render may take together, as
                                       * ups_memory_estimate counts them; 0: what the machine has free and the process's
                                       * control groups leave, which is never exceeded either */
  uint32_t thread_limit;              /* at most so many processors at a time; 0, or more than the context's threads:
                                       * all of these. With it, or with a low priority, the job has threads of its own
                                       * beside the context's, which other jobs keep to themselves. */
  ups_priority priority;
} ups_render_desc; /* at least one of time limit, target, iteration count must be set */

typedef int32_t ups_job_state;
enum { UPS_JOB_RUNNING = 0, UPS_JOB_FINISHED = 1, UPS_JOB_CANCELLED = 2, UPS_JOB_FAILED = 3 };

typedef struct ups_progress {
  uint32_t struct_size;
  ups_job_state state;
  double elapsed_s, remaining_s; /* remaining: expected, by the limits and the error so far; < 0: unknown */
  uint32_t iterations_done;
  float fraction;                /* [0, 1] of the time to the limit or the target that will be met first; never falls */
  float worst_relative_error, median_relative_error; /* < 0: unknown yet */
} ups_progress;

typedef struct ups_result_info {
  uint32_t struct_size;
  uint32_t iterations;
  double elapsed_s;           /* rendering alone: all of its preparations, iterations and flux_paths */
  uint64_t rays, light_paths, eye_paths, merges, connections;
  double emitted_flux_lm, absorbed_flux_lm, escaped_flux_lm; /* the balance that a designer can check; absorbed and
                                                              * escaped < 0: not known, see flux_paths of the desc */
  uint64_t seed;
  uint64_t dropped_samples;   /* non-finite samples left out, never silently: UPS_TEXT_DROPPED has the reasons,
                               * and where the first of each was */
  ups_method method;          /* that ran; never AUTO */
  uint32_t techniques;        /* UPS_TECHNIQUE_* that ran */
  uint32_t effects;           /* UPS_EFFECT_* of the scene */
  int32_t threads;
  double flux_balance_standard_error_lm; /* of emitted - absorbed - escaped, which is 0 but for chance, rounding and
                                          * what max_path_length cuts off; < 0: not known. Where more is missing than by
                                          * chance, UPS_TEXT_WARNINGS says so: by mistake once in 10,000 renders. What
                                          * shading normals or grazing angles keep from going on is absorbed; whether a
                                          * material returns more than it gets is not told. What eye paths carry is
                                          * balanced likewise in every render, whatever its method, which
                                          * UPS_TEXT_WARNINGS alone tells of */
  double maintenance_factor;              /* of the scene: that its luminaires' flux is multiplied by */
  uint64_t revision;                      /* of the scene that was rendered, as in its ups_scene_info then */
} ups_result_info;

/* Plain array elements: these never grow. < 0 where not known (too few iterations). Of more than 32768 meters an
 * iteration visits each third, fifth, ... in turn; before its first visit nothing is known of a meter.
 * Light that no path has found, or that few have, is not known to be dark: until half of the 16 batches have any, the
 * standard error is -1, and the bound is that of the rule of three and its continuation: the most that one path may
 * bring, times 3.00, 3.74, 4.30, ... after 0, 1, 2, ... paths, over the iterations. Where photons are merged, the bound
 * of a point meter has besides what light by way of specular and glossy surfaces alone (caustics) may bring, told in the
 * same way while fewer than 8 photons have brought such light: it would hide among other light; and, as long as they
 * are few, what it would be where they lie close together. */
typedef struct ups_meter_reading {
  float illuminance_lx;    /* of a vector meter the vector's length, which noise makes longer */
  float standard_error_lx; /* noise alone; of a length that of the component along it */
  float bias_lx;           /* estimated, of density estimation; of a length also what noise across it adds */
  float error_bound_lx;    /* 95 %, noise and bias together */
  float direct_lx, indirect_lx; /* of a vector meter the lengths of these parts' own vectors: not their sum's parts */
} ups_meter_reading;

/* The light vector, integral L(w) w dw over the whole sphere, w towards the light, in the world's x, y, z; each
 * component with its standard error (noise alone) and 95 % bound. Never grows; errors < 0 where not known: as of
 * ups_meter_reading. */
typedef struct ups_vector_reading {
  float vector_lx[3], standard_error_lx[3], error_bound_lx[3];
} ups_vector_reading;

typedef struct ups_meter_part_reading { /* never grows; < 0 where not known */
  float illuminance_lx;
  float standard_error_lx; /* noise alone; -1 and a bound: as of ups_meter_reading */
  float bias_lx;           /* of the whole reading, where photons may have brought this part of it */
  float error_bound_lx;    /* 95 %, noise and bias together */
} ups_meter_part_reading;

typedef struct ups_vector_part_reading { /* of a light vector, by component; never grows; < 0 where not known but of
                                          * vector_lx and bias_lx, which have a sign */
  float vector_lx[3];
  float standard_error_lx[3]; /* as of ups_meter_part_reading, as all below */
  float bias_lx[3];
  float error_bound_lx[3];
} ups_vector_part_reading;

/* What a reading's error is worth, bit by bit; 0: an interval of 16 batches, as it should be. */
enum {
  UPS_READING_EXACT = 1,       /* no chance in it: the error is that of rounding */
  UPS_READING_UNKNOWN = 2,     /* too few iterations: no error is known */
  UPS_READING_FEW_PATHS = 4,   /* none or few have found light: standard error -1, bound by the rule of three */
  UPS_READING_SINGLE_PATH = 8, /* interval unreliable: one path brought more than a tenth of its batch and a quarter of
                                * the variance */
  UPS_READING_HEAVY_TAIL = 16  /* interval unreliable: the kurtosis of the batches is above 7.1, as that of one in 1000
                                * of Gaussian ones is */
};

typedef struct ups_convergence_point { /* what accuracy cost */
  double elapsed_s;
  uint32_t iterations, reserved;
  float median_relative_error, p95_relative_error, worst_relative_error, bias_share;
} ups_convergence_point;

/* Of one meter set; aggregates have their own batch statistics, as meters share light paths. */
typedef struct ups_meter_statistics {
  uint32_t struct_size;
  uint32_t count;                /* of the set's meters; those that are not valid have no part in what follows */
  double mean_lx, min_lx, max_lx; /* each meter counts the same in the mean, one on a surface by its area */
  double uniformity;             /* min / mean; 0 where the mean is 0, -1: not known */
  double mean_standard_error_lx; /* of the mean */
  /* -1: not known, as in too short a render, or where the scene emits light and none has reached the set */
  double median_relative_error_bound, p95_relative_error_bound, worst_relative_error_bound;
  double mean_bias_lx;           /* of the mean, estimated */
  double mean_error_bound_lx;    /* of the mean: 95 %, its noise and bias, and light that was not found */
  /* 95 % intervals of the true values, noise and bias; -1: not known (before 6 visits of all meters; uniformity and
   * diversity also where the mean's bound is more than half of it). The least of noisy readings is biased low, the
   * largest high: an interval need not lie evenly about its value. */
  double min_low_lx, min_high_lx, max_low_lx, max_high_lx, uniformity_low, uniformity_high;
  double percentile_5_lx;        /* 5 % of the meters are below; of those on a surface 5 % of their area */
  double percentile_5_low_lx, percentile_5_high_lx;
  double diversity;              /* min / max (EN 12193's U1); 0 where the maximum is 0, -1: not known */
  double diversity_low, diversity_high;
} ups_meter_statistics;

/* What accuracy cost: one look at the error. Errors are relative, over all meters, without meters over all pixels or a
 * goniometer's nodes. A render that was not cancelled looks once more at its end where the last look came before 90 %
 * of its iterations and there is time. */
typedef struct ups_curve_point {
  uint32_t struct_size;
  uint32_t iterations;
  double elapsed_s;
  float median_relative_error, p95_relative_error, worst_relative_error, mean_relative_error;
  float bias_share;                         /* of the meters' bounds: estimated bias; 0 without meters */
  uint32_t reserved;                        /* 0 */
  uint64_t rays, light_paths, eye_paths;    /* so far; without flux_paths */
  uint64_t resident_bytes;                  /* memory of the process, all that it does; 0: not known */
} ups_curve_point;

/* What keeps an error up. */
typedef int32_t ups_limit;
enum { UPS_LIMIT_UNKNOWN = 0 /* no look at the error yet */, UPS_LIMIT_NOISE = 1, UPS_LIMIT_BIAS = 2 };
/* When the error by ups_render_desc.target_criterion is small enough: what a look at it is expected to find. From all
 * looks so far; the first comes after 16 visits of all meters (see ups_render_desc.target_relative_error). A render with
 * that target ends at the second such look. Once a look found the error met, as all after it, the times are that
 * look's. */
typedef struct ups_prediction {
  uint32_t struct_size;
  ups_limit limited_by;             /* at that time */
  double seconds;                   /* from the render's start, in all; -1: never at this rate, or after more than
                                     * 10^7 s, or UPS_LIMIT_UNKNOWN */
  double seconds_low, seconds_high; /* 95 % interval, iterations as fast as they were: it holds that 16 batches know a
                                     * standard error to 18 %, and how surely the rate is known; -1 as above */
  double iterations;                /* at `seconds`; -1 where that is */
} ups_prediction;

/* The meter that had the largest relative error at the last look; an observer's eye where there are no meters. */
typedef struct ups_largest_error {
  uint32_t struct_size;
  ups_sensor_id sensor;
  uint32_t index;     /* within the set */
  float relative_error, bias_share; /* bias_share: estimated bias / bound */
  uint32_t reserved;  /* 0 */
  double position_m[3];
} ups_largest_error;

UPS_API void ups_render_desc_init(ups_render_desc *desc, uint32_t struct_size);

/* What a render will take. Bytes that it allocates, of which the machine may have to give fewer; without what results
 * take that the caller keeps. Measured peaks are within 0.7 and 1.3 times the estimate; where no iteration_count says
 * how long a render is, that is of one in which each pixel has been visited 16 times, after which no more is taken. */
typedef struct ups_memory_estimate {
  uint32_t struct_size;
  uint32_t reserved;       /* 0 */
  uint64_t scene_bytes;    /* of the committed scene, which are taken already */
  uint64_t working_bytes;  /* while it renders: sums of all sensors, and what an iteration finds */
  uint64_t light_bytes;    /* the part of them that light paths take */
  uint64_t result_bytes;   /* of a ups_result */
  uint64_t peak_bytes;     /* in all, at most at a time: of scene, render and result */
  uint64_t allowed_bytes;  /* for peak_bytes, by memory_limit_bytes, the machine and the control groups as it is now */
} ups_memory_estimate;
/* Prepares a render as ups_render would, with the pilot that chooses techniques, and renders nothing: it takes as long
 * as that; where the least that it takes is too much, it says so at once, and where its pilot wants more than is
 * allowed, which it does not get, peak_bytes is what that wanted at least; without a limit it is all of it.
 * out->struct_size must be set. OK then, too. */
UPS_API ups_status ups_scene_estimate_memory(const ups_scene *scene, const ups_render_desc *desc,
                                             ups_memory_estimate *out);

/* Blocks until a limit or the target. The one call that a small program needs; for progress and cancel start a job.
 * INVALID_STATE where the time limit was over before the first iteration was done. OUT_OF_MEMORY before the first
 * iteration where more is wanted than allowed (memory_limit_bytes), and later where light paths become more or longer
 * than expected; the message says what is wanted and what would be right. As a guide: a camera takes up to 300 bytes a
 * pixel, 60 at first and 12 more with each of the first 16 visits of all pixels (`illuminance`: 100 more;
 * technique_images: 96 more for each image), a meter up to 6000, of many meters and where no photons are merged less,
 * for each source of `separation` 5000 more. Where the scene has edits that were not committed, it is rendered as it was
 * at the last commit; UPS_TEXT_WARNINGS says so. */
UPS_API ups_status ups_render(const ups_scene *scene, const ups_render_desc *desc, ups_result **out);

/* The same, without blocking: start, then poll or wait from any thread. Where it is clear at once that too much memory
 * is wanted it does not start; a choice of techniques that wants too much ends the job before its first iteration. */
UPS_API ups_status ups_job_start(const ups_scene *scene, const ups_render_desc *desc, ups_job **out);
/* At once, whatever goes on; progress->struct_size must be set. */
UPS_API ups_status ups_job_poll(const ups_job *job, ups_progress *progress);
/* OK, UPS_TIMEOUT, UPS_CANCELLED or the job's error. */
UPS_API ups_status ups_job_wait(const ups_job *job, uint32_t timeout_ms);
/* At once, as ups_job_poll, of all looks at the error so far; the same of a result further below. relative_error: a
 * finite number > 0, 0.01 is 1 %. prediction->struct_size must be set. */
UPS_API ups_status ups_job_get_prediction(const ups_job *job, double relative_error, ups_prediction *prediction);
/* Of the render that runs, from the end of its preparations on, before INVALID_STATE; out->struct_size must be set. */
UPS_API ups_status ups_job_get_memory_estimate(const ups_job *job, ups_memory_estimate *out);
UPS_API ups_status ups_job_get_curve_count(const ups_job *job, uint32_t *out);
/* index < count, in the order of time; point->struct_size must be set. */
UPS_API ups_status ups_job_get_curve_point(const ups_job *job, uint32_t index, ups_curve_point *point);
/* error->struct_size must be set; INVALID_STATE before the first look and without meters. */
UPS_API ups_status ups_job_get_largest_error(const ups_job *job, ups_largest_error *error);
UPS_API void ups_job_cancel(ups_job *job); /* asks; returns at once; NULL ok */
/* What is there after the last whole iteration, also of a job that failed, but where there was no memory to add an
 * iteration to it; INVALID_STATE before the first. The render goes on meanwhile, but with technique_images.
 * OUT_OF_MEMORY while it renders and the memory that is allowed leaves no room for a result beside it: after its end
 * there is. The caller owns *out. */
UPS_API ups_status ups_job_result(const ups_job *job, ups_result **out);
UPS_API void ups_job_destroy(ups_job *job); /* cancels and joins; NULL ok */

/* Results are copied into the caller's memory, but by ups_result_view_*. info->struct_size must be set. */
UPS_API ups_status ups_result_get_info(const ups_result *result, ups_result_info *info);
/* How the light of one sensor is found, as UPS_METHOD_AUTO chose for it or as the method says. */
typedef int32_t ups_photons;
enum {
  UPS_PHOTONS_NONE = 0,
  UPS_PHOTONS_CAUSTIC = 1, /* merged only where a light path has met mirrors, glass and gloss alone */
  UPS_PHOTONS_ALL = 2
};
typedef struct ups_sensor_choice {
  uint32_t struct_size;
  uint32_t techniques;                /* UPS_TECHNIQUE_* that some part of the sensor takes */
  uint32_t light_paths_per_iteration; /* of the render, for all sensors that take any; 0: none are traced */
  ups_photons photons;                /* in some part of the sensor */
  double predicted_gain;              /* in efficiency, 1 / (variance x counted operations), over all techniques that
                                       * were weighed; one sensor may lose where all together gain. 1 where nothing was
                                       * chosen: the method or its techniques were asked for, there is a goniometer, or
                                       * no choice would have gained much; and where the pilot saw no noise */
} ups_sensor_choice;
/* Of a camera, a meter set or a goniometer; choice->struct_size must be set. */
UPS_API ups_status ups_result_get_choice(const ups_result *result, ups_sensor_id sensor, ups_sensor_choice *choice);
/* count must be the set's meter count. */
UPS_API ups_status ups_result_read_meters(const ups_result *result, ups_sensor_id sensor, ups_meter_reading *out,
                                          size_t count);
/* What ups_result_read_meters copies, without a copy: *readings gets where the result has it, *count how many they are.
 * They stay as they are until ups_result_destroy. */
UPS_API ups_status ups_result_view_meters(const ups_result *result, ups_sensor_id sensor,
                                          const ups_meter_reading **readings, size_t *count);
/* Of a set of kind UPS_METER_VECTOR; so is ups_result_read_vector_part. */
UPS_API ups_status ups_result_read_vectors(const ups_result *result, ups_sensor_id sensor, ups_vector_reading *out,
                                           size_t count);
/* The part that came straight from emitters, the rest, and both together, each with an error of its own. */
typedef int32_t ups_light_part;
enum { UPS_LIGHT_PART_DIRECT = 0, UPS_LIGHT_PART_INDIRECT = 1, UPS_LIGHT_PART_ALL = 2 };
UPS_API ups_status ups_result_read_meter_part(const ups_result *result, ups_sensor_id sensor, ups_light_part part,
                                              ups_meter_part_reading *out, size_t count);
UPS_API ups_status ups_result_read_vector_part(const ups_result *result, ups_sensor_id sensor, ups_light_part part,
                                               ups_vector_part_reading *out, size_t count);
/* UPS_READING_* of each meter. */
UPS_API ups_status ups_result_read_meter_flags(const ups_result *result, ups_sensor_id sensor, uint32_t *out,
                                               size_t count);
UPS_API ups_status ups_result_get_meter_statistics(const ups_result *result, ups_sensor_id sensor,
                                                   ups_meter_statistics *out);
/* The sources that ups_render_desc.separation tells apart; those that emit nothing are among them, with readings
 * of 0. */
typedef int32_t ups_source_kind;
enum { UPS_SOURCE_LUMINAIRE = 0 /* a luminaire or a light */, UPS_SOURCE_INSTANCE = 1, UPS_SOURCE_GROUP = 2 };
typedef struct ups_source_info {
  uint32_t struct_size;
  ups_source_kind kind;
  uint32_t id;       /* the v of its ups_luminaire_id or ups_instance_id, or the group */
  uint32_t reserved; /* 0 */
  double flux_lm;    /* as it was rendered, dimming included */
} ups_source_info;
UPS_API ups_status ups_result_get_source_count(const ups_result *result, uint32_t *out); /* 0 without separation */
/* index < count; info->struct_size must be set. */
UPS_API ups_status ups_result_get_source(const ups_result *result, uint32_t index, ups_source_info *info);
/* What the source contributes to each meter of the set; over all sources these add up to ups_result_read_meters, but
 * for a vector's lengths. With other dimmings they are weighed by dimming / dimming as rendered before they are added,
 * and no render is needed: so render what may be lit with a dimming above 0. Standard errors and bounds of such a sum are
 * at most the sums of theirs, weighed likewise. */
UPS_API ups_status ups_result_read_source_meters(const ups_result *result, uint32_t source, ups_sensor_id sensor,
                                                 ups_meter_reading *out, size_t count);
/* What a committed scene has that may emit: for plans and schedules of luminaires. In the order of
 * UPS_SEPARATE_LUMINAIRES. */
typedef struct ups_scene_source {
  uint32_t struct_size;
  ups_source_kind kind;    /* a luminaire or light, or an instance */
  uint32_t id, group;      /* id: the v of its ups_luminaire_id or ups_instance_id */
  int32_t light_kind;      /* UPS_LIGHT_* of a light; -1: a luminaire or an instance */
  uint32_t maintained;     /* 1: flux_lm has the scene's maintenance factor in it, as a luminaire's and a fixture's has; 0:
                            * it has not, as of lights and luminous surfaces */
  double flux_lm;          /* as it is rendered, dimming included; 0: it emits nothing */
  double to_world[12];     /* as it was added */
  double bounds_min_m[3], bounds_max_m[3]; /* of the opening that it emits from or of its surface; of what has no extent
                                            * its place */
} ups_scene_source;
UPS_API ups_status ups_scene_get_source_count(const ups_scene *scene, uint32_t *out);
/* index < count; source->struct_size must be set. */
UPS_API ups_status ups_scene_get_source(const ups_scene *scene, uint32_t index, ups_scene_source *source);
/* The profile that a luminaire was added with; the caller owns *out. INVALID_ARGUMENT for lights and instances. */
UPS_API ups_status ups_scene_get_source_profile(const ups_scene *scene, uint32_t index, ups_profile **out);

/* Of one goniometer. */
typedef struct ups_goniometer_info {
  uint32_t struct_size;
  uint32_t c_count, gamma_count, reserved;
  double flux_lm, flux_standard_error_lm;  /* of all light that left the scene; < 0: not known */
  double outside_flux_lm;                  /* part of it beyond the range of gamma; in no reading */
  double emitted_flux_lm, absorbed_flux_lm; /* what the sources emit; emitted = absorbed + flux, but for noise */
  double light_output_ratio, light_output_ratio_standard_error; /* flux / emitted */
  double worst_relative_error_bound, median_relative_error_bound; /* of bound / max(I, 5 % of the peak), the median
                                                                   * of nodes with light; < 0: not known */
} ups_goniometer_info;
typedef struct ups_intensity_reading { /* never grows; < 0 where not known */
  float intensity_cd;
  float standard_error_cd; /* noise alone; -1 and a bound: as of ups_meter_reading */
  float bias_cd;           /* estimated, of the mean over the node's surroundings */
  float error_bound_cd;    /* 95 %, noise and bias together */
} ups_intensity_reading;
UPS_API ups_status ups_result_get_goniometer_info(const ups_result *result, ups_sensor_id sensor,
                                                  ups_goniometer_info *info);
/* count = c_count * gamma_count, gamma fastest; symmetry expanded. */
UPS_API ups_status ups_result_read_goniometer(const ups_result *result, ups_sensor_id sensor,
                                              ups_intensity_reading *out, size_t count);
/* The grid, as it was asked for or in equal steps. */
UPS_API ups_status ups_result_get_goniometer_angles(const ups_result *result, ups_sensor_id sensor, float *c_deg,
                                                    size_t c_count, float *gamma_deg, size_t gamma_count);
/* A beam or field angle of the distribution, as of ups_profile_get_beam, with its error. */
typedef struct ups_goniometer_beam {
  uint32_t struct_size;
  float angle_deg;            /* < 0: nowhere below the level, or no light in this plane */
  float standard_error_deg;   /* noise alone; < 0 here and below: not known */
  float bias_deg;             /* estimated, of the mean over the nodes' surroundings; 0 where not known */
  float low_deg, high_deg;    /* 95 % interval, noise and bias; a side that ends before the node beside the peak may be
                               * of any width down to 0 */
} ups_goniometer_beam;
/* c_deg finite, 0 < fraction <= 1; beam->struct_size must be set. */
UPS_API ups_status ups_result_get_goniometer_beam(const ups_result *result, ups_sensor_id sensor, float c_deg,
                                                  float fraction, ups_goniometer_beam *beam);
/* The distribution as a profile, with the opening of the desc, rated for the emitted flux: for luminaires and for
 * ups_profile_write. What the scene's maintenance factor takes is taken from it, too: measure with a factor of 1. The
 * caller owns *out. */
UPS_API ups_status ups_result_get_goniometer_profile(const ups_result *result, ups_sensor_id sensor, ups_profile **out);
typedef int32_t ups_channel;
enum {
  UPS_CHANNEL_LUMINANCE_RGB = 0,      /* 3 floats a pixel, cd/m^2 */
  UPS_CHANNEL_STANDARD_ERROR_RGB = 1, /* 3 floats a pixel; -1: not known, as where few paths or none have found light */
  UPS_CHANNEL_ILLUMINANCE = 2,        /* 1 float a pixel, lx; cameras with `illuminance` */
  /* Parts of LUMINANCE_RGB, which add up to it once every pixel was visited; with ups_render_desc.technique_images
   * alone */
  UPS_CHANNEL_PATH_INTEGRATION_RGB = 3,
  UPS_CHANNEL_DENSITY_ESTIMATION_RGB = 4,
  /* Of luminance, 1 float a pixel, cd/m^2: what merging photons within a radius has moved a pixel by, as estimated, mostly
   * noise where it is small; and the 95 % bound of noise and bias together, -1: not known. A bias that the pixel's own
   * photons do not tell from noise is that of the 8 x 8 pixels around it. Near mirrors, glass and gloss the bound
   * also holds what caustics may bring to the tile of 16 x 16 pixels and those beside it, as long as fewer than eight
   * photons of any were found there. */
  UPS_CHANNEL_BIAS = 5,
  UPS_CHANNEL_ERROR_BOUND = 6,
  /* 3 floats a pixel: LUMINANCE_RGB, but where single samples dominate a pixel a mean without the outermost batches of
   * its samples. Shows what bright specks hide; as a measured value it is too low. */
  UPS_CHANNEL_ROBUST_RGB = 7,
  UPS_CHANNEL_ILLUMINANCE_STANDARD_ERROR = 8, /* 1 float a pixel, lx; of ILLUMINANCE; -1: not known */
  /* Of cameras whose desc asks for these `layers`: means over those of the pixel's samples that met a surface. */
  UPS_CHANNEL_ALBEDO_RGB = 9, /* 3 floats: the material's reflectance as given, textured; a diffuser's with its
                               * transmittance; glass and panes 1; 0 where nothing was met */
  UPS_CHANNEL_NORMAL = 10,    /* 3 floats, x, y, z in the scene: of shading, towards the camera; a mean, so its length
                               * may be below 1; 0 where nothing was met */
  UPS_CHANNEL_DEPTH = 11,     /* 1 float, m from the camera's place, along the ray; -1 where nothing was met */
  UPS_CHANNEL_ID = 12,        /* 1 float: the lower 24 bits of the ups_instance_id.v at the pixel's centre; 0: nothing.
                               * 1 is the scene's first instance, 2 its second */
  /* What BIAS and ERROR_BOUND are of luminance, of ILLUMINANCE: 1 float a pixel, lx; a bound of -1: not known */
  UPS_CHANNEL_ILLUMINANCE_BIAS = 13,
  UPS_CHANNEL_ILLUMINANCE_ERROR_BOUND = 14
};
/* Row 0 is the image's top. row_stride_bytes 0: tight; size_bytes is the size of out. */
UPS_API ups_status ups_result_read_image(const ups_result *result, ups_sensor_id camera, ups_channel channel,
                                         float *out, size_t row_stride_bytes, size_t size_bytes);
/* What ups_result_read_image copies, without a copy: *pixels gets where the result has it, tight, *width and *height
 * how many there are. They stay as they are until ups_result_destroy. */
UPS_API ups_status ups_result_view_image(const ups_result *result, ups_sensor_id camera, ups_channel channel,
                                         const float **pixels, uint32_t *width, uint32_t *height);
/* What each technique found, for paths of up to ups_render_desc.technique_images edges; for people who look into the
 * estimator. The s vertices of a light path and the t of an eye path make a path of `edges` edges: s + t = edges + 1,
 * of density estimation, where both have a vertex at the same place, edges + 2. */
typedef struct ups_technique_info {
  uint32_t struct_size;
  uint32_t technique;      /* the UPS_TECHNIQUE_* that it is; MIRROR_SAMPLE is LIGHT_SAMPLE, its mirror a vertex of t */
  uint32_t light_vertices; /* s; 0: an emitter was hit, 1: next-event estimation */
  uint32_t eye_vertices;   /* t; 1: a light path was joined to the camera */
  uint32_t edges;
} ups_technique_info;
typedef int32_t ups_contribution;
enum {
  UPS_CONTRIBUTION_WEIGHTED = 0,  /* by multiple importance sampling: all of them add up to the image */
  UPS_CONTRIBUTION_UNWEIGHTED = 1 /* as if the technique were the only one:
                                   * each that can sample a path estimates it alone */
};
/* Images of a camera; 0 without technique_images. */
UPS_API ups_status ups_result_get_technique_count(const ups_result *result, ups_sensor_id camera, uint32_t *out);
/* index < count; info->struct_size must be set. */
UPS_API ups_status ups_result_get_technique(const ups_result *result, ups_sensor_id camera, uint32_t index,
                                            ups_technique_info *info);
/* 3 floats a pixel, cd/m^2; rows and sizes as in ups_result_read_image. */
UPS_API ups_status ups_result_read_technique(const ups_result *result, ups_sensor_id camera, uint32_t index,
                                             ups_contribution contribution, float *out, size_t row_stride_bytes,
                                             size_t size_bytes);
/* The part of the curve that there has always been.
 * *needed gets the number of points; BUFFER_TOO_SMALL where capacity is less. points may be NULL with capacity 0. */
UPS_API ups_status ups_result_read_convergence(const ups_result *result, ups_convergence_point *points, size_t capacity,
                                               size_t *needed);
/* As those of a job, of all looks before the result was taken. */
UPS_API ups_status ups_result_get_prediction(const ups_result *result, double relative_error,
                                             ups_prediction *prediction);
UPS_API ups_status ups_result_get_curve_count(const ups_result *result, uint32_t *out);
UPS_API ups_status ups_result_get_curve_point(const ups_result *result, uint32_t index, ups_curve_point *point);
UPS_API ups_status ups_result_get_largest_error(const ups_result *result, ups_largest_error *error);
/* For people. Two calls: text NULL and capacity 0 give *needed (with the final zero), then the text. */
typedef int32_t ups_result_text;
enum { UPS_TEXT_WARNINGS = 0, UPS_TEXT_EFFECTS = 1, UPS_TEXT_TECHNIQUES = 2, UPS_TEXT_DROPPED = 3 };
UPS_API ups_status ups_result_get_text(const ups_result *result, ups_result_text topic, char *text, size_t capacity,
                                       size_t *needed);
UPS_API void ups_result_destroy(ups_result *result); /* NULL ok */

#endif
