/* What a CAD program does with a scene that it keeps: an L-shaped room, ten luminaires, two grids, a camera. One
 * luminaire is moved, dimmed, aimed and removed; each is one call and a commit, where a program that describes all anew
 * makes a call for each thing. Prints what either takes, and fails where the light of the edited scene has not the same
 * bits as that of a new one. Calls are those that have a status.
 *
 *   edits_c
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <ups/ups.h>

enum { LUMINAIRES = 10, METERS = 20, WIDTH = 32, HEIGHT = 24 };

/* What is in the room, and the ids of it in the scene that was described last. */
typedef struct {
  ups_context *context;
  ups_profile *profile;
  double places[LUMINAIRES][12];
  float dimming[LUMINAIRES];
  int removed[LUMINAIRES];
  ups_luminaire_id ids[LUMINAIRES];
  ups_sensor_id near, far, camera;
} room;

typedef struct {
  ups_meter_reading near[METERS], far[METERS];
  float image[3 * WIDTH * HEIGHT];
} light;

static int calls;

static void check(ups_status status) {
  ++calls;
  if (status >= 0) return;
  fprintf(stderr, "%s: %s\n", ups_status_name(status), ups_last_error());
  exit(1);
}

static double now_ms(void) {
  struct timespec t;
  timespec_get(&t, TIME_UTC);
  return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

/* At a point, turned about Y: 3x4, row-major. */
static void place(double m[12], double x, double y, double z, double tilt_rad) {
  const double c = cos(tilt_rad), s = sin(tilt_rad), at[12] = {c, 0, s, x, 0, 1, 0, y, -s, 0, c, z};
  memcpy(m, at, sizeof at);
}

static void furnish(room *r, ups_context *context, ups_profile *profile) {
  memset(r, 0, sizeof *r);
  r->context = context, r->profile = profile;
  for (int i = 0; i < LUMINAIRES; ++i) {
    place(r->places[i], i < 6 ? 1 + i : 1, i < 6 ? 1 : i - 4, 2.6, 0);
    r->dimming[i] = 1;
  }
}

/* ---- all anew ---- */

/* [anew] */
/* 7 x 2 m along X and 2 x 6.5 m along Y share a corner; 2.7 m high. */
static void add_walls(ups_scene *scene) {
  static const float outline[6][2] = {{0, 0}, {7, 0}, {7, 2}, {2, 2}, {2, 6.5f}, {0, 6.5f}};
  float positions[3 * 12];
  uint32_t indices[60], *next = indices;
  for (int i = 0; i < 12; ++i) {
    memcpy(positions + 3 * i, outline[i % 6], sizeof outline[0]);
    positions[3 * i + 2] = i < 6 ? 0 : 2.7f;
  }
  for (uint32_t i = 0; i < 4; ++i) {
    const uint32_t slabs[6] = {0, i + 1, i + 2, 6, i + 8, i + 7}; /* of the floor and the ceiling */
    memcpy(next, slabs, sizeof slabs), next += 6;
  }
  for (uint32_t a = 0; a < 6; ++a) {
    const uint32_t b = (a + 1) % 6, wall[6] = {a, a + 6, b + 6, a, b + 6, b};
    memcpy(next, wall, sizeof wall), next += 6;
  }
  ups_material_desc white;
  ups_mesh_desc mesh;
  ups_instance_desc walls;
  ups_instance_id id;
  ups_material_desc_init(&white, sizeof white);
  white.reflectance_rgb[0] = white.reflectance_rgb[1] = white.reflectance_rgb[2] = 0.6f;
  ups_mesh_desc_init(&mesh, sizeof mesh);
  check(ups_scene_add_material(scene, &white, &mesh.material));
  mesh.positions_m = positions, mesh.vertex_count = 12;
  mesh.indices = indices, mesh.triangle_count = 20;
  ups_instance_desc_init(&walls, sizeof walls);
  check(ups_scene_add_mesh(scene, &mesh, &walls.mesh));
  check(ups_scene_add_instance(scene, &walls, &id));
}

static ups_sensor_id add_grid(ups_scene *scene, double x, double y) {
  double positions[3 * METERS];
  float normals[3 * METERS] = {0};
  for (int i = 0; i < METERS; ++i) {
    const double at[3] = {x + 0.3 * (i % 5), y + 0.3 * (i / 5), 0.75};
    memcpy(positions + 3 * i, at, sizeof at);
    normals[3 * i + 2] = 1;
  }
  ups_meter_desc grid;
  ups_sensor_id id;
  ups_meter_desc_init(&grid, sizeof grid);
  grid.count = METERS, grid.positions_m = positions, grid.normals = normals;
  check(ups_scene_add_meters(scene, &grid, &id));
  return id;
}

/* The whole room as a new scene, committed. */
static ups_scene *describe(room *r) {
  ups_scene *scene;
  check(ups_scene_create(r->context, &scene));
  add_walls(scene);
  for (int i = 0; i < LUMINAIRES; ++i) {
    if (r->removed[i]) continue;
    ups_luminaire_desc luminaire;
    ups_luminaire_desc_init(&luminaire, sizeof luminaire);
    luminaire.profile = r->profile, luminaire.dimming = r->dimming[i];
    memcpy(luminaire.to_world, r->places[i], sizeof r->places[i]);
    check(ups_scene_add_luminaire(scene, &luminaire, &r->ids[i]));
  }
  r->near = add_grid(scene, 4, 0.5);
  r->far = add_grid(scene, 0.4, 4);
  static const double view[12] = {0, 0, -1, 0.5, -1, 0, 0, 1, 0, 1, 0, 1.5}; /* along +X, +Z up */
  ups_camera_desc camera;
  ups_camera_desc_init(&camera, sizeof camera);
  camera.width = WIDTH, camera.height = HEIGHT;
  memcpy(camera.to_world, view, sizeof view);
  check(ups_scene_add_camera(scene, &camera, &r->camera));
  check(ups_scene_commit(scene));
  return scene;
}
/* [end] */

/* ---- edits, and the same in what is described anew ---- */

static void move(ups_scene *scene, room *r) {
  check(ups_scene_set_luminaire_transform(scene, r->ids[3], r->places[3]));
}
static void dim(ups_scene *scene, room *r) { check(ups_scene_set_dimming(scene, r->ids[3], r->dimming[3])); }
static void take_away(ups_scene *scene, room *r) { check(ups_scene_remove_luminaire(scene, r->ids[3])); }

static void render(const ups_scene *scene, const room *r, light *out) {
  ups_render_desc d;
  ups_result *result;
  ups_render_desc_init(&d, sizeof d);
  d.iteration_count = 2, d.light_paths_per_iteration = 2048, d.seed = 11;
  check(ups_render(scene, &d, &result));
  check(ups_result_read_meters(result, r->near, out->near, METERS));
  check(ups_result_read_meters(result, r->far, out->far, METERS));
  check(ups_result_read_image(result, r->camera, UPS_CHANNEL_LUMINANCE_RGB, out->image, 0, sizeof out->image));
  ups_result_destroy(result);
}

/* kept: what its scene was described from, with its ids; both rooms are as the edit leaves them. */
static int show(const char *what, ups_scene *scene, room *kept, room *other, void (*edit)(ups_scene *, room *)) {
  static light edited, described;
  double start = now_ms();
  calls = 0;
  edit(scene, kept);
  check(ups_scene_commit(scene));
  const double edited_ms = now_ms() - start;
  const int edit_calls = calls;
  render(scene, kept, &edited);
  start = now_ms();
  calls = 0;
  ups_scene *anew = describe(other);
  const double described_ms = now_ms() - start;
  const int all_calls = calls;
  render(anew, other, &described);
  ups_scene_destroy(anew);
  const int same = memcmp(&edited, &described, sizeof edited) == 0;
  printf("%-7s %d calls, %.1f ms; anew %d calls, %.1f ms; %6.1f lx, %6.1f lx; %s\n", what, edit_calls, edited_ms,
         all_calls, described_ms, (double)edited.near[7].illuminance_lx, (double)edited.far[7].illuminance_lx,
         same ? "the same bits" : "OTHER BITS");
  return same;
}

int main(void) {
  static const float c_deg[1] = {0}, gamma_deg[4] = {0, 30, 60, 90}, intensity_cd[4] = {1000, 740, 190, 0};
  static room kept, other;
  ups_context *context;
  ups_profile_desc d;
  ups_profile *profile;
  check(ups_context_create(NULL, &context));
  ups_profile_desc_init(&d, sizeof d);
  d.c_deg = c_deg, d.c_count = 1, d.gamma_deg = gamma_deg, d.gamma_count = 4, d.intensity_cd = intensity_cd;
  check(ups_profile_create(context, &d, &profile));
  furnish(&kept, context, profile), furnish(&other, context, profile);
  ups_scene *scene = describe(&kept);
  place(kept.places[3], 4.5, 0.8, 2.4, 0), place(other.places[3], 4.5, 0.8, 2.4, 0);
  int same = show("move", scene, &kept, &other, &move);
  kept.dimming[3] = other.dimming[3] = 0.5f;
  same &= show("dim", scene, &kept, &other, &dim);
  place(kept.places[3], 4.5, 0.8, 2.4, 0.6), place(other.places[3], 4.5, 0.8, 2.4, 0.6);
  same &= show("aim", scene, &kept, &other, &move);
  other.removed[3] = 1;
  same &= show("remove", scene, &kept, &other, &take_away);
  ups_scene_destroy(scene);
  ups_profile_destroy(profile);
  ups_context_destroy(context);
  return same ? 0 : 1;
}
