// The room of samples/c in C++17: handles that free themselves, a photometric file, a job whose progress is shown.
//
//   room_cpp [file.ies]        without a file: a downlight that is written below
#include <ups/ups.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Destroy {
  void operator()(ups_context *p) const { ups_context_destroy(p); }
  void operator()(ups_profile *p) const { ups_profile_destroy(p); }
  void operator()(ups_scene *p) const { ups_scene_destroy(p); }
  void operator()(ups_job *p) const { ups_job_destroy(p); }
  void operator()(ups_result *p) const { ups_result_destroy(p); }
};
template <typename T>
using Handle = std::unique_ptr<T, Destroy>;

// Failures become exceptions; TIMEOUT and CANCELLED are answers.
ups_status check(ups_status status) {
  if (status < 0) throw std::runtime_error(std::string(ups_status_name(status)) + ": " + ups_last_error());
  return status;
}

// The handle that `call` writes to its argument.
template <typename T, typename Call>
Handle<T> make(Call call) {
  T *handle = nullptr;
  check(call(&handle));
  return Handle<T>(handle);
}

const std::string downlight_ies =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2026-01-01\n[MANUFAC] UPS samples\nTILT=NONE\n"
    "1 -1 1 10 1 1 2 0 0 0\n"
    "1 1 20\n"
    "0 10 20 30 40 50 60 70 80 90\n"
    "0\n"
    "1000 970 880 740 560 370 190 70 15 0\n";

std::string read_file(const char *path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(std::string("cannot read ") + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A quad of four corners, counter-clockwise from its front, of a matte material.
void add_quad(ups_scene *scene, const std::array<float, 12> &corners, float reflectance) {
  const std::array<uint32_t, 6> indices = {0, 1, 2, 0, 2, 3};
  ups_material_desc material;
  ups_material_desc_init(&material, sizeof material);
  for (float &r : material.reflectance_rgb) r = reflectance;
  ups_mesh_desc mesh;
  ups_mesh_desc_init(&mesh, sizeof mesh);
  check(ups_scene_add_material(scene, &material, &mesh.material));
  mesh.vertex_count = 4;
  mesh.triangle_count = 2;
  mesh.positions_m = corners.data();
  mesh.indices = indices.data();
  ups_instance_desc instance;
  ups_instance_desc_init(&instance, sizeof instance);
  check(ups_scene_add_mesh(scene, &mesh, &instance.mesh));
  ups_instance_id id;
  check(ups_scene_add_instance(scene, &instance, &id));
}

void add_room(ups_scene *scene, float x, float y, float z) {
  add_quad(scene, {0, 0, 0, x, 0, 0, x, y, 0, 0, y, 0}, 0.2f);  // floor
  add_quad(scene, {0, 0, z, 0, y, z, x, y, z, x, 0, z}, 0.8f);  // ceiling
  add_quad(scene, {0, 0, 0, 0, 0, z, x, 0, z, x, 0, 0}, 0.5f);
  add_quad(scene, {0, y, 0, x, y, 0, x, y, z, 0, y, z}, 0.5f);
  add_quad(scene, {0, 0, 0, 0, y, 0, 0, y, z, 0, 0, z}, 0.5f);
  add_quad(scene, {x, 0, 0, x, 0, z, x, y, z, x, y, 0}, 0.5f);
}

ups_sensor_id add_meters(ups_scene *scene, const std::vector<double> &positions) {
  std::vector<float> normals(positions.size(), 0.0f);
  for (size_t i = 2; i < normals.size(); i += 3) normals[i] = 1;
  ups_meter_desc desc;
  ups_meter_desc_init(&desc, sizeof desc);
  desc.count = static_cast<uint32_t>(positions.size() / 3);
  desc.positions_m = positions.data();
  desc.normals = normals.data();
  ups_sensor_id id;
  check(ups_scene_add_meters(scene, &desc, &id));
  return id;
}

Handle<ups_result> render_with_progress(const ups_scene *scene, const ups_render_desc &desc) {
  const auto job = make<ups_job>([&](auto out) { return ups_job_start(scene, &desc, out); });
  ups_status status;
  do {
    status = check(ups_job_wait(job.get(), 100));
    ups_progress progress;
    progress.struct_size = sizeof progress;
    check(ups_job_poll(job.get(), &progress));
    std::fprintf(stderr, "\r%3.0f %%, %u iterations, %.1f s ", 100 * progress.fraction, progress.iterations_done,
                 progress.elapsed_s);
  } while (status == UPS_TIMEOUT);
  std::fprintf(stderr, "\n");
  return make<ups_result>([&](auto out) { return ups_job_result(job.get(), out); });
}

int run(const char *path) {
  const auto context = make<ups_context>([](auto out) { return ups_context_create(nullptr, out); });
  const auto scene = make<ups_scene>([&](auto out) { return ups_scene_create(context.get(), out); });
  add_room(scene.get(), 4, 3, 2.6f);

  const std::string file = path ? read_file(path) : downlight_ies;
  const auto profile = make<ups_profile>([&](auto out) {
    return ups_profile_parse(context.get(), file.data(), file.size(), UPS_PROFILE_AUTO, out);
  });
  ups_luminaire_desc luminaire;
  ups_luminaire_desc_init(&luminaire, sizeof luminaire);
  luminaire.profile = profile.get();
  luminaire.to_world[3] = 2;
  luminaire.to_world[7] = 1.5;
  luminaire.to_world[11] = 2.5;
  ups_luminaire_id luminaire_id;
  check(ups_scene_add_luminaire(scene.get(), &luminaire, &luminaire_id));

  std::vector<double> positions;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 8; ++column)
      positions.insert(positions.end(), {(column + 0.5) * 4 / 8, (row + 0.5) * 3 / 6, 0.75});
  const ups_sensor_id meters = add_meters(scene.get(), positions);
  check(ups_scene_commit(scene.get()));

  ups_render_desc desc;
  ups_render_desc_init(&desc, sizeof desc);
  desc.iteration_count = 16;
  desc.seed = 7;
  const auto result = render_with_progress(scene.get(), desc);
  std::vector<ups_meter_reading> readings(positions.size() / 3);
  check(ups_result_read_meters(result.get(), meters, readings.data(), readings.size()));
  for (size_t i = 0; i < readings.size(); ++i)
    std::printf("%.3f %.3f  %7.1f lx, within %.1f lx\n", positions[3 * i], positions[3 * i + 1],
                readings[i].illuminance_lx, readings[i].error_bound_lx);

  // The same seed and the same iterations give the same bits, whoever waits for them.
  const auto again = make<ups_result>([&](auto out) { return ups_render(scene.get(), &desc, out); });
  std::vector<ups_meter_reading> same(readings.size());
  check(ups_result_read_meters(again.get(), meters, same.data(), same.size()));
  if (std::memcmp(readings.data(), same.data(), same.size() * sizeof same[0]) != 0)
    throw std::runtime_error("two renders with the same seed differ");
  return 0;
}

}  // namespace

int main(int argc, char **argv) {
  try {
    return run(argc > 1 ? argv[1] : nullptr);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
