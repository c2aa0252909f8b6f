/* What a CAD program does while its user works: an L-shaped room, ten luminaires, two grids of meters, a camera. The user
 * moves, aims, dims and removes; each edit is committed, a render starts, and the lux on both grids are shown as soon as
 * there are any. Dimming needs neither commit nor render: the readings of each luminaire apart are weighed anew.
 *
 *   interactive_c [ms]         how long each step is looked at, 300
 *
 * Headless: prints a line a step, with what it took. Fails where dimmed readings are not those of a dimmed render.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <ups/ups.h>

enum { LUMINAIRES = 10, GRIDS = 2, METERS = 30 };

typedef struct {
  ups_context *context;
  ups_scene *scene;
  ups_instance_id desk;
  ups_luminaire_id luminaires[LUMINAIRES];
  float dimming[LUMINAIRES]; /* the program's own: the scene's stays 1 */
  ups_sensor_id grids[GRIDS], camera;
  ups_result *result;
} app;

static void check(ups_status status) {
  if (status >= 0) return;
  fprintf(stderr, "%s: %s\n", ups_status_name(status), ups_last_error());
  exit(1);
}

static double now_ms(void) {
  struct timespec t;
  timespec_get(&t, TIME_UTC);
  return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static void place(double m[12], double x, double y, double z, double tilt_rad) {
  const double c = cos(tilt_rad), s = sin(tilt_rad), at[12] = {c, 0, s, x, 0, 1, 0, y, -s, 0, c, z};
  memcpy(m, at, sizeof at);
}

/* ---- the room ---- */

/* An upright wall, or a slab, from its corners. */
static ups_instance_id add_quad(app *a, ups_material_id material, const float corners[12]) {
  static const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
  ups_mesh_desc mesh;
  ups_instance_desc instance;
  ups_instance_id id;
  ups_mesh_desc_init(&mesh, sizeof mesh);
  mesh.vertex_count = 4, mesh.triangle_count = 2, mesh.material = material;
  mesh.positions_m = corners, mesh.indices = indices;
  ups_instance_desc_init(&instance, sizeof instance);
  check(ups_scene_add_mesh(a->scene, &mesh, &instance.mesh));
  check(ups_scene_add_instance(a->scene, &instance, &id));
  return id;
}

static ups_material_id add_matte(app *a, float reflectance) {
  ups_material_desc d;
  ups_material_id id;
  ups_material_desc_init(&d, sizeof d);
  d.reflectance_rgb[0] = d.reflectance_rgb[1] = d.reflectance_rgb[2] = reflectance;
  check(ups_scene_add_material(a->scene, &d, &id));
  return id;
}

/* 8 m x 6 m without the quarter x > 4, y > 3; 2.8 m high. */
static void add_room(app *a) {
  static const float plan[6][2] = {{0, 0}, {8, 0}, {8, 3}, {4, 3}, {4, 6}, {0, 6}}, height = 2.8f;
  const ups_material_id white = add_matte(a, 0.7f), wall = add_matte(a, 0.5f), floor = add_matte(a, 0.2f);
  for (int i = 0; i < 6; ++i) {
    const float *p = plan[i], *q = plan[(i + 1) % 6];
    const float corners[12] = {p[0], p[1], 0, q[0], q[1], 0, q[0], q[1], height, p[0], p[1], height};
    add_quad(a, wall, corners);
  }
  for (int top = 0; top < 2; ++top) {
    const float z = top ? height : 0;
    const float along[12] = {0, 0, z, 8, 0, z, 8, 3, z, 0, 3, z}, across[12] = {0, 3, z, 4, 3, z, 4, 6, z, 0, 6, z};
    add_quad(a, top ? white : floor, along);
    add_quad(a, top ? white : floor, across);
  }
  const float desk[12] = {-0.8f, -0.4f, 0, 0.8f, -0.4f, 0, 0.8f, 0.4f, 0, -0.8f, 0.4f, 0};
  a->desk = add_quad(a, white, desk);
}

static void add_luminaires(app *a) {
  static const double at[LUMINAIRES][2] = {{1, 0.8}, {3, 0.8}, {5, 0.8}, {7, 0.8}, {1, 2.3},
                                           {3, 2.3}, {5, 2.3}, {7, 2.3}, {1, 4.8}, {3, 4.8}};
  const float c = 0, gamma[4] = {0, 30, 60, 90}, intensity[4] = {1100, 900, 300, 0};
  ups_profile_desc p;
  ups_luminaire_desc d;
  ups_profile *profile;
  ups_profile_desc_init(&p, sizeof p);
  p.c_count = 1, p.gamma_count = 4, p.c_deg = &c, p.gamma_deg = gamma, p.intensity_cd = intensity;
  p.opening_shape = UPS_OPENING_RECTANGLE, p.opening_m[0] = p.opening_m[1] = 0.5f;
  check(ups_profile_create(a->context, &p, &profile));
  ups_luminaire_desc_init(&d, sizeof d);
  d.profile = profile;
  for (int i = 0; i < LUMINAIRES; ++i) {
    place(d.to_world, at[i][0], at[i][1], 2.75, 0);
    check(ups_scene_add_luminaire(a->scene, &d, &a->luminaires[i]));
    a->dimming[i] = 1;
  }
  ups_profile_destroy(profile);
}

static void add_sensors(app *a) {
  static const double corner[GRIDS][2] = {{0.5, 0.5}, {0.5, 3.5}}, step[GRIDS][2] = {{1.4, 0.5}, {0.6, 0.5}};
  ups_camera_desc camera;
  for (int g = 0; g < GRIDS; ++g) {
    double at[3 * METERS];
    float up[3 * METERS];
    ups_meter_desc d;
    for (int i = 0; i < METERS; ++i) {
      at[3 * i] = corner[g][0] + step[g][0] * (i % 6), at[3 * i + 1] = corner[g][1] + step[g][1] * (i / 6);
      at[3 * i + 2] = 0.85;
      up[3 * i] = up[3 * i + 1] = 0, up[3 * i + 2] = 1;
    }
    ups_meter_desc_init(&d, sizeof d);
    d.count = METERS, d.positions_m = at, d.normals = up;
    check(ups_scene_add_meters(a->scene, &d, &a->grids[g]));
  }
  ups_camera_desc_init(&camera, sizeof camera);
  camera.width = 64, camera.height = 48;
  place(camera.to_world, 2, 3, 2.5, 0);
  check(ups_scene_add_camera(a->scene, &camera, &a->camera));
}

/* ---- what is shown ---- */

/* Mean of a grid, lx, by the program's dimming. */
static double mean_lx(const app *a, int grid) {
  ups_meter_reading readings[METERS];
  ups_source_info source;
  uint32_t count;
  double sum = 0;
  check(ups_result_get_source_count(a->result, &count));
  for (uint32_t s = 0; s < count; ++s) {
    float dimming = 0;
    source.struct_size = sizeof source;
    check(ups_result_get_source(a->result, s, &source));
    for (int i = 0; i < LUMINAIRES; ++i)
      if (a->luminaires[i].v == source.id) dimming = a->dimming[i];
    check(ups_result_read_source_meters(a->result, s, a->grids[grid], readings, METERS));
    for (int i = 0; i < METERS; ++i) sum += (double)(dimming * readings[i].illuminance_lx) / METERS;
  }
  return sum;
}

static void show(const app *a, const char *what, double commit_ms, double start_ms, double first_ms) {
  double lx[GRIDS];
  const double before = now_ms();
  for (int g = 0; g < GRIDS; ++g) lx[g] = mean_lx(a, g);
  printf("%-26s %7.2f %7.2f %7.1f %7.3f   %7.1f %7.1f\n", what, commit_ms, start_ms, first_ms, now_ms() - before, lx[0],
         lx[1]);
}

static void take_result(app *a, const ups_job *job) {
  ups_result *result;
  check(ups_job_result(job, &result));
  ups_result_destroy(a->result);
  a->result = result;
}

/* Commits, starts a render, shows its first numbers, and after look_ms those that it has by then. */
static void commit_and_look(app *a, const char *what, double look_ms) {
  ups_render_desc d;
  ups_progress progress;
  ups_job *job;
  const double begin = now_ms();
  check(ups_scene_commit(a->scene));
  const double committed = now_ms();
  ups_render_desc_init(&d, sizeof d);
  d.method = UPS_METHOD_PATH_TRACING; /* a matte room: no pilot that chooses, so the first numbers come sooner */
  d.separation = UPS_SEPARATE_LUMINAIRES;
  d.time_limit_s = 60;
  check(ups_job_start(a->scene, &d, &job));
  const double started = now_ms();
  progress.struct_size = sizeof progress;
  do {
    check(ups_job_wait(job, 1));
    check(ups_job_poll(job, &progress));
  } while (progress.iterations_done == 0 && progress.state == UPS_JOB_RUNNING);
  take_result(a, job);
  show(a, what, committed - begin, started - committed, now_ms() - begin);
  if (look_ms > now_ms() - begin) check(ups_job_wait(job, (uint32_t)(look_ms - (now_ms() - begin))));
  take_result(a, job);
  ups_job_cancel(job);
  ups_job_destroy(job);
}

/* ---- edits ---- */

static void dim(app *a, int luminaire, float dimming, const char *what) {
  a->dimming[luminaire] = dimming;
  show(a, what, 0, 0, 0);
}

/* The readings weighed by the program's dimming are those of a scene that is dimmed so. */
static int agrees_with_dimmed_scene(app *a, double look_ms) {
  double weighed[GRIDS];
  int good = 1;
  for (int g = 0; g < GRIDS; ++g) weighed[g] = mean_lx(a, g);
  for (int i = 0; i < LUMINAIRES; ++i) {
    if (a->luminaires[i].v) check(ups_scene_set_dimming(a->scene, a->luminaires[i], a->dimming[i]));
    a->dimming[i] = 1;
  }
  commit_and_look(a, "the scene itself dimmed", look_ms);
  for (int g = 0; g < GRIDS; ++g) {
    const double lx = mean_lx(a, g);
    good &= fabs(lx - weighed[g]) <= 0.03 * weighed[g]; /* both are noisy */
    printf("grid %d: weighed %.1f lx, rendered %.1f lx\n", g + 1, weighed[g], lx);
  }
  return good;
}

int main(int argc, char **argv) {
  const double look_ms = argc > 1 ? atof(argv[1]) : 300;
  double m[12];
  app a;
  memset(&a, 0, sizeof a);
  check(ups_context_create(NULL, &a.context));
  check(ups_scene_create(a.context, &a.scene));
  add_room(&a);
  add_luminaires(&a);
  add_sensors(&a);
  printf("%-26s %7s %7s %7s %7s   %7s %7s\n", "ms:", "commit", "start", "first", "weigh", "lx 1", "lx 2");
  commit_and_look(&a, "the room as it is", look_ms);
  for (int step = 1; step <= 4; ++step) {
    place(m, 1.5 + 0.5 * step, 1.5, 0.75, 0);
    check(ups_scene_set_transform(a.scene, a.desk, m));
    commit_and_look(&a, "the desk moved", look_ms);
  }
  for (int step = 1; step <= 3; ++step) {
    place(m, 7, 0.8, 2.75, 0.2 * step);
    check(ups_scene_set_luminaire_transform(a.scene, a.luminaires[3], m));
    commit_and_look(&a, "luminaire 4 aimed", look_ms);
  }
  check(ups_scene_remove_luminaire(a.scene, a.luminaires[9]));
  a.luminaires[9].v = 0;
  commit_and_look(&a, "luminaire 10 removed", look_ms);
  dim(&a, 0, 0.5f, "luminaire 1 at 50 %");
  dim(&a, 8, 0.1f, "luminaire 9 at 10 %");
  dim(&a, 3, 0, "luminaire 4 off");
  const int good = agrees_with_dimmed_scene(&a, 2 * look_ms);
  ups_result_destroy(a.result);
  ups_scene_destroy(a.scene);
  ups_context_destroy(a.context);
  if (!good) fprintf(stderr, "the dimmed readings are not those of the dimmed scene\n");
  return good ? 0 : 1;
}
