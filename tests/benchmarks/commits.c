/* What a commit costs after each kind of edit, and how soon a new render is under way: a table for README.md.
 *
 *   ups_commit_benchmark [triangles, 3000000] [cpu]     cpu: commits by the processor time of all threads
 *
 * Scenes of that many triangles: in one mesh, with a small thing beside it, and in 5000 things of a mesh each; ten
 * luminaires with openings, 100 meters, a camera. Each edit is made and committed 15 times; the median counts. The
 * first edit has a row of its own, should it cost more than later ones. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "ups/ups.h"

#define MUST(call)                                                                                \
  do {                                                                                            \
    if ((call) < 0) fprintf(stderr, "%s: %s\n", #call, ups_last_error()), exit(1);                \
  } while (0)
enum { ROUNDS = 15, LUMINAIRES = 10, METERS = 100 };

typedef struct {
  ups_context *context;
  ups_scene *scene;
  ups_material_id material;
  ups_mesh_id thing_mesh;
  ups_instance_id thing, large; /* large: of the one mesh */
  ups_luminaire_id luminaires[LUMINAIRES];
  ups_sensor_id meters, camera;
  uint32_t thing_side;
  double first_s;
} hall;

static double now_s(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void place(double (*m)[12], double x, double y, double z) {
  const double at[12] = {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z};
  memcpy(*m, at, sizeof at);
}

/* A bumpy sheet of 2 * side^2 triangles, `size` wide. */
static ups_mesh_id add_sheet(hall *h, uint32_t side, float size, uint32_t seed) {
  const uint32_t n = side + 1;
  float *p = malloc(sizeof(float) * 3 * n * n);
  uint32_t *index = malloc(sizeof(uint32_t) * 6 * side * side), *next = index;
  for (uint32_t y = 0; y < n; ++y)
    for (uint32_t x = 0; x < n; ++x) {
      float *at = p + 3 * (y * n + x);
      at[0] = size * (float)x / (float)side, at[1] = size * (float)y / (float)side;
      at[2] = 0.05f * size * sinf(0.7f * (float)(x + seed)) * cosf(0.9f * (float)y);
    }
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const uint32_t a = y * n + x, quad[6] = {a, a + 1, a + n, a + 1, a + n + 1, a + n};
      memcpy(next, quad, sizeof quad);
      next += 6;
    }
  ups_mesh_desc d;
  ups_mesh_desc_init(&d, sizeof d);
  d.vertex_count = n * n, d.triangle_count = 2 * side * side;
  d.positions_m = p, d.indices = index, d.material = h->material;
  ups_mesh_id id;
  MUST(ups_scene_add_mesh(h->scene, &d, &id));
  free(p), free(index);
  return id;
}

static ups_instance_id add_instance(hall *h, ups_mesh_id mesh, double x, double y, double z) {
  ups_instance_desc d;
  ups_instance_desc_init(&d, sizeof d);
  d.mesh = mesh;
  place(&d.to_world, x, y, z);
  ups_instance_id id;
  MUST(ups_scene_add_instance(h->scene, &d, &id));
  return id;
}

static void add_lamps_and_sensors(hall *h) {
  const float gamma[3] = {0, 45, 90}, c = 0, intensity[3] = {1000, 700, 0};
  ups_profile_desc p;
  ups_profile_desc_init(&p, sizeof p);
  p.c_count = 1, p.gamma_count = 3, p.c_deg = &c, p.gamma_deg = gamma, p.intensity_cd = intensity;
  p.opening_shape = UPS_OPENING_RECTANGLE, p.opening_m[0] = p.opening_m[1] = 0.6f;
  ups_luminaire_desc l;
  ups_luminaire_desc_init(&l, sizeof l);
  ups_profile *profile;
  MUST(ups_profile_create(h->context, &p, &profile));
  l.profile = profile;
  for (int i = 0; i < LUMINAIRES; ++i) {
    place(&l.to_world, 5 + 10 * (i % 5), 12 + 25 * (i / 5), 6);
    MUST(ups_scene_add_luminaire(h->scene, &l, &h->luminaires[i]));
  }
  ups_profile_destroy(profile);
  double at[3 * METERS];
  float up[3 * METERS];
  for (int i = 0; i < METERS; ++i) {
    at[3 * i] = 2.5 + 5 * (i % 10), at[3 * i + 1] = 2.5 + 5 * (i / 10), at[3 * i + 2] = 3;
    up[3 * i] = up[3 * i + 1] = 0, up[3 * i + 2] = 1;
  }
  ups_meter_desc m;
  ups_meter_desc_init(&m, sizeof m);
  m.count = METERS, m.positions_m = at, m.normals = up;
  MUST(ups_scene_add_meters(h->scene, &m, &h->meters));
  ups_camera_desc camera;
  ups_camera_desc_init(&camera, sizeof camera);
  camera.width = camera.height = 64;
  place(&camera.to_world, 25, 25, 7);
  MUST(ups_scene_add_camera(h->scene, &camera, &h->camera));
}

static int by_cpu;
static double commit_now_s(void) {
  struct timespec t;
  if (!by_cpu) return now_s();
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
static double commit_s(hall *h) {
  const double start = commit_now_s();
  MUST(ups_scene_commit(h->scene));
  return commit_now_s() - start;
}

static hall make_hall(uint32_t triangles, uint32_t things) {
  hall h;
  memset(&h, 0, sizeof h);
  MUST(ups_context_create(NULL, &h.context));
  MUST(ups_scene_create(h.context, &h.scene));
  ups_material_desc material;
  ups_material_desc_init(&material, sizeof material);
  MUST(ups_scene_add_material(h.scene, &material, &h.material));
  const ups_mesh_id shell = add_sheet(&h, 8, 50, 0);
  add_instance(&h, shell, 0, 0, -1);
  add_instance(&h, shell, 0, 0, 8);
  if (things == 1) h.large = add_instance(&h, add_sheet(&h, (uint32_t)sqrt(triangles / 2.0), 50, 1), 0, 0, 0);
  h.thing_side = (uint32_t)sqrt(triangles / 2.0 / (things == 1 ? 5000 : things));
  for (uint32_t i = 0; i < (things == 1 ? 1 : things); ++i) {
    h.thing_mesh = add_sheet(&h, h.thing_side, 0.5f, i);
    h.thing = add_instance(&h, h.thing_mesh, 0.7 * (i % 70), 0.65 * (i / 70), 1);
  }
  add_lamps_and_sensors(&h);
  h.first_s = commit_s(&h);
  return h;
}

static void free_hall(hall *h) {
  ups_scene_destroy(h->scene);
  ups_context_destroy(h->context);
}

/* ---- edits ---- */

static void nothing(hall *h, int round) { (void)h, (void)round; }
static void dim(hall *h, int round) { MUST(ups_scene_set_dimming(h->scene, h->luminaires[3], 0.5f + 0.05f * round)); }
static void colour(hall *h, int round) {
  ups_luminaire_desc d;
  d.struct_size = sizeof d;
  MUST(ups_scene_get_luminaire(h->scene, h->luminaires[4], &d));
  d.color_rgb[0] = 1 + 0.1f * round, d.color_rgb[2] = 0.5f;
  MUST(ups_scene_set_luminaire(h->scene, h->luminaires[4], &d));
}
static void aim(hall *h, int round) {
  const double a = 0.05 * (round + 1), m[12] = {cos(a), 0, sin(a), 5, 0, 1, 0, 12, -sin(a), 0, cos(a), 6};
  MUST(ups_scene_set_luminaire_transform(h->scene, h->luminaires[0], m));
}
static void look(hall *h, int round) {
  ups_camera_desc d;
  d.struct_size = sizeof d;
  MUST(ups_scene_get_camera(h->scene, h->camera, &d));
  d.to_world[3] = 25 + 0.1 * round;
  MUST(ups_scene_set_camera(h->scene, h->camera, &d));
}
static void paint(hall *h, int round) {
  ups_material_desc d;
  d.struct_size = sizeof d;
  MUST(ups_scene_get_material(h->scene, h->material, &d));
  d.reflectance_rgb[0] = 0.3f + 0.02f * round;
  MUST(ups_scene_set_material(h->scene, h->material, &d));
}
static void move(hall *h, int round) {
  double m[12];
  place(&m, 20 + 0.3 * round, 20, 1.5);
  MUST(ups_scene_set_transform(h->scene, h->thing, m));
}
static void move_large(hall *h, int round) {
  double m[12];
  place(&m, 0.01 * round, 0, 0.02 * round);
  MUST(ups_scene_set_transform(h->scene, h->large, m));
}
static void bend(hall *h, int round) {
  ups_mesh_desc d;
  d.struct_size = sizeof d;
  MUST(ups_scene_get_mesh(h->scene, h->thing_mesh, &d));
  float *p = malloc(sizeof(float) * 3 * d.vertex_count);
  memcpy(p, d.positions_m, sizeof(float) * 3 * d.vertex_count);
  p[2] = 0.01f * (float)round;
  MUST(ups_scene_set_mesh_vertices(h->scene, h->thing_mesh, p, NULL, d.vertex_count));
  free(p);
}
static void replace(hall *h, int round) {
  (void)round;
  MUST(ups_scene_remove_instance(h->scene, h->thing));
  h->thing = add_instance(h, h->thing_mesh, 21, 22, 1);
}

static int by_size(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return x < y ? -1 : x > y;
}
static double median(double *values) {
  qsort(values, ROUNDS, sizeof *values, &by_size);
  return values[ROUNDS / 2];
}
static double measure(hall *h, void (*edit)(hall *, int)) {
  double s[ROUNDS];
  for (int round = 0; round < ROUNDS; ++round) {
    edit(h, round);
    s[round] = commit_s(h);
  }
  return 1000 * median(s);
}

/* From the end of a commit until ups_job_start has returned, until the first iteration begins (the job knows its memory
 * when all is prepared), and until it has ended. */
enum { STARTED, PREPARED, FIRST, TIMES };
static void measure_start(hall *h, ups_method method, double out_ms[TIMES]) {
  double s[TIMES][ROUNDS];
  ups_render_desc d;
  ups_render_desc_init(&d, sizeof d);
  d.method = method, d.iteration_count = 1;
  for (int round = 0; round < ROUNDS; ++round) {
    move(h, round);
    commit_s(h);
    const double start = now_s();
    ups_job *job;
    MUST(ups_job_start(h->scene, &d, &job));
    s[STARTED][round] = now_s() - start;
    ups_memory_estimate memory;
    memory.struct_size = sizeof memory;
    while (ups_job_get_memory_estimate(job, &memory) == UPS_ERROR_INVALID_STATE) {
      const struct timespec nap = {0, 100000};
      nanosleep(&nap, NULL);
    }
    s[PREPARED][round] = now_s() - start;
    while (ups_job_wait(job, 1000) == UPS_TIMEOUT) {}
    s[FIRST][round] = now_s() - start;
    ups_job_destroy(job);
  }
  for (int t = 0; t < TIMES; ++t) out_ms[t] = 1000 * median(s[t]);
}

typedef struct {
  const char *name;
  void (*edit)(hall *, int);
  int of_one_mesh; /* alone */
} edit_kind;

static void print_row(const char *name, const double ms[2], int digits) {
  printf("| %s |", name);
  for (int k = 0; k < 2; ++k) ms[k] < 0 ? printf(" |") : printf(" %.*f |", digits, ms[k]);
  printf("\n");
}

int main(int argc, char **argv) {
  const uint32_t triangles = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 3000000;
  by_cpu = argc > 2 && strcmp(argv[2], "cpu") == 0;
  static const edit_kind edits[] = {
      {"nothing", &nothing, 0},
      {"a luminaire dimmed", &dim, 0},
      {"its colour", &colour, 0},
      {"a luminaire aimed", &aim, 0},
      {"the camera moved", &look, 0},
      {"a material", &paint, 0},
      {"an instance moved", &move, 0},
      {"the instance of the one mesh moved", &move_large, 1},
      {"vertices of a mesh", &bend, 0},
      {"an instance replaced", &replace, 0}};
  enum { EDITS = sizeof edits / sizeof *edits };
  double ms[EDITS][2], first_ms[2], first_move_ms[2], start_ms[2][TIMES][2];
  static const ups_method methods[2] = {UPS_METHOD_PATH_TRACING, UPS_METHOD_AUTO};
  for (int k = 0; k < 2; ++k) {
    hall h = make_hall(triangles, k == 0 ? 1 : 5000);
    first_ms[k] = 1000 * h.first_s;
    move(&h, ROUNDS);
    first_move_ms[k] = 1000 * commit_s(&h);
    for (int e = 0; e < EDITS; ++e) ms[e][k] = k == 1 && edits[e].of_one_mesh ? -1 : measure(&h, edits[e].edit);
    for (int m = 0; m < 2; ++m) {
      double times[TIMES];
      measure_start(&h, methods[m], times);
      for (int t = 0; t < TIMES; ++t) start_ms[m][t][k] = times[t];
    }
    free_hall(&h);
  }
  printf("| ms, %u triangles | in one mesh | in 5000 things |\n|---|---|---|\n", triangles);
  print_row("first commit", first_ms, 0);
  print_row("the first edit, an instance moved", first_move_ms, 2);
  for (int e = 0; e < EDITS; ++e) print_row(edits[e].name, ms[e], 2);
  print_row("from a commit until `ups_job_start` has returned", start_ms[1][STARTED], 2);
  print_row("until the first path, `UPS_METHOD_PATH_TRACING`", start_ms[0][PREPARED], 1);
  print_row("until the first iteration after the pilots, `UPS_METHOD_AUTO`", start_ms[1][PREPARED], 1);
  print_row("until it has ended, of 64 x 64 pixels and 100 meters", start_ms[1][FIRST], 0);
  return 0;
}
