// The room of samples/c in C++17: handles that free themselves, a photometric file, a job whose progress is shown.
//
//   room_cpp [file.ies]        without a file: a downlight that is written below
#include <ups/ups.hpp>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

namespace {

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
void add_quad(ups::Scene &scene, const std::vector<float> &corners, float reflectance) {
  const std::vector<std::uint32_t> indices = {0, 1, 2, 0, 2, 3};
  const ups_material_id material = scene.add_material(ups::MaterialDesc(reflectance));
  scene.add_instance({scene.add_mesh({corners, indices, material})});
}

void add_room(ups::Scene &scene, float x, float y, float z) {
  add_quad(scene, {0, 0, 0, x, 0, 0, x, y, 0, 0, y, 0}, 0.2f);  // floor
  add_quad(scene, {0, 0, z, 0, y, z, x, y, z, x, 0, z}, 0.8f);  // ceiling
  add_quad(scene, {0, 0, 0, 0, 0, z, x, 0, z, x, 0, 0}, 0.5f);
  add_quad(scene, {0, y, 0, x, y, 0, x, y, z, 0, y, z}, 0.5f);
  add_quad(scene, {0, 0, 0, 0, y, 0, 0, y, z, 0, 0, z}, 0.5f);
  add_quad(scene, {x, 0, 0, x, 0, z, x, y, z, x, y, 0}, 0.5f);
}

ups::Result render_with_progress(const ups::Scene &scene, const ups::RenderDesc &desc) {
  const ups::Job job = scene.start(desc);
  ups_status status;
  do {
    status = job.wait(std::chrono::milliseconds(100));
    const ups_progress progress = job.poll();
    std::fprintf(stderr, "\r%3.0f %%, %u iterations, %.1f s ", 100 * static_cast<double>(progress.fraction),
                 progress.iterations_done, progress.elapsed_s);
  } while (status == UPS_TIMEOUT);
  std::fprintf(stderr, "\n");
  return job.result();
}

void run(const char *path) {
  const ups::Context context;
  ups::Scene scene(context);
  add_room(scene, 4, 3, 2.6f);
  const ups::Profile profile = ups::Profile::parse(context, path ? read_file(path) : downlight_ies);
  scene.add_luminaire({profile, ups::Transform::translation(2, 1.5, 2.5)});

  std::vector<double> positions;
  std::vector<float> normals;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 8; ++column) {
      positions.insert(positions.end(), {(column + 0.5) * 4 / 8, (row + 0.5) * 3 / 6, 0.75});
      normals.insert(normals.end(), {0, 0, 1});
    }
  const ups_sensor_id meters = scene.add_meters({positions, normals});
  scene.commit();

  ups::RenderDesc desc;
  desc.iteration_count = 16;
  desc.seed = 7;
  const auto readings = render_with_progress(scene, desc).read_meters(meters);
  for (std::size_t i = 0; i < readings.size(); ++i)
    std::printf("%.3f %.3f  %7.1f lx, within %.1f lx\n", positions[3 * i], positions[3 * i + 1],
                static_cast<double>(readings[i].illuminance_lx), static_cast<double>(readings[i].error_bound_lx));

  // The same seed and the same iterations give the same bits, whoever waits for them.
  const auto same = scene.render(desc).read_meters(meters);
  if (std::memcmp(readings.data(), same.data(), same.size() * sizeof same[0]) != 0)
    throw std::runtime_error("two renders with the same seed differ");
}

}  // namespace

int main(int argc, char **argv) {
  try {
    run(argc > 1 ? argv[1] : nullptr);
    return 0;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
