/* UPS: what every other header needs: export macro, version, status, handles, ids, context, log.
 *
 * Rules that hold for every function of the library
 *   - Units are SI and photometric: m, rad, cd, lm, lx, cd/m^2. A field that carries a unit says so in its name.
 *   - Right-handed, +Z up. Transforms are 3x4, row-major, object to world.
 *   - Pointers passed in are read during the call and never kept. Strings are UTF-8, zero-terminated.
 *   - A function that can fail returns ups_status; outputs come last and are untouched on failure.
 *   - No function calls back into the application.
 *   - Zero is the null id. An id belongs to the scene that handed it out: its low 24 bits number the things of a kind
 *     from 1, in the order in which they were added, which is how messages name them ("luminaire 3"); the bits above
 *     tell the scene. Other scenes, and results of other scenes, refuse it with UPS_ERROR_INVALID_ARGUMENT. Scenes that
 *     exist at the same time, or of which a result does, share those bits only when there are more than 255; then an id
 *     of one may pass for that of another. A scene holds at most 2^24 - 1 things of a kind (UPS_ERROR_UNSUPPORTED).
 *   - A handle that another copy of the library made, loaded into the same process, is refused with
 *     UPS_ERROR_INVALID_ARGUMENT; functions that return nothing leave it alone. So are handles that were destroyed, as
 *     far as their memory still tells: do not rely on it.
 *   - Exhausted memory, or a thread that cannot be started, is UPS_ERROR_OUT_OF_MEMORY: nothing is held, and the call
 *     works once there is memory again. Some things are beyond the library: oneTBB, which Embree builds with, ends the
 *     process where it has no memory to note that an allocation within a build failed; to be safe have its allocator
 *     library libtbbmalloc installed, which it loads by itself and takes such memory from. Embree's own assertions can
 *     end the process where all memory fails within the index of a commit after an edit of geometry. OpenColorIO, Cairo
 *     and the extras' JSON reader do too; what they take is asked for before they are called, but other threads may take
 *     it. And Linux may grant memory that it does not have, and end the process that writes to it: renders and
 *     commits ask first what there is, but two at a time may ask for the same.
 *   - After fork() the child has handles of its own, from a context that it creates itself. Of those that it has from
 *     its parent it may call _destroy alone, which leaves them and their memory to the end of the process.
 *   - The library prints nothing. Its threads are named "ups/...", block all signals but those of faults (SIGSEGV,
 *     SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS), and end with the last handle that needs them.
 *   - Results do not depend on the calling thread's rounding mode, nor on whether it flushes subnormal numbers to zero:
 *     every call computes with C's default environment and gives the caller its own back.
 *   - 64-bit targets only, so every struct has one layout and no hidden padding.
 *   - Destroying children and parents may happen in any order: a child keeps what it needs alive.
 *
 * Which calls may run at once, on any threads
 *                          with others on the same handle           with others on its children, its parent
 *   ups_context            all                                      all
 *   ups_profile            all                                      all
 *   ups_fixture            const ones; else one call at a time      ups_scene_add_fixture reads it
 *   ups_scene              const ones, which ups_render and         all: its jobs and results are on their own, and go on
 *                          ups_job_start are; else one at a time    with what was committed when they started
 *   ups_job, ups_result    all                                      all
 *   ups_path, ups_gltf_import, ups_exr_image: as ups_result
 *   without a handle       all: ups_last_error is each thread's own
 * A _destroy comes last: nothing else may run on that handle, or come after. Const calls are those whose handle is const
 * in the declaration. Two renders of one scene at once share its build and the context's threads; each finds the same
 * bits as alone. A commit, too, may run beside renders that were started before: as a job (ups_scene_start_commit) beside
 * edits and new renders of the scene as well.
 */
#ifndef UPS_BASE_H
#define UPS_BASE_H

#include <stddef.h>
#include <stdint.h>

#if defined(UPS_STATIC)
#define UPS_EXPORT
#elif defined(_WIN32) && defined(UPS_BUILD)
#define UPS_EXPORT __declspec(dllexport)
#elif defined(_WIN32)
#define UPS_EXPORT __declspec(dllimport)
#else
#define UPS_EXPORT __attribute__((visibility("default")))
#endif
#ifdef __cplusplus
#define UPS_API extern "C" UPS_EXPORT
#else
#define UPS_API UPS_EXPORT
#endif

#define UPS_VERSION_MAJOR 0
#define UPS_VERSION_MINOR 1
#define UPS_VERSION_PATCH 0

/* Enumerations are int32_t in every signature and struct, so their size never depends on a compiler. */
typedef int32_t ups_status;
enum {
  UPS_OK = 0,
  UPS_ERROR_INTERNAL = -1,
  UPS_ERROR_INVALID_ARGUMENT = -2,
  UPS_ERROR_INVALID_STATE = -3,    /* right call, wrong time: e.g. a render of an uncommitted scene */
  UPS_ERROR_OUT_OF_MEMORY = -4,
  UPS_ERROR_PARSE = -5,            /* malformed photometry or scene bytes */
  UPS_ERROR_UNSUPPORTED = -6,      /* well-formed, but this version cannot do it */
  UPS_ERROR_BUFFER_TOO_SMALL = -7, /* *needed tells how much */
  UPS_ERROR_IO = -8,               /* extras only; the core opens no files */
  UPS_TIMEOUT = 1,                 /* not a failure: wait ran out of time */
  UPS_CANCELLED = 2                /* not a failure: results hold every finished iteration */
};

typedef struct ups_context ups_context; /* threads and log; thread-safe */
typedef struct ups_profile ups_profile; /* one luminous intensity distribution; immutable, thread-safe */
typedef struct ups_scene ups_scene;     /* description; many threads read, or one changes it */
typedef struct ups_job ups_job;         /* a render or commit on the library's own threads; thread-safe */
typedef struct ups_result ups_result;   /* what a render has found so far: immutable, any thread */

typedef struct { uint32_t v; } ups_texture_id;
typedef struct { uint32_t v; } ups_material_id;
typedef struct { uint32_t v; } ups_mesh_id;
typedef struct { uint32_t v; } ups_instance_id;
typedef struct { uint32_t v; } ups_luminaire_id;
typedef struct { uint32_t v; } ups_sensor_id;

/* Of a job. LOW: the operating system runs its threads when nothing else on the machine wants the processor (Linux: nice
 * 19). */
typedef int32_t ups_priority;
enum { UPS_PRIORITY_NORMAL = 0, UPS_PRIORITY_LOW = 1 };

/* Version of the loaded library: major*10000 + minor*100 + patch. */
UPS_API uint32_t ups_version(void);
/* Name of a status, such as "UPS_ERROR_PARSE"; static, never NULL. */
UPS_API const char *ups_status_name(ups_status status);
/* This thread's last failure, for people: what was wrong, where, what would be right.
 * Never NULL; empty before the first failure; valid until this thread's next failing call. */
UPS_API const char *ups_last_error(void);

/* Every *_desc starts with struct_size and is filled with defaults by its *_init, which writes at most struct_size
 * bytes:
 *   ups_mesh_desc d; ups_mesh_desc_init(&d, sizeof d); d.positions_m = ...;
 * The library reads at most d.struct_size bytes and takes its own defaults for the rest. A struct of a later version is
 * longer than the library knows: what is beyond its own must be 0, as *_init leaves it; where it is not, a field is set
 * that this version would ignore, and the call fails with UPS_ERROR_UNSUPPORTED. struct_size is at most 4096. */

typedef struct ups_context_desc {
  uint32_t struct_size;
  int32_t thread_count; /* 0: as many as there are processors for this process; at most 1024. More than there are
                         * processors: as many as these, which the log tells. A job has a thread of its own that works
                         * with the context's others: a job alone keeps thread_count processors busy. */
} ups_context_desc;

typedef int32_t ups_log_level;
enum { UPS_LOG_INFO = 0, UPS_LOG_WARNING = 1 };

UPS_API void ups_context_desc_init(ups_context_desc *desc, uint32_t struct_size);
/* desc may be NULL: all defaults. The caller owns *out. */
UPS_API ups_status ups_context_create(const ups_context_desc *desc, ups_context **out);
UPS_API void ups_context_destroy(ups_context *context); /* NULL ok */
/* As many as run. */
UPS_API ups_status ups_context_get_thread_count(const ups_context *context, int32_t *out);
/* Takes the oldest log message. text may be NULL with capacity 0 to ask for the size: *needed gets the bytes with the
 * final zero, 0 when the log is empty. The message is removed only when it was copied whole. level may be NULL. */
UPS_API ups_status ups_context_pop_log(ups_context *context, char *text, size_t capacity, size_t *needed,
                                       ups_log_level *level);

#endif
